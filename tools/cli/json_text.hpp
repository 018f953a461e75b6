// A report as text.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace winnow::cli {

// Names in it may come from a file: what is no UTF-8 becomes the sign for that.
inline std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace winnow::cli
