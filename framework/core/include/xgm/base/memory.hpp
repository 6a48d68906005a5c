// SPDX-License-Identifier: Apache-2.0
// The memory of this process and of the machine it runs on (Linux).
#pragma once

#include <cstdint>

#include "xgm/base/export.hpp"

namespace xgm {

/// Most memory that this process ever had in use, bytes.
XGM_API std::uint64_t peak_memory();

/// Memory that this process has in use now, bytes; 0 if the system does not say.
XGM_API std::uint64_t resident_memory();

/// The part of it that is read from files: program and libraries.
XGM_API std::uint64_t program_memory();

/// Bytes that can still be taken without swapping, within the limit of the control group that the
/// process runs in. UINT64_MAX if the system does not say.
XGM_API std::uint64_t available_memory();

/// Gives memory that was freed, but that the heap keeps, back to the system.
XGM_API void trim_heap();

/// From here on, asking for more than `bytes` in addition to what is held fails with
/// std::bad_alloc. Without such a limit the system would grant any wish, and end the process
/// without a word when the memory is touched. It holds for the whole process, all of its runs and
/// threads: for programs, not for libraries and plugins.
XGM_API void limit_memory(std::uint64_t bytes);

}  // namespace xgm
