// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/cells.hpp"

#include <new>

namespace xgm {

void CellsDeleter::operator()(void* cells) const {
  ::operator delete (cells, std::align_val_t{kCellAlignment});
}

Cells new_cells(std::size_t bytes) {
  return Cells(::operator new (bytes, std::align_val_t{kCellAlignment}));
}

}  // namespace xgm
