// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_BODY_ARGUMENTS_H_
#define JPRIM_SRC_DATASET_BODY_ARGUMENTS_H_

#include <initializer_list>
#include <vector>

#include "dataset/statement_reader.h"

/// @file
/// What PART, FLEX_BODY and MARKER have in common.
namespace jprim {

/// X, Y, Z, PSI, THETA, PHI, in the order of PartCoordinate.
const std::vector<Word>& getCoordinateNames();

/// The arguments of a body: those of its RigidCoordinates, and its own.
template <class Body>
ArgumentTable<Body> makeBodyTable(std::initializer_list<typename ArgumentTable<Body>::Row> own) {
    using Kind = ArgumentKind;
    using B = Body;
    using V = ArgumentValue;
    ArgumentTable<B> table = {
        {ArgumentRule("QG", Kind::Real).of(3), [](B& b, const V& v) { b.qg = v.getTriple(); }},
        {ArgumentRule("REULER", Kind::Angle).of(3), [](B& b, const V& v) { b.reuler = v.getTriple(); }},
        {ArgumentRule("ZG", Kind::Real).of(3), [](B& b, const V& v) { b.zg = v.getTriple(); }},
        {ArgumentRule("XG", Kind::Real).of(3), [](B& b, const V& v) { b.xg = v.getTriple(); }},
        {{"VX", Kind::Real, ExactOnly}, [](B& b, const V& v) { b.v[0] = v.numbers[0]; }},
        {{"VY", Kind::Real, ExactOnly}, [](B& b, const V& v) { b.v[1] = v.numbers[0]; }},
        {{"VZ", Kind::Real, ExactOnly}, [](B& b, const V& v) { b.v[2] = v.numbers[0]; }},
        {{"WX", Kind::Angle, ExactOnly}, [](B& b, const V& v) { b.w[0] = v.numbers[0]; }},
        {{"WY", Kind::Angle, ExactOnly}, [](B& b, const V& v) { b.w[1] = v.numbers[0]; }},
        {{"WZ", Kind::Angle, ExactOnly}, [](B& b, const V& v) { b.w[2] = v.numbers[0]; }},
        {{"VM", Kind::Marker, ExactOnly}, [](B& b, const V& v) { b.vm = v.id; }},
        {{"WM", Kind::Marker, ExactOnly}, [](B& b, const V& v) { b.wm = v.id; }},
        {ArgumentRule("EXACT", Kind::Words).among(getCoordinateNames()), [](B& b, const V& v) {
             for (std::size_t i = 0; i < b.exact.size(); ++i) b.exact[i] = (v.words >> i) & 1u;
         }}};
    table.add(own);
    return table;
}

/// Of two arguments that say the same thing only one may be given.
void checkNotBoth(StatementReader& reader, const char* name, const char* other);

/// Euler angles and points are two ways to say the same thing.
void checkOrientation(StatementReader& reader, const char* z, const char* x);

}  // namespace jprim

#endif
