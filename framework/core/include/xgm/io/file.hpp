// SPDX-License-Identifier: Apache-2.0
// Whole files: read with clear errors, written so that nobody ever sees half of one.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm {

/// All bytes of a file. Throws Error if it is missing, a folder, unreadable, empty or larger than
/// `limit`.
XGM_API std::string read_file(const std::string& file, std::uint64_t limit = UINT64_MAX);

/// The first bytes of a file, `count` at most. Throws Error like read_file.
XGM_API std::string read_head(const std::string& file, std::size_t count);

/// Writes under a temporary name in the same folder and renames it to `file` once it is complete.
/// If `write` throws or the disk is full, no file is left and an old one stays as it was. Throws
/// Error.
XGM_API void write_file(const std::string& file, const std::function<void(std::ostream&)>& write);
XGM_API void write_file(const std::string& file, std::string_view bytes);

/// What a run read, so that its record can be compared with another's.
struct FileIdentity {
  std::uint64_t bytes = 0;
  std::string fnv1a64;  ///< 16 hexadecimal digits
};

/// 64-bit FNV-1a (Fowler, Noll, Vo): tells files apart, but is no protection against forgery.
XGM_API std::uint64_t fnv1a64(std::string_view bytes);
/// Size and hash of a file's content. Throws Error.
XGM_API FileIdentity identify_file(const std::string& file);

}  // namespace xgm
