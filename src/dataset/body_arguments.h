// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_BODY_ARGUMENTS_H_
#define JPRIM_SRC_DATASET_BODY_ARGUMENTS_H_

#include <initializer_list>
#include <vector>

#include "dataset/statement_reader.h"

/// @file
/// What PART, POINT_MASS, FLEX_BODY and MARKER have in common.
namespace jprim {

/// X, Y, Z, PSI, THETA, PHI, in the order of PartCoordinate.
const std::vector<Word>& getCoordinateNames();

/// The arguments of a body that does not turn: those of its RigidCoordinates that it has, and its own. EXACT
/// takes the coordinates listed, which are the first ones of getCoordinateNames().
template <class Body>
ArgumentTable<Body> makePointTable(const std::vector<Word>& coordinates,
                                   std::initializer_list<typename ArgumentTable<Body>::Row> own) {
    using Kind = ArgumentKind;
    using B = Body;
    using V = ArgumentValue;
    ArgumentTable<B> table = {
        {ArgumentRule("QG", Kind::Real).of(3), [](B& b, const V& v) { b.qg = v.getTriple(); }},
        {ArgumentRule("REULER", Kind::Angle).of(3), [](B& b, const V& v) { b.reuler = v.getTriple(); }},
        {ArgumentRule("ZG", Kind::Real).of(3), [](B& b, const V& v) { b.zg = v.getTriple(); }},
        {ArgumentRule("XG", Kind::Real).of(3), [](B& b, const V& v) { b.xg = v.getTriple(); }},
        {{"VX", Kind::Real, ExactOnly}, [](B& b, const V& v) { b.v[0] = v.getNumber(); }},
        {{"VY", Kind::Real, ExactOnly}, [](B& b, const V& v) { b.v[1] = v.getNumber(); }},
        {{"VZ", Kind::Real, ExactOnly}, [](B& b, const V& v) { b.v[2] = v.getNumber(); }},
        {ArgumentRule("EXACT", Kind::Words).among(coordinates), [](B& b, const V& v) {
             for (const std::size_t word : v.words) b.exact[word] = true;
         }}};
    table.add(own);
    return table;
}

/// The arguments of a body that turns.
template <class Body>
ArgumentTable<Body> makeBodyTable(std::initializer_list<typename ArgumentTable<Body>::Row> own) {
    using Kind = ArgumentKind;
    using B = Body;
    using V = ArgumentValue;
    ArgumentTable<B> table =
        makePointTable<B>(getCoordinateNames(),
                          {{{"WX", Kind::Angle, ExactOnly}, [](B& b, const V& v) { b.w[0] = v.getNumber(); }},
                           {{"WY", Kind::Angle, ExactOnly}, [](B& b, const V& v) { b.w[1] = v.getNumber(); }},
                           {{"WZ", Kind::Angle, ExactOnly}, [](B& b, const V& v) { b.w[2] = v.getNumber(); }},
                           {{"VM", Kind::Marker, ExactOnly}, [](B& b, const V& v) { b.vm = v.getId(); }},
                           {{"WM", Kind::Marker, ExactOnly}, [](B& b, const V& v) { b.wm = v.getId(); }}});
    table.add(own);
    return table;
}

/// A mass is not negative, and has a centre.
void checkMass(StatementReader& reader, const std::optional<double>& mass, int cm);

/// Of two arguments that say the same thing only one may be given.
void checkNotBoth(StatementReader& reader, const char* name, const char* other);

/// Euler angles and points are two ways to say the same thing.
void checkOrientation(StatementReader& reader, const char* z, const char* x);

}  // namespace jprim

#endif
