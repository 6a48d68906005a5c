// SPDX-License-Identifier: Apache-2.0
// Reads and writes whole files. Errors are clear, and a file is never visible half-written.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm {

/// The content of a file. Throws Error if the file is missing, a folder, unreadable, empty or
/// larger than `limit` bytes.
XGM_API std::string read_file(const std::string& file, std::uint64_t limit = UINT64_MAX);

/// Why a file cannot be opened, as far as that shows without trying: "no such file", "is a link
/// that leads nowhere", "cannot be opened: Permission denied", ...; "" if nothing stands in the
/// way.
XGM_API std::string why_unreadable(const std::string& file);

/// The first bytes of a file, at most `count`. Throws Error like read_file.
XGM_API std::string read_head(const std::string& file, std::size_t count);

/// Gives the file its name once it is complete. If `write` throws, the disk is full or the process
/// is ended, no new file remains and an existing one is unchanged. Throws Error, also if there is a
/// folder, a device or a pipe of this name.
XGM_API void write_file(const std::string& file, const std::function<void(std::ostream&)>& write);
XGM_API void write_file(const std::string& file, std::string_view bytes);

/// Returns when the file's bytes are on the disk, from where no loss of power takes them. Throws
/// Error.
XGM_API void sync_file(const std::string& file);

/// Removes a file, if it is there. Throws Error.
XGM_API void remove_file(const std::string& file);

/// Identifies a file that a run has read, so that records of runs can be compared.
struct FileIdentity {
  std::uint64_t bytes = 0;
  std::string fnv1a64;  ///< 16 hexadecimal digits
  /// When the file had been modified, ns since 1970; 0 if that was not known, or so short before
  /// that a later change may bear the same time.
  std::int64_t modified = 0;
};

/// 64-bit FNV-1a (Fowler, Noll, Vo). It distinguishes files, but does not protect against forgery.
XGM_API std::uint64_t fnv1a64(std::string_view bytes);
/// The same as 16 hexadecimal digits.
XGM_API std::string hash_text(std::string_view bytes);
/// Size and hash of the content of a file. Throws Error.
XGM_API FileIdentity identify_file(const std::string& file);
/// Whether the file is still as it was: of the same size, and modified at the same time or else
/// with the same hash. A change that keeps both, which takes some effort, is not seen. Throws
/// Error.
XGM_API bool is_still(const std::string& file, const FileIdentity& identity);

}  // namespace xgm
