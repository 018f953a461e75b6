// In the place of compare.cpp in a library without that part.
#include <winnow/compare.hpp>
#include <winnow/compare_sequence.hpp>
#include <winnow/parts.hpp>

namespace winnow {

CompareReport compare(Context& /*context*/, const std::string& /*original*/,
                      const std::string& /*simplified*/, const CompareOptions& /*options*/) {
  throw MissingPart(Part::compare, "Meshes cannot be compared");
}

SequenceComparison compare_sequence(Context& /*context*/,
                                    const std::vector<std::string>& /*originals*/,
                                    const std::vector<std::string>& /*simplified*/,
                                    std::uint64_t /*samples*/) {
  throw MissingPart(Part::compare, "Sequences cannot be compared");
}

SequenceComparison compare_sequence(Context& /*context*/,
                                    const std::vector<std::string>& /*originals*/,
                                    const std::vector<std::string>& /*simplified*/,
                                    const CompareOptions& /*options*/) {
  throw MissingPart(Part::compare, "Sequences cannot be compared");
}

}  // namespace winnow
