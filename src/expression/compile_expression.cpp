// SPDX-License-Identifier: Apache-2.0
#include "expression/compile_expression.h"

#include <utility>

#include "base/format.h"
#include "base/numbers.h"
#include "base/spelling.h"
#include "base/text.h"
#include "expression/language.h"
#include "expression/lexer.h"

namespace jprim {
namespace {

constexpr int DeepestNesting = 200;
constexpr std::size_t LongestText = 100000;
constexpr std::size_t MostArguments = 64;

// Recursive descent: a method for each line of the grammar in the header. Each begins at its first token and
// ends behind its last.
class Parser {
public:
    Parser(std::string_view text, ProgramBuilder& builder, Vocabulary& vocabulary)
        : m_lexer(text), m_builder(builder), m_vocabulary(vocabulary), m_token(m_lexer.next()) {}

    Operand parse() {
        if (m_token.kind == Token::Kind::End) throw ExpressionError(0, "the expression is empty");
        const Operand result = parseSum();
        if (m_token.kind != Token::Kind::End) failAfterValue();
        return result;
    }

private:
    Operand parseSum();
    Operand parseProduct();
    Operand parseSigned();
    Operand parsePower();
    Operand parsePrimary();
    Operand parseVector();
    Operand parseName();
    std::vector<Argument> parseArguments(const std::string& function);
    Argument parseArgument();

    Operand combineTerms(const Token& sign, Operand a, Operand b);
    Operand combineFactors(const Token& sign, Operand a, Operand b, bool isDotProduct);
    Operand resolve(const Call& call);
    Operand accept(Operand value, const Token& origin) const;

    Token take() {
        m_lastOffset = m_token.offset;
        return std::exchange(m_token, m_lexer.next());
    }
    bool takeIf(std::string_view sign) { return m_token.is(sign) && (take(), true); }
    void close(const Token& bracket, std::string_view sign);
    [[noreturn]] void failBeforeValue() const;
    [[noreturn]] void failAfterValue() const;

