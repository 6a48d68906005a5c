// SPDX-License-Identifier: Apache-2.0
#include "geo/satellite_desk.hpp"

#include <doctest/doctest.h>
#include <gdal_priv.h>

#include <cstdio>

#include "ground/gdal.hpp"
#include "xgm/geo/camera/write_rpc.hpp"
#include "xgm/geo/image/footprint.hpp"

namespace xgm::testing {
namespace {

geo::SatelliteScene make_scene() {
  geo::SatelliteSceneSpec spec;
  spec.size = 128;
  spec.relief = 20;
  spec.views = {{.azimuth = 12, .incidence = 7, .heading = 188, .pointing_error = {}},
                {.azimuth = 195, .incidence = 9, .heading = 193, .pointing_error = {}}};
  return geo::make_satellite_scene(spec);
}

}  // namespace

SatelliteDesk::SatelliteDesk() {
  static const geo::SatelliteScene made = make_scene();
  scene = made;
  geo::write_satellite_scene(*this / "scene", scene);
}

void SatelliteDesk::write_image(const std::string& name, int bands, bool with_camera) const {
  GDALAllRegister();
  const cv::Mat1w& image = scene.images[1];
  const geo::DatasetPtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      (*this / name).c_str(), image.cols, image.rows, bands, GDT_UInt16, nullptr));
  REQUIRE(dataset != nullptr);
  for (int band = 1; band <= bands; ++band) {
    REQUIRE(dataset->GetRasterBand(band)->RasterIO(
                GF_Write, 0, 0, image.cols, image.rows, const_cast<std::uint8_t*>(image.data),
                image.cols, image.rows, GDT_UInt16, 0, 0) == CE_None);
  }
  if (!with_camera) return;
  const std::string camera = name.substr(0, name.rfind('.')) + "_RPC.TXT";
  write(camera, geo::rpc_text(scene.views[1].delivered));
}

void SatelliteDesk::write_vrt(const std::string& name, const std::string& of) const {
  GDALAllRegister();
  const geo::DatasetPtr source(GDALDataset::Open((*this / of).c_str()));
  REQUIRE(source != nullptr);
  const geo::DatasetPtr copy(GetGDALDriverManager()->GetDriverByName("VRT")->CreateCopy(
      (*this / name).c_str(), source.get(), FALSE, nullptr, nullptr, nullptr));
  REQUIRE(copy != nullptr);
}

cv::Vec4d SatelliteDesk::ground() const {
  const geo::SatelliteImage image = geo::open_image(*this / "scene/image_1.tif");
  const auto box = geo::footprint(image, cv::Rect({}, image.size), scene.ground);
  REQUIRE(box);
  return *box;
}

std::string text_of(const cv::Vec4d& box) {
  char text[160];
  std::snprintf(text, sizeof text, "%.7f,%.7f,%.7f,%.7f", box[0], box[1], box[2], box[3]);
  return text;
}

}  // namespace xgm::testing
