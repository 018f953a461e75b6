// What vertices carry besides their positions, as the options ask for it.
#pragma once

#include <winnow/simplify.hpp>

#include "base/attribute.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"
#include "write/mesh_encoder.hpp"

namespace winnow {

// `encoder` must live as long as the wish.
AttributeRequest wish_for(const SimplifyOptions& options, const MeshEncoder& encoder);

// Whether vertices have a normal besides what they carry: one that is carried where the format
// writes them so, or else, with `computed`, that of their faces, unless its names are taken.
bool writes_normals(std::span<const Attribute> attributes, const MeshEncoder& encoder,
                    bool computed);

// "red (uchar)", of each that is carried.
std::vector<std::string> descriptions(const AttributeSelection& choice);

// Notes what is not carried.
void note_dropped(Job& job, const AttributeSelection& choice);

// Of colours as reals what all of a component is, by the largest of them: 1, or 255 or 65535 where
// some are above 2. Notes that, and where some are above that.
void settle_colors(Job& job, std::vector<Attribute>& attributes,
                   const std::vector<MeshReader::AttributeRange>& ranges);

// What the reader carries, and what is told of it; notes what is not carried. To be called before
// any faces are read.
struct TakenAttributes {
  CarriedAttributes carried;
  SimplifyReport::Attributes report;
};
TakenAttributes take_attributes(Job& job, MeshReader& reader);

// From means, or what is stored, to what is written, in place: light to colours, normals of means
// as long as 1; these become the vertex's normal where the shape has one besides. Where they cancel
// out the vertex's normal stands in for their mean. The vertex holds `values` from now on.
void finish_attributes(const MeshShape& shape, std::span<double> values, MeshVertex& vertex);

}  // namespace winnow
