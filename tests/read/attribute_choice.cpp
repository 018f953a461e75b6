// Which attributes are carried, and what is said of the others.
#include "read/attribute_choice.hpp"

#include <winnow/error.hpp>

#include "support/job.hpp"

#include <algorithm>

namespace winnow::test {

namespace {

using Names = std::vector<std::string>;

AvailableAttributes offer() {
  AvailableAttributes offer;
  for (const char* name : {"nx", "ny", "nz", "quality"})
    offer.scalars.push_back({name, NumberType::float32});
  for (const char* name : {"red", "green", "blue"})
    offer.scalars.push_back({name, NumberType::uint8});
  for (const char* name : {"s", "t"}) offer.scalars.push_back({name, NumberType::float32});
  offer.lists = {"values"};
  offer.of_faces = {"flags"};
  offer.of_nothing = {"edge"};
  return offer;
}

AttributeRequest wish(const std::optional<Names>& names) {
  AttributeRequest wish;
  wish.names = names;
  return wish;
}

Names names_of(const AttributeSelection& choice) {
  Names names;
  for (const Attribute& attribute : choice.carried) names.push_back(attribute.name);
  return names;
}

}  // namespace

TEST_CASE("without names whatever has a mean is carried and the rest is told") {
  const AttributeSelection choice = choose_attributes(wish({}), offer(), "in");
  CHECK(names_of(choice) == Names{"nx", "ny", "nz", "quality", "red", "green", "blue"});
  CHECK(choice.scalar == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6});
  CHECK(choice.carried[0].kind == AttributeKind::normal);
  CHECK(choice.carried[3].kind == AttributeKind::value);
  CHECK(choice.carried[4].kind == AttributeKind::color);
  CHECK(choice.dropped == Names{"texture coordinates, which have seams: s, t",
                                "lists at vertices: values", "properties of faces: flags",
                                "other elements: edge"});
}

TEST_CASE("named attributes are carried in the order of the input") {
  const AttributeSelection choice =
      choose_attributes(wish(Names{"colors", "s", "quality"}), offer(), "in");
  CHECK(names_of(choice) == Names{"quality", "red", "green", "blue", "s"});
  CHECK(choice.dropped.empty());
  CHECK(names_of(choose_attributes(wish(Names{"normals"}), offer(), "in")) ==
        Names{"nx", "ny", "nz"});
  // One component alone is a number like any other.
  CHECK(choose_attributes(wish(Names{"nx"}), offer(), "in").carried[0].kind ==
        AttributeKind::value);
  CHECK(choose_attributes(wish(Names{}), offer(), "in").carried.empty());
}

TEST_CASE("what the output cannot hold is told with the reason") {
  AttributeRequest none = wish({});
  none.refusal = [](const Attribute&, std::span<const Attribute>) {
    return std::string("STL holds nothing:");
  };
  const AttributeSelection choice = choose_attributes(none, offer(), "in");
  CHECK(choice.carried.empty());
  CHECK(choice.dropped.front() == "STL holds nothing: nx, ny, nz, quality, red, green, blue, s, t");
}

TEST_CASE("a name that is none and too many names are usage errors") {
  const auto refused = [](const Names& names, const AvailableAttributes& from) {
    return error_of([&] { choose_attributes(wish(names), from, "in.ply"); });
  };
  CHECK(refused({"colour"}, offer()).kind() == ErrorKind::usage);
  CHECK_THAT(refused({"colour"}, offer()).what(), Catch::Contains("'in.ply'") &&
                                                      Catch::Contains("'colour'") &&
                                                      Catch::Contains("quality, red"));
  CHECK_THAT(refused({"values"}, offer()).what(), Catch::Contains("list"));
  CHECK_THAT(refused({"colors"}, {}).what(), Catch::Contains("none"));

  AvailableAttributes many;
  Names names;
  for (int i = 0; i < 17; ++i) {
    names.push_back("a" + std::to_string(i));
    many.scalars.push_back({names.back(), NumberType::int8});
  }
  CHECK(refused(names, many).kind() == ErrorKind::usage);
  const AttributeSelection choice = choose_attributes(wish({}), many, "in");
  CHECK(choice.carried.size() == most_attributes);
  CHECK(choice.dropped == Names{"more than 16 attributes: a16"});
}

TEST_CASE("several inputs offer together what all have by one name and type") {
  AvailableAttributes other = offer();
  std::reverse(other.scalars.begin(), other.scalars.end());
  other.scalars.push_back({"more", NumberType::uint8});
  other.scalars.erase(other.scalars.begin());  // t
  for (Attribute& attribute : other.scalars) {
    if (attribute.name == "quality") attribute.type = NumberType::float64;
  }
  other.unread = {"materials"};
  const AvailableAttributes common = common_offer({offer(), other});
  Names names;
  for (const Attribute& attribute : common.scalars) names.push_back(attribute.name);
  CHECK(names == Names{"nx", "ny", "nz", "red", "green", "blue", "s"});
  CHECK(common.not_common == Names{"quality", "t", "more"});
  CHECK(common.of_faces == Names{"flags"});
  const AttributeSelection choice = choose_attributes(wish({}), common, "in");
  CHECK(choice.dropped.back() == "not read from this format: materials");
  CHECK(choice.dropped[choice.dropped.size() - 2] ==
        "not in every input, or not of one type: quality, t, more");
  CHECK(common_offer({}).scalars.empty());
}

TEST_CASE("colours of different types are said to be none in common") {
  AvailableAttributes bytes, floats;
  bytes.scalars = {
      {"red", NumberType::uint8}, {"green", NumberType::uint8}, {"blue", NumberType::uint8}};
  floats.scalars = {{"red"}, {"green"}, {"blue"}};
  const AvailableAttributes common = common_offer({bytes, floats});
  const Error error = error_of([&] { choose_attributes(wish(Names{"colors"}), common, "in.ply"); });
  CHECK(std::string(error.what()) ==
        "'in.ply': 'colors' is not in every input, or not of one type; they have none "
        "in common: leave `attributes` out");
}

}  // namespace winnow::test
