// SPDX-License-Identifier: Apache-2.0
// What lies beside the library: a build tree or an installation may be moved as a whole.
#pragma once

#include <string>

#include "xgm/base/export.hpp"

namespace xgm {

/// The file that holds this function: a library, or the program. "" if nobody knows.
XGM_API std::string file_of(const void* function);

/// The file that this library was loaded from; the program, if it is linked into it.
XGM_API std::string library_file();

/// The folder of the shipped pipelines: share/xgm/pipelines below the prefix that holds the
/// library's folder. "" if there is none.
XGM_API std::string pipelines_folder();

/// The folder of plugin files that programs load without being asked: xgm/plugins in the library's
/// folder. "" if there is none; Registry::load_path() takes it as it is.
XGM_API std::string plugins_folder();

}  // namespace xgm
