// SPDX-License-Identifier: Apache-2.0
#include "expression/language.h"

#include <algorithm>

#include "base/format.h"
#include "expression/shaping.h"

namespace jprim {
namespace {

using SimTK::Real;
using Operands = std::vector<Operand>;

// What the entries of the table below work on.
struct Context {
    ProgramBuilder& builder;
    Vocabulary& vocabulary;
    const Call& call;

    Operand operator[](std::size_t i) const { return requireScalar(call, i); }
    Operands getFrom(std::size_t first) const {
        Operands rest;
        for (std::size_t i = first; i < call.arguments.size(); ++i) rest.push_back((*this)[i]);
        return rest;
    }
    // Argument i, or a number where it may be left out.
    Operand getOr(std::size_t i, Real absent) const {
        return i < call.arguments.size() ? (*this)[i] : builder.number(absent);
    }
    Operand subtract(std::size_t a, std::size_t b) const { return builder.subtract((*this)[a], (*this)[b]); }
};

using Build = Operand (*)(const Context&);
using BuildStep = Operand (*)(ProgramBuilder&, Operand, const StepCorners&);

template <Function F>
Operand buildFunction(const Context& c) {
    return c.builder.call(F, c[0]);
}

template <Operand (ProgramBuilder::*Method)(Operand, Operand)>
Operand buildOfTwo(const Context& c) {
    return (c.builder.*Method)(c[0], c[1]);
}

// NAME(x, x0, h0, x1, h1)
template <BuildStep Step>
Operand buildStepLike(const Context& c) {
    const StepCorners corners{c[1], c[2], c[3], c[4]};
    const ProgramBuilder& b = c.builder;
    if (b.isConstant(corners.x0) && b.isConstant(corners.x1) &&
        b.getConstant(corners.x0) == b.getConstant(corners.x1))
        throw ExpressionError(c.call.arguments[3].offset, "x0 and x1 of " + c.call.name + " must differ: " +
                                                              c.call.name + "(x, x0, h0, x1, h1)");
    return Step(c.builder, c[0], corners);
}

// NAME(x, z, id, order)
template <InterpolatingSpline::Method Method>
Operand buildSpline(const Context& c) {
    const int id = requireId(c.call, 2);
    const int order = c.call.arguments.size() > 3 ? requireId(c.call, 3) : 0;
    if (order > 2)
        throw ExpressionError(
            c.call.arguments[3].offset,
            fmt::format("the order of the derivative of {} is 0, 1 or 2, not {}", c.call.name, order));
    const InterpolatingSpline* spline = c.vocabulary.findSpline(id);
    if (!spline) throw ExpressionError(c.call.arguments[2].offset, fmt::format("there is no SPLINE/{}", id));
    return c.builder.curve(std::make_shared<SplineCurve>(*spline, Method, order), c[0], c[1]);
}

// UV(v)
Operand buildDirection(const Context& c) {
    const Argument& argument = c.call.arguments[0];
    if (!argument.value.isVector)
        throw ExpressionError(argument.offset, "the argument of UV must be a vector, not a scalar");
    return c.builder.normalize(argument.value);
}

constexpr std::size_t Coefficients = 31;  // a0 to a30

struct Entry {
    std::string_view name;
    std::size_t least, most;  // arguments
    Build build;
};

const Entry Entries[] = {
    {"TIME", 0, 0, [](const Context& c) { return c.builder.time(); }},
    {"PI", 0, 0, [](const Context& c) { return c.builder.number(SimTK::Pi); }},
    {"DTOR", 0, 0, [](const Context& c) { return c.builder.number(SimTK::Pi / 180); }},
    {"RTOD", 0, 0, [](const Context& c) { return c.builder.number(180 / SimTK::Pi); }},
    {"ABS", 1, 1, buildFunction<Function::Abs>},
    {"ACOS", 1, 1, buildFunction<Function::Acos>},
    {"AINT", 1, 1, buildFunction<Function::Aint>},
    {"ANINT", 1, 1, buildFunction<Function::Anint>},
    {"ASIN", 1, 1, buildFunction<Function::Asin>},
    {"ATAN", 1, 1, buildFunction<Function::Atan>},
    {"COS", 1, 1, buildFunction<Function::Cos>},
    {"COSH", 1, 1, buildFunction<Function::Cosh>},
    {"EXP", 1, 1, buildFunction<Function::Exp>},
    {"LOG", 1, 1, buildFunction<Function::Log>},
    {"LOG10", 1, 1, buildFunction<Function::Log10>},
    {"SIN", 1, 1, buildFunction<Function::Sin>},
    {"SINH", 1, 1, buildFunction<Function::Sinh>},
    {"SQRT", 1, 1, buildFunction<Function::Sqrt>},
    {"TAN", 1, 1, buildFunction<Function::Tan>},
    {"TANH", 1, 1, buildFunction<Function::Tanh>},
    {"ATAN2", 2, 2, buildOfTwo<&ProgramBuilder::atan2>},
    {"DIM", 2, 2, buildOfTwo<&ProgramBuilder::dim>},
    {"MAX", 2, 2, buildOfTwo<&ProgramBuilder::max>},
    {"MIN", 2, 2, buildOfTwo<&ProgramBuilder::min>},
    {"MOD", 2, 2, buildOfTwo<&ProgramBuilder::mod>},
    {"SIGN", 2, 2, buildOfTwo<&ProgramBuilder::sign>},
    {"IF", 4, 4, [](const Context& c) { return c.builder.select(c[0], c[1], c[2], c[3]); }},
    {"STEP", 5, 5, buildStepLike<buildStep>},
    {"STEP5", 5, 5, buildStepLike<buildStep5>},
    {"HAVSIN", 5, 5, buildStepLike<buildHavsin>},
    {"IMPACT", 7, 7,  // x, x', x1, k, e, cmax, d
     [](const Context& c) {
         return buildImpact(c.builder, c[0], c[1], c[2], {c[3], c[4], c[5], c[6]});
     }},
    {"BISTOP", 8, 8,  // x, x', x1, x2, k, e, cmax, d
     [](const Context& c) {
         return buildBistop(c.builder, c[0], c[1], c[2], c[3], {c[4], c[5], c[6], c[7]});
     }},
    {"POLY", 3, 2 + Coefficients,  // x, x0, a0, ...
     [](const Context& c) { return buildPolynomial(c.builder, c.subtract(0, 1), c.getFrom(2)); }},
    {"CHEBY", 3, 2 + Coefficients,
     [](const Context& c) { return buildChebyshev(c.builder, c.subtract(0, 1), c.getFrom(2)); }},
    {"FORCOS", 4, 3 + Coefficients,  // x, x0, w, a0, ...
     [](const Context& c) {
         const Operand u = c.builder.multiply(c[2], c.subtract(0, 1));
         return buildFourier(c.builder, Function::Cos, u, c.getFrom(3));
     }},
    {"FORSIN", 4, 3 + Coefficients,
     [](const Context& c) {
         const Operand u = c.builder.multiply(c[2], c.subtract(0, 1));
         return buildFourier(c.builder, Function::Sin, u, c.getFrom(3));
     }},
    {"SHF", 4, 6,  // x, x0, a, w, phi, b: a sin(w (x - x0) - phi) + b
     [](const Context& c) {
         ProgramBuilder& b = c.builder;
         const Operand angle = b.subtract(b.multiply(c[3], c.subtract(0, 1)), c.getOr(4, 0));
         return b.add(b.multiply(c[2], b.call(Function::Sin, angle)), c.getOr(5, 0));
     }},
    {"AKISPL", 3, 4, buildSpline<InterpolatingSpline::Method::Akima>},
    {"CUBSPL", 3, 4, buildSpline<InterpolatingSpline::Method::Cubic>},
    {"UV", 1, 1, buildDirection},
};

}  // namespace

std::optional<Operand> callLanguage(ProgramBuilder& builder, const Call& call, Vocabulary& vocabulary) {
    const auto entry = std::find_if(std::begin(Entries), std::end(Entries),
                                    [&](const Entry& e) { return e.name == call.name; });
    if (entry == std::end(Entries)) return std::nullopt;
    requireArguments(call, entry->least, entry->most);
    return entry->build({builder, vocabulary, call});
}

std::vector<std::string> getLanguageNames() {
    std::vector<std::string> names;
    for (const Entry& entry : Entries) names.emplace_back(entry.name);
    return names;
}

bool isKnownToAdamsOnly(std::string_view name) {
    static constexpr std::string_view names[] = {
        "ARRAY",  "ARYVAL", "BEAM",   "CLEARANCE", "CONTACT", "COUPLER", "CURVE",    "CVCV",
        "CVSF",   "DELAY",  "DIF",    "DIF1",      "FE_LOAD", "FIELD",   "FRICTION", "FXFREQ",
        "FXMODE", "GSE",    "INTERP", "INVPSD",    "LSE",     "MATRIX",  "MFORCE",   "MODE",
        "NFORCE", "PINVAL", "POUVAL", "PTCV",      "PTSF",    "SENVAL",  "SFSF",     "SURFACE",
        "SWEEP",  "TFSISO", "TIRE",   "UCON",      "USER"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace jprim
