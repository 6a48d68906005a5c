// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/pair_in_files.hpp"

#include "io/view_in_file.hpp"

namespace xgm {

struct PairInFiles::Files {
  ViewInFile left, right;
  Scaling scaling{};
};

PairInFiles::PairInFiles(const PairFiles& files, const std::string& scratch)
    : files_(new Files{ViewInFile(files.left, files.left_mask, files.no_data, scratch),
                       ViewInFile(files.right, files.right_mask, files.no_data, scratch)}) {
  ViewInFile &left = files_->left, &right = files_->right;
  require_same(left.stored(), right.stored());
  left.look_at_mask(warnings_);
  right.look_at_mask(warnings_);
  left.look_for_marks(warnings_);
  right.look_for_marks(warnings_);
  Extremes values;
  left.look_at_values(values);
  right.look_at_values(values);
  files_->scaling = choose_scaling(left.stored().depth, values);
  if (!files_->scaling.note.empty()) notes_.push_back(files_->scaling.note);
  if (left.planes() != right.planes()) notes_.push_back(kMatchedAsGrey);
}

PairInFiles::PairInFiles(const PairFiles& files, const std::string& scratch, const PairLook& look)
    : files_(
          new Files{ViewInFile(files.left, files.left_mask, files.no_data, scratch, look.left),
                    ViewInFile(files.right, files.right_mask, files.no_data, scratch, look.right),
                    {look.offset, look.gain}}) {
  require_same(files_->left.stored(), files_->right.stored());
}

PairInFiles::~PairInFiles() = default;

PairLook PairInFiles::look() const {
  return {.left = files_->left.look(),
          .right = files_->right.look(),
          .offset = files_->scaling.offset,
          .gain = files_->scaling.gain};
}

cv::Size PairInFiles::size() const { return files_->left.stored().size; }

ImagePair PairInFiles::read(const cv::Rect& window) const {
  ImagePair pair{files_->left.read(window, files_->scaling),
                 files_->right.read(window, files_->scaling)};
  if (pair.base.planes.size() != pair.match.planes.size()) {
    for (Image* image : {&pair.base, &pair.match}) image->planes = {image->grey()};
  }
  return pair;
}

std::optional<double> PairInFiles::masked_share(bool of_match) const {
  return (of_match ? files_->right : files_->left).masked_share();
}

double PairInFiles::held_bytes() const {
  return files_->left.held_bytes() + files_->right.held_bytes();
}

}  // namespace xgm
