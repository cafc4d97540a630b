// SPDX-License-Identifier: Apache-2.0
// JPRIM and JOINT: a type and two markers.
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

// A type's row is its value in the enumeration, so the types come first, in that order.
template <class Statement>
void setType(Statement& s, const V& v) {
    s.type = static_cast<decltype(s.type)>(v.row);
}
template <class Statement>
void setI(Statement& s, const V& v) {
    s.i = v.id;
}
template <class Statement>
void setJ(Statement& s, const V& v) {
    s.j = v.id;
}

constexpr ArgumentRule type(std::string_view name, std::size_t minimum = 1) {
    return ArgumentRule(name, Kind::Choice, minimum).required();
}
constexpr ArgumentRule endMarker(std::string_view name) {
    return ArgumentRule(name, Kind::Marker, ExactOnly).required().on(MarkerLink::OtherPart);
}

const ArgumentTable<JprimStatement>& getJprimTable() {
    using J = JprimStatement;
    static const ArgumentTable<J> table = {{type("ATPOINT"), setType<J>},
                                           {type("INLINE", 3), setType<J>},
                                           {type("INPLANE", 3), setType<J>},
                                           {type("ORIENTATION"), setType<J>},
                                           {type("PARALLEL_AXES", 2), setType<J>},
                                           {type("PERPENDICULAR", 2), setType<J>},
                                           {endMarker("I"), setI<J>},
                                           {endMarker("J"), setJ<J>}};
    return table;
}

const ArgumentTable<JointStatement>& getJointTable() {
    using J = JointStatement;
    static const ArgumentTable<J> table = {{type("SPHERICAL"), setType<J>},
                                           {type("REVOLUTE"), setType<J>},
                                           {type("CYLINDRICAL"), setType<J>},
                                           {type("TRANSLATIONAL"), setType<J>},
                                           {type("PLANAR", 2), setType<J>},
                                           {type("FIXED"), setType<J>},
                                           {type("UNIVERSAL"), setType<J>},
                                           {type("HOOKE"), setType<J>},
                                           {endMarker("I"), setI<J>},
                                           {endMarker("J"), setJ<J>},
                                           {{"CONVEL", Kind::Unsupported, 2}, nullptr},
                                           {{"SCREW", Kind::Unsupported}, nullptr},
                                           {{"RACKPIN", Kind::Unsupported}, nullptr},
                                           {{"PITCH", Kind::Unsupported, 2}, nullptr},
                                           {{"PD", Kind::Unsupported, ExactOnly}, nullptr},
                                           {{"IC", Kind::Unsupported, ExactOnly}, nullptr},
                                           {{"ICTRAN", Kind::Unsupported, 3}, nullptr},
                                           {{"ICROT", Kind::Unsupported, 3}, nullptr},
                                           // Friction of old files: zeros say that there is none.
                                           {{"DELTA_V", Kind::Zero}, nullptr},
                                           {{"MU_DYN_ROT", Kind::Zero, 8}, nullptr},
                                           {{"MU_STAT_ROT", Kind::Zero, 9}, nullptr},
                                           {{"MU_DYN_TRANS", Kind::Zero, 8}, nullptr},
                                           {{"MU_STAT_TRANS", Kind::Zero, 9}, nullptr},
                                           {{"MAX_FRIC_ROT", Kind::Zero, 10}, nullptr},
                                           {{"MAX_FRIC_TRANS", Kind::Zero, 10}, nullptr},
                                           {{"MAX_DEFORMATION", Kind::Zero, 5}, nullptr},
                                           {{"INNER_RADIUS", Kind::Zero, 2}, nullptr},
                                           {{"OUTER_RADIUS", Kind::Zero}, nullptr},
                                           {{"PIN_RADIUS", Kind::Zero, 3}, nullptr},
                                           {{"BALL_RADIUS", Kind::Zero}, nullptr},
                                           {{"HEIGHT", Kind::Zero, 2}, nullptr},
                                           {{"WIDTH", Kind::Zero}, nullptr},
                                           {{"PRELOAD_RADIAL", Kind::Zero, 9}, nullptr},
                                           {{"PRELOAD_AXIAL", Kind::Zero, 9}, nullptr},
                                           {{"PRELOAD_X", Kind::Zero, ExactOnly}, nullptr},
                                           {{"PRELOAD_Y", Kind::Zero, ExactOnly}, nullptr}};
    return table;
}

template <class Statement>
void readConnection(StatementReader& reader, const ArgumentTable<Statement>& table,
                    std::vector<Statement>& target) {
    Statement statement;
    statement.where = reader.getPosition();
    statement.id = reader.getId();
    reader.readArguments(table, statement);
    if (statement.id != 0) reader.registerId();
    if (!reader.hasErrors()) target.push_back(statement);
}

}  // namespace

void readJprim(StatementReader& reader) {
    readConnection(reader, getJprimTable(), reader.updState().dataset.jprims);
}

void readJoint(StatementReader& reader) {
    readConnection(reader, getJointTable(), reader.updState().dataset.joints);
}

}  // namespace jprim
