// SPDX-License-Identifier: Apache-2.0
// Epipolar curves of the whole image, followed piece by piece from one camera to the other and
// back, become rows: Oh, Lee, Toth, Grejner-Brzezinska, Lee: A piecewise approach to epipolar
// resampling of pushbroom satellite images based on RPC (PE&RS 76(12), 2010). A pixel's point at
// one height is seen by the other camera in a pixel, whose point at another height is seen by the
// first camera in the next pixel of the curve, and so on. Curves begin on a line across them
// through the middle of the window. Nodes of a curve get one y, and ascending x in equal steps,
// those of the other image half a step later: so the middle height has disparity 0 everywhere, and
// disparities grow with height alike in the whole image. The inverse is found on the grid of the
// nodes itself, by Newton's iteration. Nearest neighbours weighted by their inverse distances
// reproduce no linear function exactly: among nodes 1 px apart they are off by up to 0.1 px.
#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/rectification/piecewise/node_map.hpp"
#include "plugins/rectification/virtual_matches/matches.hpp"
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

/// Follows epipolar curves from one node to the next. Where a camera finds no ground, curves go
/// straight on.
class Tracer {
 public:
  Tracer(const RpcCamera& base, const RpcCamera& match, const HeightInterval& heights)
      : base_(base), match_(match), heights_(heights) {}

  /// To the other image, by way of the height at which a step forward begins, or one backward.
  std::optional<cv::Point2d> across(cv::Point2d base, bool forward) const {
    return transfer(base_, match_, base, forward ? heights_.max : heights_.min);
  }
  std::optional<cv::Point2d> back(cv::Point2d match, bool forward) const {
    return transfer(match_, base_, match, forward ? heights_.min : heights_.max);
  }
  std::optional<cv::Point2d> step(cv::Point2d base, bool forward) const {
    const auto there = across(base, forward);
    return there ? back(*there, forward) : std::nullopt;
  }

 private:
  static std::optional<cv::Point2d> transfer(const RpcCamera& from, const RpcCamera& to,
                                             cv::Point2d pixel, double height) {
    const auto point = from.localize(pixel, height);
    if (!point) return std::nullopt;
    const cv::Point2d there = to.project(*point);
    return std::isfinite(there.x) && std::isfinite(there.y) ? std::optional(there) : std::nullopt;
  }

  const RpcCamera& base_;
  const RpcCamera& match_;
  HeightInterval heights_;  // swapped if that is what goes to the right
};

/// How curves lie in the window.
struct Layout {
  cv::Point2d middle, along, across;  ///< directions of length 1, to the right and down
  double length = 0;                  ///< of a step of the curve in the middle, px
  HeightInterval heights;             ///< of its nodes; `max` is where steps to the right begin
};

/// Heights around the middle between which a step has about the wanted length.
Layout find_layout(const SatelliteImage& base, const SatelliteImage& match, const cv::Rect& window,
                   const HeightInterval& heights, double wanted) {
  const double middle = (heights.min + heights.max) / 2;
  Layout layout;
  layout.middle = (cv::Point2d(window.tl()) + cv::Point2d(window.br()) - cv::Point2d(1, 1)) / 2;
  const auto step_of = [&](double half) {
    layout.heights = {middle - half, middle + half};
    const auto next = Tracer(base.camera, match.camera, layout.heights).step(layout.middle, true);
    return next ? *next - layout.middle : cv::Point2d();
  };
  const HeightInterval known = common_heights(base.camera, match.camera);
  const double limit = std::max((known.max - known.min) / 2, (heights.max - heights.min) / 2);
  constexpr double kTry = 5;  // m
  const double per_metre = cv::norm(step_of(kTry)) / kTry;
  cv::Point2d step = step_of(std::min(wanted / per_metre, limit));
  if (step == cv::Point2d()) step = step_of(kTry);
  if (step.x < 0) {
    std::swap(layout.heights.min, layout.heights.max);
    step = -step;
  }
  layout.length = cv::norm(step);
  layout.along = step / layout.length;
  layout.across = {-layout.along.y, layout.along.x};
  return layout;
}

/// Continues a curve from its middle node to both ends. `next(i, direction)` is the node behind the
/// one at `i`; where there is none, the curve goes on as it went before, at first by `step`.
template <class Next>
void follow(cv::Vec2d* nodes, int count, cv::Vec2d step, const Next& next) {
  for (const int direction : {1, -1}) {
    cv::Vec2d move = direction * step;
    for (int i = count / 2 + direction; i >= 0 && i < count; i += direction) {
      const cv::Vec2d& last = nodes[i - direction];
      if (const std::optional<cv::Point2d> found = next(i - direction, direction)) {
        move = cv::Vec2d(found->x, found->y) - last;
      }
      nodes[i] = last + move;
    }
  }
}

