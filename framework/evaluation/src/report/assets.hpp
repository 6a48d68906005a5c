// SPDX-License-Identifier: Apache-2.0
// The files of the folder page, built into the library.
#pragma once

namespace xgm::report {

extern const char* const kStyle;    ///< all *.css
extern const char* const kViewer;   ///< viewer.html
extern const char* const kProgram;  ///< all *.js in the order of their names

}  // namespace xgm::report
