#include "apps/adapt/adapt_live.h"

#include <fmt/format.h>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using Json = nlohmann::ordered_json;

Json place(const SurveyBox& box, const Frame& frame, double across, double along) {
  const Vec2 p = frame.to_file(box_point(box, across, along));
  return Json{{"x_m", p.x()}, {"y_m", p.y()}};
}

Json track_message(const SurveyBox& box, const Frame& frame, const SurveyTrack& track) {
  Json message{{"type", "track"}, {"track", track.number}, {"across_m", track.across_m}};
  message["start"] = place(box, frame, track.across_m, track.outbound ? 0.0 : box.length_m);
  message["end"] = place(box, frame, track.across_m, track.outbound ? box.length_m : 0.0);
  message["port_looks"] = port_looks_back(box, track) ? "back" : "ahead";
  return message;
}

Json state_message(const SurveyBox& box, const Frame& frame, const LivePlanner& planner,
                   const std::vector<SurveyTrack>& sailed) {
  if (const auto track = planner.next()) return track_message(box, frame, *track);
  Json message{{"type", "done"}, {"tracks", sailed.size()}};
  message["length_m"] = mission_length_m(sailed, box.length_m);
  message.update(planner.figures());
  return message;
}

// `repeat`: an observation that was taken already is no error.
void take(const nlohmann::json& message, const LivePlanner& planner, bool repeat,
          std::vector<SurveyTrack>& sailed) {
  if (!message.is_object() || !message.contains("track")) {
    throw InvalidInput(
        "a message is an object with 'track' and its observation, or "
        "{\"repeat\": true}");
  }
  if (!message["track"].is_number_integer()) {
    throw InvalidInput("'track' must be the whole number of the track that was sailed");
  }
  const auto number = message["track"].get<long long>();
  const auto due = planner.next();
  if (repeat && number >= 0 && number < static_cast<long long>(sailed.size())) return;
  if (!due) throw InvalidInput(fmt::format("track {}: the mission is complete", number));
  if (number < due->number && number >= 0) {
    throw InvalidInput(
        fmt::format("track {} was observed already; track {} is due", number, due->number));
  }
  if (number != due->number) {
    throw InvalidInput(
        fmt::format("track {} was never given; track {} is due", number, due->number));
  }
  planner.observe(*due, message);
  sailed.push_back(*due);
}

// The JSON library's words without its own name and number.
std::string reason(const nlohmann::json::exception& e) {
  const std::string text = e.what();
  const auto at = text.find("] ");
  const char* what =
      e.id < 200 ? "the line is not JSON: " : "a field is missing or no such value: ";
  return what + (at == std::string::npos ? text : text.substr(at + 2));
}

}  // namespace

std::vector<SurveyTrack> run_live(std::istream& in, std::ostream& out, const SurveyBox& box,
                                  const Frame& frame, const LivePlanner& planner) {
  std::vector<SurveyTrack> sailed;
  const auto answer = [&](const Json& message) { out << message.dump() << std::endl; };
  const auto refuse = [&](const std::string& why) {
    Json error{{"type", "error"}, {"message", why}};
    if (const auto due = planner.next()) error["due"] = due->number;
    // The parser quotes the offending bytes, which need not be UTF-8.
    out << error.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
  };
  answer(state_message(box, frame, planner, sailed));
  std::string line;
  while (std::getline(in, line)) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      if (nesting_of_json(line) > kMostNesting) {
        throw InvalidInput(
            fmt::format("the message is JSON nested deeper than {} levels", kMostNesting));
      }
      const auto message = nlohmann::json::parse(line);
      const bool repeat = message.is_object() && message.value("repeat", false);
      const bool observed = message.is_object() && message.contains("track");
      if (!repeat || observed) take(message, planner, repeat, sailed);
      answer(state_message(box, frame, planner, sailed));
    } catch (const nlohmann::json::exception& e) {
      refuse(reason(e));
    } catch (const std::exception& e) {
      refuse(e.what());
    }
  }
  return sailed;
}

}  // namespace swathplan