/// Nodes of one curve in both images, those of the other one half a step behind. The middle one of
/// the base image is `begin`. False if the cameras do not see it.
bool trace(const Tracer& tracer, cv::Point2d begin, cv::Point2d step, cv::Vec2d* base,
           cv::Vec2d* match, int count) {
  const int middle = count / 2;
  base[middle] = cv::Vec2d(begin.x, begin.y);
  follow(base, count, cv::Vec2d(step.x, step.y),
         [&](int i, int direction) { return tracer.step(cv::Point2d(base[i]), direction > 0); });
  const auto first = tracer.across(cv::Point2d(base[middle]), true);
  const auto second = tracer.across(cv::Point2d(base[middle + 1]), true);
  if (!first || !second) return false;
  match[middle] = cv::Vec2d(first->x, first->y);
  const cv::Point2d move = *second - *first;
  follow(match, count, cv::Vec2d(move.x, move.y), [&](int i, int direction) {
    return tracer.across(cv::Point2d(base[i + direction]), true);
  });
  return true;
}

class PiecewiseGeometry final : public Rectification {
 public:
  PiecewiseGeometry(const SatelliteImage& base, const SatelliteImage& match, const cv::Rect& window,
                    const Layout& layout, const std::vector<VirtualMatch>& matches) {
    find_nodes(base, match, window, layout);
    const cv::Rect shown = frame(*this, matches, window);
    base_.move(-cv::Point2d(shown.tl()));
    match_.move(-cv::Point2d(shown.tl()));
    size_ = shown.size();
    residual_ = residual_of(*this, matches);
  }

  cv::Size size() const override { return size_; }
  cv::Point2d to_base(cv::Point2d rectified) const override { return base_(rectified); }
  cv::Point2d to_match(cv::Point2d rectified) const override { return match_(rectified); }
  cv::Point2d from_base(cv::Point2d pixel) const override { return base_.inverse(pixel); }
  cv::Point2d from_match(cv::Point2d pixel) const override { return match_.inverse(pixel); }
  double residual() const override { return residual_; }

 private:
  void find_nodes(const SatelliteImage& base, const SatelliteImage& match, const cv::Rect& window,
                  const Layout& layout) {
    // Far enough for the corners, and for what lies beside a window at another height.
    double along = 0, across = 0;
    for (const cv::Point2d corner :
         {cv::Point2d(window.tl()), cv::Point2d(window.br()), cv::Point2d(window.x, window.br().y),
          cv::Point2d(window.br().x, window.y)}) {
      const cv::Point2d from = corner - layout.middle;
      along = std::max(along, std::abs(from.dot(layout.along)));
      across = std::max(across, std::abs(from.dot(layout.across)));
    }
    const double step = layout.length;
    const int columns = 2 * (cvCeil(along / step) + 2) + 1,
              rows = 2 * (cvCeil(across / step) + 1) + 1;
    cv::Mat2d here(rows, columns), there(rows, columns);
    const Tracer tracer(base.camera, match.camera, layout.heights);
    std::vector<char> seen(static_cast<std::size_t>(rows));
    parallel_for(0, rows, [&](int row) {
      const cv::Point2d begin = layout.middle + layout.across * ((row - rows / 2) * step);
      seen[static_cast<std::size_t>(row)] =
          trace(tracer, begin, layout.along * step, here[row], there[row], columns);
    });
    if (std::ranges::count(seen, 0) > 0) {
      throw Error(base.file +
                  ": its epipolar curves leave what the cameras were made for; choose a smaller "
                  "window, or rectification affine");
    }
    base_ = NodeMap(here, {0, 0}, {step, step});
    match_ = NodeMap(there, {step / 2, 0}, {step, step});
  }

  NodeMap base_, match_;
  cv::Size size_;
  double residual_ = 0;
};

class Piecewise final : public Rectifier {
 public:
  struct Parameters {
    double step = 100;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("step", p.step,
            "Distance of the nodes in which the epipolar curves are found; it is smaller where the "
            "cameras were made for few heights only.")
        .unit("px")
        .range(10, 1000);
  }

  explicit Piecewise(Parameters parameters) : p_(parameters) {}

  std::shared_ptr<const Rectification> run(const SatelliteImage& base, const SatelliteImage& match,
                                           const cv::Rect& window, const HeightInterval& heights,
                                           const Context& context) const override {
    const auto matches = virtual_matches(base, match, window, heights);
    const Layout layout = find_layout(base, match, window, heights, p_.step);
    auto geometry = std::make_shared<const PiecewiseGeometry>(base, match, window, layout, matches);
    context.figure("residual_px", geometry->residual());
    return geometry;
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Piecewise>(
      "piecewise", "Epipolar curves, followed piece by piece, as rows: for whole images.",
      "Oh, Lee, Toth, Grejner-Brzezinska, Lee: A piecewise approach to epipolar resampling of "
      "pushbroom satellite images based on RPC, PE&RS 76(12), 2010");
}
