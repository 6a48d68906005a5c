// SPDX-License-Identifier: Apache-2.0
// Rooms with things in them: all kinds of shapes and textures that a matcher may meet.
#include <algorithm>
#include <cmath>

#include "compose.hpp"
#include "xgm/base/random.hpp"

namespace xgm::synthesis {
namespace {

constexpr double kSteepest = 0.3;  // px of disparity per px

class Composer {
 public:
  explicit Composer(const Options& options)
      : options_(options),
        random_(options.seed),
        low_(options.disparities.begin),
        span_(options.disparities.size() - 1),
        width_(options.size.width),
        height_(options.size.height),
        scale_(std::clamp(std::min(width_, height_) / 480, 0.4, 8.0)) {}

  Surfaces run() {
    setting();
    std::array<int, kKinds> deck{};
    for (int i = 0; i < options_.objects; ++i) {
      const int at = i % kKinds;
      if (at == 0) shuffle(deck);
      add_object(deck[static_cast<std::size_t>(at)]);
    }
    return std::move(surfaces_);
  }

 private:
  static constexpr int kKinds = 9;

  void shuffle(std::array<int, kKinds>& deck) {
    for (int i = 0; i < kKinds; ++i) deck[static_cast<std::size_t>(i)] = i;
    for (int i = kKinds - 1; i > 0; --i)
      std::swap(deck[static_cast<std::size_t>(i)],
                deck[static_cast<std::size_t>(random_.integer(0, i))]);
  }

  double real(double low, double high) { return random_.real(low, high); }

  void add(const Shape& shape, Texture::Kind kind) {
    Surface surface;
    surface.shape = shape;
    surface.lit = true;
    Texture& texture = surface.texture;
    texture.kind = kind;
    texture.key = random_.next();
    texture.scale = scale_ * real(0.8, 1.5);
    texture.contrast = real(95, 190);
    const double grey = real(85, 165);
    for (double& level : texture.level) level = grey + (options_.colour ? real(-28, 28) : 0);
    surfaces_.push_back(surface);
  }

  Texture::Kind any_texture() {
    using Kind = Texture::Kind;
    constexpr std::array kinds{Kind::noise,   Kind::noise,  Kind::bricks,
                               Kind::letters, Kind::mosaic, Kind::wood};
    return kinds[static_cast<std::size_t>(random_.integer(0, kinds.size() - 1))];
  }

  /// The lowest row of the scene that either view shows.
  double bottom() const {
    const VerticalShift& shift = options_.faults.vertical;
    double lowest = height_;
    for (const double x : {0.0, width_})
      lowest = std::max(lowest, (height_ - shift.a * x - shift.c) / (1 + shift.b));
    return lowest;
  }

  /// Columns beyond the base image that the match view may show.
  double margin() const { return std::max(std::abs(low_), std::abs(low_ + span_)) + 4; }

  Shape backdrop() {
    Shape shape;
    shape.centre = {(width_ - 1) / 2, (height_ - 1) / 2};
    shape.half = {width_ / 2 + margin(), std::max(bottom(), height_)};
    return shape;
  }

  /// Far surfaces: disparities within the lowest third of the range wherever they can be seen.
  void setting() {
    switch (random_.integer(0, 2)) {
      case 0:
        wall(0);
        floor();
        break;
      case 1:  // the nearer of two walls is seen: a corner
        wall(-1);
        wall(1);
        break;
      default:
        bent_wall();
        if (random_.integer(0, 1) == 0) floor();
    }
  }

  void wall(double direction) {
    Shape shape = backdrop();
    shape.d = low_ + real(0.1, 0.18) * span_;
    const double room = std::min(0.1 * span_, kSteepest * shape.half.x);
    shape.slope_x = (direction == 0 ? real(-1, 1) : direction * real(0.6, 1)) * room / shape.half.x;
    add(shape, direction < 0 ? Texture::Kind::noise : any_texture());
  }

  void bent_wall() {
    Shape shape = backdrop();
    shape.form = Shape::Form::saddle;
    shape.d = low_ + 0.17 * span_;
    const double limit = std::min(0.08 * span_, 0.1 * shape.half.x);
    shape.bend_u = real(-1, 1) * limit;
    shape.bend_v = real(-1, 1) * limit;
    add(shape, any_texture());
  }

  /// Rises from behind the wall to the near end of the range.
  void floor() {
    const double horizon = real(0.3, 0.6) * height_;
    Shape shape = backdrop();
    shape.centre.y = horizon;
    shape.d = low_;
    shape.slope_y = std::min(1.0, real(0.5, 0.85) * span_ / std::max(bottom() + 4 - horizon, 1.0));
    add(shape, any_texture());
  }

  /// A place for an object, and how far its disparities may differ from its centre's.
  Shape place(double smallest, double largest, double& room) {
    Shape shape;
    shape.centre = {real(0.03, 0.97) * width_, real(0.05, 0.95) * height_};
    shape.half = {std::max(0.5, real(smallest, largest) * width_),
                  std::max(0.5, real(1.3 * smallest, 1.4 * largest) * height_)};
    const double share = real(0.25, 0.9);
    shape.d = low_ + share * span_;
    room = 0.9 * std::min(share, 1 - share) * span_;
    return shape;
  }

