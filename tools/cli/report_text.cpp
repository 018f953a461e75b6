#include "report_text.hpp"

#include <winnow/version.hpp>

#include "numbers.hpp"

#include <algorithm>

namespace winnow::cli {

namespace {

Json head_of(const CLI::App& command) {
  Json options = Json::object();
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_positional() || option->get_lnames().empty()) continue;
    const bool flag = option->get_items_expected_max() == 0;
    options[option->get_lnames().front()] =
        flag ? Json(true) : Json(CLI::detail::join(option->results(), ","));
  }
  const bool named = command.get_parent() != nullptr;
  return {{"version", WINNOW_VERSION},
          {"command", named ? Json(command.get_name()) : Json(nullptr)},
          {"options", options}};
}

}  // namespace

std::string text_of(const Json& json) {
  return escaped_json(json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Json report_of(const CLI::App& command, const Json& body) {
  Json report = head_of(command);
  report.update(body);
  // Sentences for people, unlike names.
  if (report.contains("notes")) {
    for (Json& note : report["notes"]) note = clean(note.get<std::string>());
  }
  return report;
}

Json json_of_error(const std::string& message, ErrorKind kind) {
  return {{"error",
           {{"kind", name_of(kind)},
            {"exit_code", static_cast<int>(kind)},
            {"message", clean(spoken(message))}}}};
}

void print(const Json& body, const CommonOptions& common, std::ostream& out) {
  out << text_of(report_of(*common.owner, body)) << "\n";
}

void print_failure(const CLI::App& app, const std::string& message, ErrorKind kind) {
  const CLI::App& command = parsed_command(app);
  report_stream(writes_to_standard_output(command) ? "-" : "")
      << text_of(report_of(command, json_of_error(message, kind))) << "\n";
}

void Lines::operator()(const std::string& name, const std::string& text) const {
  out_ << "  " << name << std::string(column_ - std::min(column_ - 1, name.size()), ' ')
       << clean(spoken(text)) << "\n";
}

void Lines::notes(const std::vector<std::string>& notes) const {
  for (const std::string& note : notes) (*this)("note", note);
}

std::string show_lost(const LevelReport::Lost& lost) {
  std::string text;
  const auto add = [&](std::uint64_t count, const char* one) {
    if (count == 0) return;
    if (!text.empty()) text += ", ";
    text += grouped(count) + " " + one + (count == 1 ? "" : "s");
  };
  add(lost.pieces, "piece");
  if (lost.pieces > 0) text += " (area " + show_length(lost.piece_area) + ")";
  add(lost.handles, "handle");
  add(lost.holes, "hole");
  return text;
}

void show_quantized(const Lines& line, double position_error) {
  if (position_error > 0)
    line("quantized", "no vertex moves by more than " + show_length(position_error));
}

std::string show_time(double seconds, std::uint64_t faces) {
  return show_seconds(seconds) + "  (" + show_rate(static_cast<double>(faces) / seconds) +
         "faces/s)";
}

std::string show_memory(std::uint64_t peak, std::uint64_t scratch) {
  std::string text = human_bytes(peak) + " at its peak";
  if (scratch > 0) text += ", and " + human_bytes(scratch) + " of scratch";
  return text;
}

}  // namespace winnow::cli
