// Which attributes of an input are carried, and what is to be said of the others.
#pragma once

#include "base/attribute.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// What the caller asks for.
struct AttributeRequest {
  // Names of properties; "normals" and "colors" stand for those of normals and colours. Nothing:
  // whatever has a meaningful mean. Empty: none.
  std::optional<std::vector<std::string>> names{std::vector<std::string>{}};
  // Why the output cannot have an attribute that is one of those `wanted`, in words that its name
  // follows; empty where it can. May be unset.
  std::function<std::string(const Attribute&, std::span<const Attribute> wanted)> refusal;

  // A number that says of an attribute that is no colour and no normal that there is none.
  std::optional<double> no_data{};

  // Whether their means are taken; where not, texture coordinates are as good as others.
  bool averaged = true;

  [[nodiscard]] bool none() const { return names && names->empty(); }
};

// What is said where some vertices have a colour and others have none. Then none carries one, in
// whatever order they stand.
inline constexpr const char* colors_of_some = "colours of some vertices";

// What an input offers.
struct AvailableAttributes {
  // Properties of vertices, without the position. Their kinds are open, but for light, which no
  // name tells.
  std::vector<Attribute> scalars;
  std::vector<std::string> lists;       // of vertices
  std::vector<std::string> of_faces;    // properties of faces, without the indices
  std::vector<std::string> of_nothing;  // other elements
  std::vector<std::string> unread;  // what the reader passes over, in words: "texture coordinates"
  std::vector<std::string>
      not_common;  // names of scalars that not all of several inputs have, of one type
};

// What several inputs offer together: scalars that all have under one name and of one type, in the
// order of the first, as light where all say so; of everything else whatever any has.
AvailableAttributes common_offer(const std::vector<AvailableAttributes>& offers);

struct AttributeSelection {
  std::vector<Attribute> carried;
  std::vector<std::size_t> scalar;   // of each of them its number in the offer
  std::vector<std::string> dropped;  // "texture coordinates s, t"
};

// Throws Error(usage) where a name is not among `offer` or too many are asked for; `input` is for
// its message.
AttributeSelection choose_attributes(const AttributeRequest& wish, const AvailableAttributes& offer,
                                     const std::string& input);

}  // namespace winnow
