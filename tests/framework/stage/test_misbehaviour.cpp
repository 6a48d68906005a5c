// SPDX-License-Identifier: Apache-2.0
// Whatever plugins throw, wherever they are called, ends as an Error or a diagnostic that names
// them.
#include <new>

#include "framework/stage/doing.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/io/scene.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// How a plugin fails.
void fail(const std::string& how) {
  if (how == "number") throw 42;
  if (how == "text") throw "no exception";
  if (how == "standard") throw std::out_of_range("vector::at\nof nothing");
  if (how == "opencv") cv::Mat1f(3, 3).row(7);
  if (how == "memory") throw std::bad_alloc();
  if (how == "opencv memory") CV_Error(cv::Error::StsNoMem, "Failed to allocate 99 bytes");
  if (how == "error") throw Error("cannot go on; do something else");
}

std::string error_of_filter(const std::string& how) {
  const auto slot = slot_of<DoingFilter>([&](const DisparityMap& map, const ImagePair&) {
    fail(how);
    return map;
  });
  return error_of([&] { slot(Context(), DisparityMap({4, 4}), shifted_pair({4, 4}, 1, 1)); });
}

/// Fails where its parameter says; else passes maps through.
class BadFilter final : public Filter {
 public:
  struct Parameters {
    std::string where = "run";
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("where", p.where, "Where it fails.");
    set.rule({"where"}, "must hold", [&p] {
      if (p.where == "rule") throw 1;
      return true;
    });
  }
  explicit BadFilter(Parameters p) : where_(p.where) {
    if (where_ == "constructor") throw 2;
  }
  DisparityMap run(const DisparityMap& map, const ImagePair&, const Context&) const override {
    DisparityMap result = map.clone();
    if (where_ == "run") result.disparity.setTo(std::numeric_limits<float>::quiet_NaN());
    return result;
  }

 private:
  std::string where_;
};

class BadDescription final : public Cost {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) { throw std::runtime_error("no memory of it"); }
  explicit BadDescription(Parameters) {}
  CostVolume run(const ImagePair&, const VolumeShapePtr& shape, const Context&) const override {
    return {shape, 1};
  }
};

class BadDataset final : public Dataset {
 public:
  struct Parameters {
    std::string how = "none";
  };
  static void describe(Parameters& p, ParameterSet& set) { set.add("how", p.how, "How it fails."); }
  explicit BadDataset(Parameters p) : how_(p.how) {}
  std::vector<SceneFiles> scenes(const std::string&) const override {
    fail(how_);
    SceneFiles scene{.name = how_ == "name" ? "" : "a"};
    if (how_ == "interval") scene.disparities = Interval{5, 3};
    if (how_ == "weight") scene.weight = -1;
    if (how_ == "scale") scene.scale = std::numeric_limits<double>::quiet_NaN();
    if (how_ == "divisor") scene.truth.reverse.divisor = std::numeric_limits<double>::infinity();
    return {scene};
  }
  std::string layout() const override { return "anything"; }

 private:
  std::string how_;
};

class BadFamily final : public StereoFamily {
 public:
  struct Parameters {
    std::string how = "none";
  };
  static void describe(Parameters& p, ParameterSet& set) { set.add("how", p.how, "How it fails."); }
  explicit BadFamily(Parameters p) : how_(p.how) {}
  MatchResult run(const MatchRequest& request, const Context&) const override {
    fail(how_);
    return {DisparityMap(how_ == "size" ? cv::Size(3, 3) : request.pair.size()), std::nullopt};
  }
  std::optional<Interval> disparities() const override { return std::nullopt; }
  bool accepts_range_maps() const override { return true; }

 private:
  std::string how_;
};

const Registry& with_bad_plugins() {
  static const Registry registry = [] {
    Registry all = Registry::with_builtins();
    all.add<BadFilter>("bad_filter", "Fails.");
    all.add<BadDescription>("bad_description", "Fails.");
    all.add<BadDataset>("bad_dataset", "Fails.");
    all.add<BadFamily>("bad_family", "Fails.");
    return all;
  }();
  return registry;
}

LoadedPipeline load(const std::string& cost, const std::string& filter) {
  return load_pipeline_text("matcher: {type: semi_global, cost: " + cost +
                                ", penalty: constant, aggregation: sgm}\npostprocess: [" + filter +
                                "]\n",
                            "bad.yaml", with_bad_plugins());
}

