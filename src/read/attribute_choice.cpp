#include "read/attribute_choice.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace winnow {

namespace {

// These are colours only all three together.
constexpr std::array<std::string_view, 3> short_names{"r", "g", "b"};
// Of both sides of a seam in a texture, whose mean is somewhere else in the picture.
constexpr std::array<std::string_view, 10> texture_names{
    "s", "t", "u", "v", "texture_u", "texture_v", "texture_s", "texture_t", "tex_u", "tex_v"};

template <typename Names>
bool among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Whether whole numbers of this name tell things apart and have no mean.
bool names_label(const std::string& property) {
  std::string name = property;
  std::transform(name.begin(), name.end(), name.begin(), ascii_to_lower);
  constexpr std::array<std::string_view, 4> names{"id", "label", "labels", "flags"};
  return among(names, name) || name.ends_with("_id") || name.ends_with("_label") ||
         name.starts_with("class") || name.starts_with("segment");
}

// Kinds go by what programs call their properties.
AttributeKind kind_of(const Attribute& attribute, const std::vector<Attribute>& all) {
  if (attribute.kind == AttributeKind::light) return attribute.kind;
  const auto offered = [&](std::string_view name) {
    return std::any_of(all.begin(), all.end(), [&](const Attribute& a) { return a.name == name; });
  };
  const auto real = [&](std::string_view name) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Attribute& a) { return a.name == name && !is_integer(a.type); });
  };
  if (among(normal_names, attribute.name) && !is_integer(attribute.type) &&
      std::all_of(normal_names.begin(), normal_names.end(), real)) {
    return AttributeKind::normal;
  }
  if (is_integer(attribute.type) && names_label(attribute.name)) return AttributeKind::label;
  const std::optional<std::size_t> component = component_named(attribute.name);
  const bool color = component && *component < 3 && may_be_component(attribute.type) &&
                     (!among(short_names, attribute.name) ||
                      std::all_of(short_names.begin(), short_names.end(), offered));
  return color ? AttributeKind::color : AttributeKind::value;
}

// Names by reason, in the order of their first.
class Dropped {
 public:
  void add(const std::string& reason, const std::string& name) {
    for (auto& [known, names] : reasons_) {
      if (known == reason) return names.push_back(name);
    }
    reasons_.push_back({reason, {name}});
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const auto& [reason, names] : reasons_) lines.push_back(reason + " " + joined(names));
    return lines;
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons_;
};

[[noreturn]] void refuse_name(const std::string& name, const AvailableAttributes& offer,
                              const std::string& input) {
  std::vector<std::string> all;
  for (const Attribute& attribute : offer.scalars) all.push_back(attribute.name);
  const auto not_common = [&](std::string_view one) { return among(offer.not_common, one); };
  const bool differs =
      not_common(name) ||
      (name == "normals" && std::any_of(normal_names.begin(), normal_names.end(), not_common)) ||
      (name == "colors" &&
       std::any_of(offer.not_common.begin(), offer.not_common.end(), component_named));
  std::string message = "'" + input + "': '" + name + "' is ";
  if (among(offer.lists, name)) {
    message += "a list at each vertex, which cannot be averaged";
  } else {
    message += differs ? "not in every input, or not of one type" : "no attribute of its vertices";
  }
  const std::string common = offer.not_common.empty() ? "" : " in common";
  message += all.empty() ? "; they have none" + common + ": leave `attributes` out"
                         : "; they have " + joined(all) + common;
  throw Error(ErrorKind::usage, message);
}

// The names asked for, groups taken apart. Of a group those that are offered, but at least one.
std::vector<std::string> wanted_names(const std::vector<std::string>& names,
                                      const AvailableAttributes& offer, const std::string& input) {
  const auto offered = [&](std::string_view name) {
    return std::any_of(offer.scalars.begin(), offer.scalars.end(),
                       [&](const Attribute& a) { return a.name == name; });
  };
  std::vector<std::string> wanted;
  for (const std::string& name : names) {
    const std::size_t before = wanted.size();
    const auto add = [&](std::string_view one) {
      if (offered(one)) wanted.emplace_back(one);
    };
    add(name);
    if (wanted.size() == before && name == "normals")
      std::for_each(normal_names.begin(), normal_names.end(), add);
    if (wanted.size() == before && name == "colors") {
      for (const Attribute& attribute : offer.scalars) {
        if (component_named(attribute.name)) wanted.push_back(attribute.name);
      }
    }
    if (wanted.size() == before) refuse_name(name, offer, input);
  }
  return wanted;
}

// Each name once, in the order of their first.
class DistinctNames {
 public:
  explicit DistinctNames(std::vector<std::string>& names) : names_(names) {}
  void add(const std::string& name) {
    if (known_.insert(name).second) names_.push_back(name);
  }

