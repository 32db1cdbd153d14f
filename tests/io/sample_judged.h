#pragma once

#include "coverage/judging/judged_survey.h"

namespace swathplan::test {

/// A survey of 3 x 2 cells of 0.5 m that fails Special Order by one rule of two.
inline JudgedSurvey judged_survey() {
  JudgedSurvey survey;
  survey.verdict.criterion = "s44-special";
  survey.verdict.title = "IHO S-44 Special Order";
  survey.verdict.judged_m2 = 120.0;
  JudgedRule coverage;
  coverage.name = "coverage";
  coverage.asks = "100 % coverage and feature search";
  coverage.figure = "97.50 % of cells, 2 gaps";
  coverage.figure_pct = 97.5;
  coverage.failing_m2 = 3.0;
  coverage.failing_places = 2;
  coverage.where = {{{10.0, 20.0}, 2.0}, {{30.0, 25.0}, 1.0}};
  JudgedRule density;
  density.name = "density";
  density.figure = "99.00 % of cells";
  density.figure_pct = 99.0;
  density.pass = true;
  survey.verdict.rules = {coverage, density};
  survey.raster.cell_m = 0.5;
  survey.raster.columns = 3;
  survey.raster.rows = 2;
  survey.raster.tvu_m = {0.1F, 0.2F, 0.3F, 0.4F, 0.5F, JudgedCell::kNone};
  survey.raster.thu_m = {1.1F, 1.2F, 1.3F, 1.4F, 1.5F, JudgedCell::kNone};
  survey.raster.tvu_share = survey.raster.tvu_m;
  survey.tvu_histogram[3] = 30;
  survey.tvu_histogram[12] = 10;
  survey.pings = 5;
  survey.soundings = 40;
  survey.accepted = 30;
  survey.out_of_reach = {3.0, 1.5};
  return survey;
}

}  // namespace swathplan::test
