// SPDX-License-Identifier: Apache-2.0
// Version of the SDK. CMakeLists.txt reads it from here.
#pragma once

#define XGM_VERSION "0.1.0"
