// SPDX-License-Identifier: Apache-2.0
// One scene's fault is that scene's: the others are listed as ever, in every layout.
#include <sys/stat.h>

#include "plugins/dataset/tree.hpp"

using namespace xgm;
using namespace xgm::testing;
namespace fs = std::filesystem;

namespace {

/// While it lives, the process has the rights of nobody, whom permissions bind even if root began
/// the test.
class Unprivileged {
 public:
  Unprivileged() : is_root_(::geteuid() == 0) {
    constexpr uid_t kNobody = 65534;
    if (is_root_) REQUIRE(::seteuid(kNobody) == 0);
  }
  ~Unprivileged() {
    if (is_root_) static_cast<void>(::seteuid(0));
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  bool is_root_;
};

/// Without rights while it lives.
class Locked {
 public:
  explicit Locked(std::string path) : path_(std::move(path)) {
    fs::permissions(path_, fs::perms{});
  }
  ~Locked() { fs::permissions(path_, fs::perms::owner_all); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  std::string path_;
};

void add_pair(const Tree& tree, const std::string& left, const std::string& right) {
  tree.add(left);
  tree.add(right);
}

const SceneFiles& named(const std::vector<SceneFiles>& scenes, const std::string& name) {
  for (const SceneFiles& scene : scenes) {
    if (scene.name == name) return scene;
  }
  FAIL("no scene ", name, " among ", names(scenes));
  return scenes.front();
}

}  // namespace

TEST_CASE("a folder that cannot be read is a scene with that fault, beside the others") {
  const Tree tree;
  for (const std::string scene : {"a", "b"}) add_pair(tree, scene + "/im0.png", scene + "/im1.png");
  const Locked locked(tree / "b");
  const Unprivileged nobody;
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "a b");
  CHECK(scenes[0].faults.empty());
  CHECK(contains(faults(scenes[1]), "b: cannot be read: Permission denied"));
  CHECK(find_scene(tree.path(), builtins(), "a").name == "a");
}

TEST_CASE("files that cannot be opened are told without being opened") {
  const Tree tree;
  add_pair(tree, "im0.png", "im1.png");
  const Locked locked(tree / "im1.png");
  const Unprivileged nobody;
  CHECK(contains(faults(tree.scenes()[0]), "im1.png: cannot be opened: Permission denied"));
}

TEST_CASE("links that lead nowhere are told: of an image, a calibration, a truth, a folder") {
  const Tree tree;
  for (const std::string scene : {"a", "b"}) add_pair(tree, scene + "/im0.png", scene + "/im1.png");
  fs::remove(tree / "b/im1.png");
  for (const char* link : {"b/im1.png", "b/calib.txt", "b/disp0GT.pfm", "c"}) {
    fs::create_symlink(tree / "nowhere", tree / link);
  }
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "a b c");
  CHECK(scenes[0].faults.empty());
  const std::string told = faults(scenes[1]);
  CHECK(contains(told, "b/im1.png: is a link that leads nowhere; without it the scene cannot"));
  CHECK(contains(told, "b/disp0GT.pfm: is a link that leads nowhere"));
  CHECK(contains(told, "b/calib.txt: cannot be read: No such file"));
  CHECK(scenes[1].faults.size() == 3);
  CHECK(contains(faults(scenes[2]), "c: is a link that leads nowhere"));
}

TEST_CASE("empty files are told") {
  const Tree tree;
  for (const std::string scene : {"a", "b"}) add_pair(tree, scene + "/im0.png", scene + "/im1.png");
  for (const char* file : {"b/im0.png", "b/disp0GT.pfm", "b/mask0nocc.png"})
    tree.add_text(file, "");
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "a b");
  for (const char* file :
       {"im0.png: is empty", "disp0GT.pfm: is empty", "mask0nocc.png: is empty"}) {
    CHECK(contains(faults(scenes[1]), file));
  }
  CHECK(scenes[0].faults.empty());
}