    ExpressionLexer m_lexer;
    ProgramBuilder& m_builder;
    Vocabulary& m_vocabulary;
    Token m_token;                 // the next one
    std::size_t m_lastOffset = 0;  // of the one before
    int m_depth = 0;
};

[[noreturn]] void fail(const Token& at, const std::string& message) {
    throw ExpressionError(at.offset, message);
}

// Where a value should begin.
void Parser::failBeforeValue() const {
    if (m_token.kind == Token::Kind::End) fail(m_token, "a value is missing at the end of the expression");
    fail(m_token, fmt::format("a value is missing before {}", quote(m_token.text)));
}

// Where a value has ended and the next token does not go on.
void Parser::failAfterValue() const {
    if (m_token.kind != Token::Kind::Sign || m_token.is("(") || m_token.is("["))
        fail(m_token, fmt::format("an operator is missing before {}", quote(m_token.text)));
    if (m_token.is(":")) fail(m_token, "':' stands only after the first argument of IF");
    if (m_token.is(",")) fail(m_token, "',' stands only between arguments and between components");
    fail(m_token, fmt::format("{} closes no bracket", quote(m_token.text)));
}

void Parser::close(const Token& bracket, std::string_view sign) {
    if (takeIf(sign)) return;
    if (m_token.kind == Token::Kind::End) fail(bracket, quote(bracket.text) + " is not closed");
    if (m_token.is(")") || m_token.is("]"))
        fail(m_token, fmt::format("{} cannot close {}", quote(m_token.text), quote(bracket.text)));
    failAfterValue();
}

Operand Parser::accept(Operand value, const Token& origin) const {
    if (!m_builder.isFinite(value))
        fail(origin, fmt::format("the value of {} is not a finite number", quote(origin.text)));
    const std::string problem = m_vocabulary.findProblem(m_builder, value);
    if (!problem.empty()) fail(origin, problem);
    return value;
}

Operand Parser::parseSum() {
    Operand sum = parseProduct();
    while (m_token.is("+") || m_token.is("-")) {
        const Token sign = take();
        sum = combineTerms(sign, sum, parseProduct());
    }
    return sum;
}

Operand Parser::combineTerms(const Token& sign, Operand a, Operand b) {
    if (a.isVector != b.isVector)
        fail(sign, fmt::format("{} stands between a scalar and a vector", quote(sign.text)));
    return accept(sign.is("+") ? m_builder.add(a, b) : m_builder.subtract(a, b), sign);
}

Operand Parser::parseProduct() {
    Operand product = parseSigned();
    bool isDotProduct = false;
    while (m_token.is("*") || m_token.is("/") || m_token.is("%")) {
        const Token sign = take();
        const Operand factor = parseSigned();
        const Operand next = combineFactors(sign, product, factor, isDotProduct);
        isDotProduct = sign.is("*") && product.isVector && factor.isVector;
        product = next;
    }
    return product;
}

Operand Parser::combineFactors(const Token& sign, Operand a, Operand b, bool isDotProduct) {
    if (sign.is("*")) return accept(m_builder.multiply(a, b), sign);
    if (sign.is("/")) {
        if (b.isVector) fail(sign, "a vector cannot be a divisor");
        return accept(m_builder.divide(a, b), sign);
    }
    if (isDotProduct && b.isVector) fail(sign, "v*v%v is ambiguous; write v*(v%v)");
    if (!a.isVector || !b.isVector) fail(sign, "'%' is the cross product; it needs two vectors");
    return accept(m_builder.cross(a, b), sign);
}

// Every way deeper leads through here.
Operand Parser::parseSigned() {
    if (++m_depth > DeepestNesting + 1)
        fail(m_token, fmt::format("brackets and powers are nested more than {} deep", DeepestNesting));
    bool isNegative = false;
    while (m_token.is("+") || m_token.is("-")) isNegative ^= take().is("-");
    const Operand value = parsePower();
    --m_depth;
    return isNegative ? m_builder.negate(value) : value;
}

Operand Parser::parsePower() {
    const Operand base = parsePrimary();
    if (!m_token.is("**")) return base;
    const Token sign = take();
    const Operand exponent = parseSigned();
    if (base.isVector || exponent.isVector) fail(sign, "'**' takes scalars, not vectors");
    return accept(m_builder.power(base, exponent), sign);
}

Operand Parser::parsePrimary() {
    if (m_token.kind == Token::Kind::Number) return m_builder.number(take().value);
    if (m_token.kind == Token::Kind::Name) return parseName();
    if (m_token.is("[")) return parseVector();
    if (!m_token.is("(")) failBeforeValue();
    const Token bracket = take();
    const Operand value = parseSum();
    close(bracket, ")");
    return value;
}

Operand Parser::parseVector() {
    const Token bracket = take();
    std::vector<Operand> components;
    do {
        const Token begin = m_token;
        components.push_back(parseSum());
        if (components.back().isVector) fail(begin, "a component must be a scalar, not a vector");
    } while (components.size() < 3 && takeIf(","));
    if (components.size() < 3 ? m_token.is("]") : m_token.is(","))
        fail(bracket, "a vector has three components: [x, y, z]");
    close(bracket, "]");
    return m_builder.vector(components[0], components[1], components[2]);
}

Operand Parser::parseName() {
    const Token name = take();
    Call call{toUpperCase(name.text), name.offset, {}, m_token.is("(")};
    if (call.hasParentheses) call.arguments = parseArguments(call.name);
    return accept(resolve(call), name);
}

std::vector<Argument> Parser::parseArguments(const std::string& function) {
    const Token bracket = take();
    std::vector<Argument> arguments;
    if (takeIf(")")) return arguments;
    bool goesOn = true;
    while (goesOn) {
        if (arguments.size() == MostArguments)
            fail(m_token, fmt::format("a function takes no more than {} arguments", MostArguments));
        arguments.push_back(parseArgument());
        const bool isCondition = function == "IF" && arguments.size() == 1;
        if (isCondition && m_token.is(",")) fail(m_token, "IF has a colon here: IF(e: a, b, c)");
        goesOn = takeIf(isCondition ? ":" : ",");
    }
    close(bracket, ")");
    return arguments;
}

Argument Parser::parseArgument() {
    const Token begin = m_token;
    Argument argument{begin.offset, std::nullopt, parseSum()};
    if (m_lastOffset == begin.offset && begin.kind == Token::Kind::Number) {
        const Number<int> id = parseId(begin.text, 0);
        if (id.fault.empty()) argument.id = id.value;
    }
    return argument;
}

Operand Parser::resolve(const Call& call) {
    if (const auto value = callLanguage(m_builder, call, m_vocabulary)) return *value;
    if (const auto value = m_vocabulary.call(m_builder, call)) return *value;
    if (isKnownToAdamsOnly(call.name)) throw ExpressionError(call.offset, call.name + " is not supported");
    std::vector<std::string> names = m_vocabulary.getNames();
    const std::vector<std::string> own = getLanguageNames();
    names.insert(names.end(), own.begin(), own.end());
    throw ExpressionError(call.offset,
                          fmt::format("unknown {} {}{}", call.hasParentheses ? "function" : "name",
                                      quote(call.name), suggestNearest(names, call.name)));
}

}  // namespace

Operand compileExpression(std::string_view text, ProgramBuilder& builder, Vocabulary& vocabulary) {
    if (text.size() > LongestText)
        throw ExpressionError(LongestText, fmt::format("the expression has {} characters; the most is {}",
                                                       text.size(), LongestText));
    return Parser(text, builder, vocabulary).parse();
}

}  // namespace jprim