 private:
  std::vector<std::string>& names_;
  std::set<std::string> known_;
};

}  // namespace

AvailableAttributes common_offer(const std::vector<AvailableAttributes>& offers) {
  struct Found {
    std::size_t offers = 0;  // that have it
    const AvailableAttributes* last = nullptr;
    bool light = true;  // in all of them
  };
  std::map<std::pair<std::string, NumberType>, Found> found;
  for (const AvailableAttributes& offer : offers) {
    for (const Attribute& attribute : offer.scalars) {
      Found& one = found[{attribute.name, attribute.type}];
      if (one.last == &offer) continue;
      one.last = &offer;
      ++one.offers;
      one.light = one.light && attribute.kind == AttributeKind::light;
    }
  }
  AvailableAttributes common;
  DistinctNames not_common(common.not_common), lists(common.lists), of_faces(common.of_faces),
      of_nothing(common.of_nothing), unread(common.unread);
  for (const AvailableAttributes& offer : offers) {
    for (const Attribute& attribute : offer.scalars) {
      const Found& one = found[{attribute.name, attribute.type}];
      if (one.offers != offers.size()) {
        not_common.add(attribute.name);
      } else if (&offer == offers.data()) {
        common.scalars.push_back({attribute.name, attribute.type,
                                  one.light ? AttributeKind::light : AttributeKind::value});
      }
    }
    for (const std::string& name : offer.lists) lists.add(name);
    for (const std::string& name : offer.of_faces) of_faces.add(name);
    for (const std::string& name : offer.of_nothing) of_nothing.add(name);
    for (const std::string& name : offer.unread) unread.add(name);
  }
  return common;
}

AttributeSelection choose_attributes(const AttributeRequest& wish, const AvailableAttributes& offer,
                                     const std::string& input) {
  AttributeSelection choice;
  if (wish.none()) return choice;
  std::vector<std::string> wanted;
  if (wish.names) wanted = wanted_names(*wish.names, offer, input);
  // Two of three components are no normal.
  const bool whole_normals =
      !wish.names || std::all_of(normal_names.begin(), normal_names.end(),
                                 [&](std::string_view name) { return among(wanted, name); });
  std::vector<Attribute> asked;
  std::vector<std::size_t> scalars;
  for (std::size_t i = 0; i < offer.scalars.size(); ++i) {
    if (wish.names && !among(wanted, offer.scalars[i].name)) continue;
    Attribute& attribute = asked.emplace_back(offer.scalars[i]);
    attribute.kind = kind_of(attribute, offer.scalars);
    if (attribute.kind == AttributeKind::normal && !whole_normals)
      attribute.kind = AttributeKind::value;
    scalars.push_back(i);
  }
  Dropped dropped;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Attribute& attribute = asked[i];
    std::string refusal;
    if (wish.refusal) refusal = wish.refusal(attribute, asked);
    if (refusal.empty() && wish.averaged && !wish.names && among(texture_names, attribute.name))
      refusal = "texture coordinates, which have seams:";
    if (refusal.empty() && choice.carried.size() == most_attributes) {
      refusal = "more than " + std::to_string(most_attributes) + " attributes:";
      if (wish.names) {
        throw Error(ErrorKind::usage, "`attributes` takes at most " +
                                          std::to_string(most_attributes) + " properties");
      }
    }
    if (!refusal.empty()) {
      dropped.add(refusal, attribute.name);
      continue;
    }
    choice.carried.push_back(attribute);
    if (attribute.kind == AttributeKind::value || attribute.kind == AttributeKind::label)
      choice.carried.back().no_data = wish.no_data;
    choice.scalar.push_back(scalars[i]);
  }
  // Nor where one was too many.
  const auto normals =
      std::count_if(choice.carried.begin(), choice.carried.end(),
                    [](const Attribute& a) { return a.kind == AttributeKind::normal; });
  for (Attribute& attribute : choice.carried) {
    if (attribute.kind == AttributeKind::normal && normals != 3)
      attribute.kind = AttributeKind::value;
  }
  if (!wish.names) {
    for (const std::string& name : offer.lists) dropped.add("lists at vertices:", name);
    for (const std::string& name : offer.of_faces) dropped.add("properties of faces:", name);
    for (const std::string& name : offer.of_nothing) dropped.add("other elements:", name);
    for (const std::string& name : offer.not_common)
      dropped.add("not in every input, or not of one type:", name);
    for (const std::string& name : offer.unread) dropped.add("not read from this format:", name);
  }
  choice.dropped = dropped.lines();
  return choice;
}

}  // namespace winnow
