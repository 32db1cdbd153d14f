#include <gtest/gtest.h>

#include <algorithm>

#include "io/charts/chart_mesh_internal.h"

namespace swathplan {
namespace {

/// Rectangles side by side along x, 100 m each, with these bounds.
ChartDepths strips(const std::vector<std::pair<double, double>>& bounds) {
  ChartDepths chart;
  for (std::size_t i = 0; i <= bounds.size(); ++i) {
    chart.places.emplace_back(100.0 * static_cast<double>(i), 0.0);
    chart.places.emplace_back(100.0 * static_cast<double>(i), 100.0);
  }
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    chart.areas.push_back(
        {{{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}}, bounds[i].first, bounds[i].second});
  }
  chart.soundings.resize(chart.places.size());
  chart.contours.resize(chart.places.size());
  return chart;
}

void sound(ChartDepths& chart, const Vec2& at, double depth) {
  chart.places.push_back(at);
  chart.soundings.emplace_back(depth);
  chart.contours.emplace_back();
}

double plan_area(const ChartMesh& mesh) {
  double sum = 0.0;
  for (const auto& f : mesh.faces) {
    const Vec2 ab = mesh.places[f[1]] - mesh.places[f[0]];
    const Vec2 ac = mesh.places[f[2]] - mesh.places[f[0]];
    sum += 0.5 * (ab.x() * ac.y() - ab.y() * ac.x());
  }
  return sum;
}

TEST(ChartMesh, TheLineBetweenTwoAreasIsTheirContour) {
  const ChartMesh mesh = chart_mesh(strips({{2, 5}, {5, 10}}));
  EXPECT_DOUBLE_EQ(mesh.depths[0], 2.0);  // the chart's edge: the shoal bound
  EXPECT_DOUBLE_EQ(mesh.depths[2], 5.0);
  EXPECT_DOUBLE_EQ(mesh.depths[4], 5.0);
  EXPECT_DOUBLE_EQ(plan_area(mesh), 2e4);
  EXPECT_EQ(mesh.areas_without_soundings, 2U);
}

TEST(ChartMesh, AContourAndASoundingGoBeforeTheBounds) {
  ChartDepths chart = strips({{2, 5}, {5, 10}});
  chart.contours[2] = chart.contours[3] = 4.5;
  sound(chart, {150, 50}, 8.0);
  sound(chart, {900, 50}, 3.0);  // on land
  const ChartMesh mesh = chart_mesh(chart);
  EXPECT_DOUBLE_EQ(mesh.depths[2], 4.5);
  EXPECT_DOUBLE_EQ(mesh.depths[6], 8.0);
  EXPECT_EQ(mesh.used_soundings, 1U);
  EXPECT_EQ(mesh.areas_without_soundings, 1U);
}

TEST(ChartMesh, BesideADredgedChannelTheShoalSideKeepsItsBound) {
  ChartDepths chart = strips({{1, 2}, {6, 6}});
  chart.areas[1].deep_m = std::numeric_limits<double>::infinity();
  const ChartMesh mesh = chart_mesh(chart);
  EXPECT_DOUBLE_EQ(mesh.depths[2], 2.0);  // nothing deeper than the shoal side allows
  EXPECT_DOUBLE_EQ(mesh.depths[4], 6.0);
}

TEST(ChartMesh, AnAreaThatTheChartLeavesOpenIsShoal) {
  // A shoal of 1 to 5 m within deeper water: its contour of 5 m alone would make it 5 m deep.
  ChartDepths chart = strips({{5, 10}, {1, 5}, {5, 10}});
  const ChartMesh open = chart_mesh(chart);
  const double shoalest = *std::min_element(open.depths.begin(), open.depths.end());
  EXPECT_DOUBLE_EQ(shoalest, 1.0);
  EXPECT_DOUBLE_EQ(plan_area(open), 3e4);
  // A sounding in it says how deep it is.
  sound(chart, {150, 50}, 3.5);
  const ChartMesh known = chart_mesh(chart);
  EXPECT_DOUBLE_EQ(*std::min_element(known.depths.begin(), known.depths.end()), 3.5);
}

TEST(ChartMesh, OutlinesThatCrossGetACorner) {
  ChartDepths chart = strips({{2, 5}});
  chart.places.emplace_back(50.0, -50.0);
  chart.places.emplace_back(150.0, 50.0);
  chart.places.emplace_back(50.0, 150.0);
  chart.soundings.resize(chart.places.size());
  chart.contours.resize(chart.places.size());
  chart.areas.push_back({{{4, 5, 6}}, 5.0, 10.0});
  const ChartMesh mesh = chart_mesh(chart);
  EXPECT_GT(mesh.places.size(), chart.places.size());
  for (const auto& f : mesh.faces) {
    for (const std::uint32_t v : f) EXPECT_GE(mesh.depths[v], 2.0);
  }
}

}  // namespace
}  // namespace swathplan