  /// Turned by up to 2 atan(most): rational functions need no libm.
  void turn(Shape& shape, double limit) {
    const double t = real(-limit, limit);
    shape.axis = {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
  }

  void slant(Shape& shape, double room) {
    const double reach_x =
        std::abs(shape.axis.x) * shape.half.x + std::abs(shape.axis.y) * shape.half.y;
    const double reach_y =
        std::abs(shape.axis.y) * shape.half.x + std::abs(shape.axis.x) * shape.half.y;
    shape.slope_x = real(-1, 1) * std::min(kSteepest, room / 2 / std::max(reach_x, 1.0));
    shape.slope_y = real(-1, 1) * std::min(kSteepest, room / 2 / std::max(reach_y, 1.0));
  }

  /// Of a round body, as deep as it is wide: px of disparity for the far end's distance.
  double roundness(const Shape& shape, double radius, double room) const {
    const double natural = (shape.d - low_ + 0.25 * span_) * radius / (0.9 * std::max(width_, 1.0));
    return std::min(natural, room);
  }

  // Arguments may be computed in any order; random numbers must not.
  void pillar() {
    const double half_length = real(0.15, 0.4);
    column(real(0.03, 0.08) * width_, half_length, 0.15);
  }
  void pole() {
    const double half_length = real(0.25, 0.6);
    column(real(0.5, 2.0) * scale_, half_length, 0.2);
  }

  void add_object(int kind) {
    switch (kind) {
      case 0:
      case 1:
        return card(kind == 0 ? Outline::Kind::rectangle : Outline::Kind::ellipse);
      case 2:
        return ball();
      case 3:
        return pillar();
      case 4:
        return sheet();
      case 5:
        return foliage();
      case 6:
        return pole();
      case 7:
        return wire();
      default:
        return fence();
    }
  }

  void card(Outline::Kind kind) {
    double room = 0;
    Shape shape = place(0.05, 0.15, room);
    shape.outline.kind = kind;
    turn(shape, 0.3);
    slant(shape, room);
    add(shape, any_texture());
  }

  void ball() {
    double room = 0;
    Shape shape = place(0.05, 0.13, room);
    shape.half.y = std::max(0.5, shape.half.x * real(0.8, 1.3));
    shape.form = Shape::Form::ellipsoid;
    shape.depth = roundness(shape, shape.half.x, room);
    if (shape.depth < 0.01) return card(Outline::Kind::ellipse);
    turn(shape, 0.5);
    add(shape, any_texture());
  }

  void column(double radius, double half_length, double tilt) {
    double room = 0;
    Shape shape = place(0.05, 0.1, room);
    shape.half = {std::max(radius, 0.5), std::max(0.5, half_length * height_)};
    turn(shape, tilt);
    slant(shape, 0.6 * room);
    shape.outline.kind = Outline::Kind::rectangle;
    shape.depth = roundness(shape, shape.half.x, 0.4 * room);
    if (shape.depth >= 0.01)
      shape.form = Shape::Form::cylinder;
    else
      shape.depth = 1;  // as flat as a plane
    add(shape, any_texture());
  }

  void sheet() {
    double room = 0;
    Shape shape = place(0.08, 0.17, room);
    shape.form = Shape::Form::saddle;
    shape.outline.kind = Outline::Kind::rectangle;
    turn(shape, 0.2);
    slant(shape, 0.5 * room);
    const double reach = std::min(shape.half.x, shape.half.y);
    const double limit = std::min(0.25 * room, 0.1 * reach);
    shape.bend_u = real(-1, 1) * limit;
    shape.bend_v = real(-1, 1) * limit;
    add(shape, any_texture());
  }

  void foliage() {
    double room = 0;
    Shape shape = place(0.08, 0.18, room);
    slant(shape, room);
    shape.outline = {Outline::Kind::ragged, random_.next(), real(7, 16) * scale_, 0};
    add(shape, Texture::Kind::noise);
  }

  void wire() {
    double room = 0;
    Shape shape = place(0.25, 0.5, room);
    shape.half.y = std::max(2.0, real(0.03, 0.1) * height_);
    slant(shape, room);
    shape.outline = {Outline::Kind::wire, 0, 0, std::max(1.2, real(1.0, 2.2) * scale_)};
    add(shape, Texture::Kind::noise);
  }

  void fence() {
    double room = 0;
    Shape shape = place(0.08, 0.16, room);
    turn(shape, 0.1);
    slant(shape, room);
    shape.outline = {Outline::Kind::fence, 0, real(11, 24) * scale_,
                     std::max(1.2, real(1.2, 2.6) * scale_)};
    add(shape, Texture::Kind::noise);
  }

  const Options& options_;
  Random random_;
  double low_, span_;
  double width_, height_, scale_;
  Surfaces surfaces_;
};

}  // namespace

Surfaces compose_rich(const Options& options) { return Composer(options).run(); }

Surfaces compose(const Options& options) {
  Surfaces surfaces =
      options.content == Content::plain ? compose_plain(options) : compose_rich(options);
  for (Surface& surface : surfaces) {
    surface.texture.weak = options.faults.weak_texture;
    surface.texture.weak_share = options.faults.weak_share;
    surface.texture.repetitive = options.faults.repetitive;
    surface.texture.period = options.faults.repetitive_period;
  }
  return surfaces;
}

}  // namespace xgm::synthesis