TEST_CASE("a faulty calibration stops no other scene, in any layout") {
  const Tree tree;
  for (const std::string scene : {"a", "b", "room_1l", "room_2l"}) {
    const std::string top = scene.size() > 1 ? "eth3d/" : "v3/";
    add_pair(tree, top + scene + "/im0.png", top + scene + "/im1.png");
    add_pair(tree, "own/" + scene + "_l.png", "own/" + scene + "_r.png");
    tree.add_text("own/" + scene + ".txt", kCalibTxt);
    tree.add_text(top + scene + "/calib.txt", kCalibTxt);
    add_pair(tree, "HalfSize/" + scene + "/view1.png", "HalfSize/" + scene + "/view5.png");
    tree.add_text("HalfSize/" + scene + "/dmin.txt", "20\n");
  }
  const std::string broken = "ndisp=many\n";
  for (const char* file :
       {"v3/b/calib.txt", "eth3d/room_2l/calib.txt", "own/b.txt", "HalfSize/b/dmin.txt"}) {
    tree.add_text(file, broken);
  }
  tree.add_text(
      "own/dataset.yaml",
      "{type: folder, left: '{scene}_l.png', right: '{scene}_r.png', calibration: '{scene}.txt'}");
  const auto check = [&](const std::string& folder, const std::string& good, const std::string& bad,
                         const std::string& file) {
    CAPTURE(folder);
    const auto scenes = tree.scenes(folder);
    CHECK(faults(named(scenes, good)) == "");
    CHECK(named(scenes, good).calibration.has_value());
    CHECK(contains(faults(named(scenes, bad)), file + ":1: "));
    CHECK_FALSE(named(scenes, bad).calibration.has_value());
  };
  check("v3", "a", "b", "b/calib.txt");
  check("eth3d", "room_1l", "room_2l", "room_2l/calib.txt");
  check("own", "a", "b", "b.txt");
  check("HalfSize", "a", "b", "b/dmin.txt");
}

TEST_CASE("half a pair is a scene in the old sets as well, and the set stays what it is") {
  const Tree tree;
  for (const std::string scene : {"bull", "venus"}) {
    for (int i = 0; i < 9; ++i) tree.add("2001/" + scene + "/im" + std::to_string(i) + ".ppm");
    tree.add("2001/" + scene + "/disp2.pgm");
    add_pair(tree, "2005/" + scene + "/view1.png", "2005/" + scene + "/view5.png");
    tree.add("2005/" + scene + "/disp1.png");
  }
  fs::remove(tree / "2001/venus/im6.ppm");
  fs::remove(tree / "2005/venus/view1.png");
  const auto old = tree.scenes("2001");
  REQUIRE(names(old) == "bull venus");
  CHECK(old[1].dataset == "middlebury_2001");
  CHECK(lacks(old[1], "venus/im6.ppm: without it the scene cannot be matched"));
  CHECK(
      lacks(tree.scenes("2005").at(1), "venus/view1.png: without it the scene cannot be matched"));
}

TEST_CASE("sceneflow: a sequence that cannot be read stops no other") {
  const Tree tree;
  for (const std::string sequence : {"A", "B"}) {
    const std::string folder = "frames_cleanpass/" + sequence;
    add_pair(tree, folder + "/left/0006.png", folder + "/right/0006.png");
  }
  tree.add_folder("disparity");
  const Locked locked(tree / "frames_cleanpass/B");
  const Unprivileged nobody;
  const auto scenes = tree.scenes();
  REQUIRE(names(scenes) == "A_0006 B");
  CHECK(contains(faults(scenes[1]), "B: cannot be read: Permission denied"));
}

TEST_CASE("folder: a scene whose left image is missing or out of reach is listed") {
  const Tree tree;
  for (const std::string scene : {"a", "b", "c"}) {
    add_pair(tree, scene + "/left.tif", scene + "/right.tif");
  }
  tree.add_folder("notes");
  fs::remove(tree / "b/left.tif");
  fs::remove(tree / "c/left.tif");
  fs::create_symlink(tree / "nowhere", tree / "c/left.tif");
  const auto scenes =
      tree.scenes(".", "{type: folder, left: '{scene}/left.tif', right: '{scene}/right.tif'}");
  REQUIRE(names(scenes) == "a b c");
  CHECK(lacks(scenes[1], "b/left.tif: without it the scene cannot be matched"));
  CHECK(contains(faults(scenes[2]), "c/left.tif: is a link that leads nowhere"));
}