std::string diagnostics(const std::string& cost, const std::string& filter) {
  return to_string(load(cost, filter).diagnostics);
}

const std::string kRemedy = "; correct the plugin, or use another one";

}  // namespace

TEST_CASE("what a stage throws becomes an Error of one line that names path and plugin") {
  const std::string failed = "here: filter 'bad' failed: ";
  CHECK(error_of_filter("nothing") == "");
  CHECK(error_of_filter("number") == failed + "it threw what is no std::exception" + kRemedy);
  CHECK(error_of_filter("text") == failed + "it threw what is no std::exception" + kRemedy);
  CHECK(error_of_filter("standard") == failed + "vector::at of nothing" + kRemedy);
  CHECK(contains(error_of_filter("opencv"), failed + "OpenCV says '"));
  CHECK_FALSE(contains(error_of_filter("opencv"), ".cpp"));
  CHECK(contains(error_of_filter("memory"), "here: not enough memory; use a smaller image"));
  CHECK(error_of_filter("opencv memory") == error_of_filter("memory"));
  CHECK(error_of_filter("error") == "here: cannot go on; do something else");
}

TEST_CASE("what a plugin throws while it is bound is a diagnostic at its place") {
  const std::string threw = "failed: it threw what is no std::exception" + kRemedy;
  CHECK(diagnostics("census", "bad_filter") == "");
  CHECK(diagnostics("census", "{type: bad_filter, where: rule}") ==
        "bad.yaml:2:22: error: filter 'bad_filter' " + threw);
  CHECK(diagnostics("census", "{type: bad_filter, where: constructor}") ==
        "bad.yaml:2:22: error: filter 'bad_filter' " + threw);
  CHECK(diagnostics("bad_description", "median") ==
        "bad.yaml:1:36: error: cost 'bad_description' failed: no memory of it" + kRemedy);
}

TEST_CASE("a run with a faulty stage ends with an error, and leaves no map") {
  const cv::Size size(40, 20);
  const SceneRequest scene{
      .scene =
          Scene{.name = "noise", .pair = shifted_pair(size, 3, 5), .disparities = Interval{0, 8}}};
  const TemporaryFolder folder;
  const Pipeline pipeline = *load("census", "bad_filter").pipeline;
  const std::string error =
      error_of([&] { record_scene(pipeline, scene, {.folder = folder.path(), .report = true}); });
  CHECK(contains(error, "postprocess[0]: filter 'bad_filter' returned a faulty result: disparity"));
  CHECK(folder.files() == 0);
}

TEST_CASE("a family of pipelines is looked at like a stage") {
  const auto run = [](const std::string& how) {
    const LoadedPipeline loaded =
        load_pipeline_text("{type: bad_family, how: " + how + "}", "f.yaml", with_bad_plugins());
    REQUIRE(loaded.pipeline.has_value());
    const cv::Size size(9, 5);
    return error_of([&] {
      loaded.pipeline->run(
          {shifted_pair(size, 1, 1), DisparityRange::uniform(size, {0, 4}), std::nullopt});
    });
  };
  CHECK(run("none") == "");
  CHECK(run("size") ==
        "pipeline 'bad_family' returned a faulty result: the map does not have the "
        "image's size" +
            kRemedy);
  CHECK(run("number") ==
        "pipeline 'bad_family' failed: it threw what is no std::exception" + kRemedy);
}

TEST_CASE("data sets are looked at like stages") {
  const TemporaryFolder folder;
  const auto find = [&](const std::string& how) {
    return error_of([&] {
      find_scenes(folder.path(), with_bad_plugins(), "{type: bad_dataset, how: " + how + "}");
    });
  };
  const std::string faulty = "dataset 'bad_dataset' returned a faulty result: ";
  CHECK(find("none") == "");
  CHECK(find("number") ==
        "dataset 'bad_dataset' failed: it threw what is no std::exception" + kRemedy);
  CHECK(find("name") == faulty + "a scene has no name" + kRemedy);
  CHECK(find("interval") ==
        faulty + "the disparities of scene 'a' are an empty interval" + kRemedy);
  CHECK(find("weight") == faulty + "the weight of scene 'a' is no number of 0 or more" + kRemedy);
  CHECK(find("scale") == faulty + "the scale of scene 'a' is no number above 0" + kRemedy);
  CHECK(find("divisor") == faulty + "a divisor of scene 'a' is no finite number" + kRemedy);
}
