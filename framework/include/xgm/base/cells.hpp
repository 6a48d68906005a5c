// SPDX-License-Identifier: Apache-2.0
// Memory of volumes: large, aligned, not initialised.
#pragma once

#include <cstddef>
#include <memory>

#include "xgm/base/export.hpp"

namespace xgm {

/// A cache line, and the widest vector.
inline constexpr std::size_t kCellAlignment = 64;

struct XGM_API CellsDeleter {
  void operator()(void* cells) const;
};
using Cells = std::unique_ptr<void, CellsDeleter>;

/// Throws std::bad_alloc if there is no such memory.
XGM_API Cells new_cells(std::size_t bytes);

}  // namespace xgm
