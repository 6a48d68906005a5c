// SPDX-License-Identifier: Apache-2.0
// Images that the program holds already, matched in a thread of their own that another one ends.
#include <iostream>
#include <thread>
#include <xgm/pipeline.hpp>

namespace {

class Shown final : public xgm::Observer {
 public:
  void progress(double share) override { std::cout << static_cast<int>(100 * share) << " %\n"; }
};

// Two views of a wall of noise, 7 px apart: what a camera would give.
xgm::ImagePair views() {
  cv::Mat1b left(240, 320), right(240, 320);
  cv::randu(left, 0, 256);
  cv::randu(right, 0, 256);
  left.colRange(7, 320).copyTo(right.colRange(0, 313));
  return {xgm::Image(left), xgm::Image(right)};
}

}  // namespace

int main() {
  const xgm::Registry plugins = xgm::Registry::with_builtins();
  const xgm::Pipeline pipeline = xgm::require_pipeline("tmgm8", plugins);
  xgm::Scene scene{.name = "wall", .pair = views(), .disparities = xgm::Interval{0, 32}};

  const xgm::SceneRun run = xgm::run_scene(pipeline, {.scene = scene});
  std::cout << "found: " << run.maps.forward.disparity(120, 160) << " px\n";

  std::stop_source stop;
  std::thread worker([&] {
    try {
      Shown shown;
      xgm::run_scene(pipeline, {.scene = scene}, {.observer = &shown, .stop = stop.get_token()});
      std::cout << "done\n";
    } catch (const xgm::Error& error) {
      std::cout << "ended: " << error.what() << '\n';
    }
  });
  stop.request_stop();
  worker.join();
}
