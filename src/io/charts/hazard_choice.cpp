#include "io/charts/hazard_choice.h"

#include <fmt/format.h>

#include "io/charts/hazard_buffers.h"
#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_choice(const std::string& text, const std::string& why) {
  throw UsageError("hazards", text,
                   why +
                       "; write FILE, FILE:LAYER, FILE:LAYER=METRES, LAYER=METRES, LAYER=off or "
                       "none");
}

bool is_there(const std::string& name) {
  std::error_code error;
  return fs::exists(name, error);
}

/// The file and the layer of the text before the buffer.
void split_place(const std::string& text, const std::string& place, HazardChoice& choice) {
  if (is_there(place)) {
    choice.file = place;
    return;
  }
  const std::size_t colon = place.rfind(':');
  if (colon == std::string::npos) {
    const bool like_file = place.find_first_of("./\\") != std::string::npos;
    if (like_file) refuse_choice(text, fmt::format("the file '{}' does not exist", place));
    choice.layer = place;
    return;
  }
  choice.file = place.substr(0, colon);
  choice.layer = place.substr(colon + 1);
  if (!is_there(choice.file.string())) {
    refuse_choice(text, fmt::format("the file '{}' does not exist", choice.file.string()));
  }
  if (choice.layer.empty()) refuse_choice(text, "no layer stands behind the colon");
}

HazardChoice parse_one(const std::string& text) {
  HazardChoice choice;
  std::string place = text;
  const std::size_t equals = text.rfind('=');
  if (equals != std::string::npos && !is_there(text)) {
    place = text.substr(0, equals);
    const std::string buffer = text.substr(equals + 1);
    choice.off = lower(buffer) == "off";
    if (!choice.off) {
      choice.buffer_m = to_finite_number(buffer);
      if (!choice.buffer_m || *choice.buffer_m < 0.0) {
        refuse_choice(text, fmt::format("'{}' is no buffer of 0 metres or more", buffer));
      }
    }
  }
  if (place.empty()) refuse_choice(text, "no file and no layer is named");
  split_place(text, place, choice);
  return choice;
}

}  // namespace

HazardChoices parse_hazards(const std::vector<std::string>& texts) {
  HazardChoices choices;
  for (const std::string& text : texts) {
    if (text == "none") {
      choices.unasked = false;
      continue;
    }
    choices.list.push_back(parse_one(text));
    const HazardChoice& c = choices.list.back();
    if (c.file.empty() && !c.off && !c.buffer_m && hazard_class(c.layer) == nullptr) {
      refuse_choice(text, fmt::format("'{}' is neither a file nor a class of hazards that has a "
                                      "buffer of its own",
                                      c.layer));
    }
  }
  return choices;
}

}  // namespace swathplan
