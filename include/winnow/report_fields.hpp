// What the tables of several reports have in common: see for_each_field() of each report.
#pragma once

namespace winnow {

// Calls field(path, value) for what was read: of a report's `input`.
template <typename Input, typename Field>
void for_each_input_field(Input& input, Field&& field) {
  field("input.files", input.names);
  field("input.format", input.format);
  field("input.faces", input.faces);
  field("input.vertices", input.vertices);
  field("input.bytes", input.bytes);
}

// The same for the file that was written: of a report's `output`.
template <typename Output, typename Field>
void for_each_output_field(Output& output, Field&& field) {
  field("output.file", output.name);
  field("output.format", output.format);
  field("output.faces", output.faces);
  field("output.vertices", output.vertices);
  field("output.bytes", output.bytes);
  field("output.position_error", output.position_error);
}

// The same for what became of the surface.
template <typename Report, typename Field>
void for_each_lost_field(Report& report, Field&& field) {
  field("lost.pieces", report.lost.pieces);
  field("lost.piece_area", report.lost.piece_area);
  field("lost.handles", report.lost.handles);
  field("lost.holes", report.lost.holes);
}

// The same for what a call took: scratch, memory, the time of each stage that it has.
template <typename Report, typename Field>
void for_each_usage_field(Report& report, Field&& field) {
  field("spilled_bytes", report.spilled_bytes);
  field("peak_scratch_bytes", report.peak_scratch_bytes);
  field("peak_memory_bytes", report.peak_memory_bytes);
  field("seconds", report.seconds.total);
  field("stage_seconds.read", report.seconds.read);
  if constexpr (requires { report.seconds.cluster; })
    field("stage_seconds.cluster", report.seconds.cluster);
  if constexpr (requires { report.seconds.refine; })
    field("stage_seconds.refine", report.seconds.refine);
  field("stage_seconds.write", report.seconds.write);
}

}  // namespace winnow
