// SPDX-License-Identifier: Apache-2.0
// The file is text: a line of kind and version, then words each followed by its values, last a checksum of
// all bytes before it, lines ending with LF. Numbers have the digits that reproduce them.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <set>

#include "base/format.h"
#include "base/read_file.h"
#include "jprim/base/error.h"
#include "jprim/flexible/modal_basis.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/eigenvalues.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Vec3;

namespace {

constexpr std::string_view Kind = "jprim-modes";
constexpr int Version = 1;
constexpr std::string_view ChecksumWord = "checksum ";
constexpr double Largest = 1e100;  // of all numbers, so that their squares and products are numbers too

// FNV-1a, 64 bits: http://www.isthe.com/chongo/tech/comp/fnv
std::uint64_t calcChecksum(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const unsigned char byte : text) hash = (hash ^ byte) * 0x100000001b3u;
    return hash;
}

// Copies by way of Windows end lines with CR LF.
std::string endLinesWithLf(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r' || i + 1 == text.size() || text[i + 1] != '\n') result += text[i];
    return result;
}

//------------------------------------------------------------------------------------------ writing
class Writer {
public:
    void write(const ModalBasis& b) {
        add("{} {}\nname {}\n", Kind, Version, b.name);
        add("modes {}\nnodes {}\ninterfaces {}", b.getNumModes(), b.nodes.size(), b.interfaces.size());
        for (const int id : b.interfaces) add(" {}", id);
        add("\nmass {}\ncenter", b.rigid.mass);
        addVector(b.rigid.center);
        add("inertia");
        addSymmetric(b.rigid.inertia);
        add("frequencies\n");
        for (const double frequency : b.frequencies) add("{}\n", frequency);
        add("inertia_change\n");
        for (const Mat33& change : b.inertiaChange) addSymmetric(change);
        add("gyroscopic\n");
        for (const Vec3& n : b.gyroscopic) addVector(n);
        for (const ModalNode& node : b.nodes) {
            add("node {}", node.id);
            addVector(node.position);
            for (int k = 0; k < b.getNumModes(); ++k) {
                const Vec3 &t = node.translation[k], &r = node.rotation[k];
                add("{} {} {} {} {} {}\n", t[0], t[1], t[2], r[0], r[1], r[2]);
            }
        }
        add("{}{:016x}\n", ChecksumWord, calcChecksum({m_text.data(), m_text.size()}));
    }

    const std::string& getText() const { return m_text; }

private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, const Arguments&... arguments) {
        appendText(m_text, format, arguments...);
    }
    void addVector(const Vec3& v) { add(" {} {} {}\n", v[0], v[1], v[2]); }
    void addSymmetric(const Mat33& m) {
        add(" {} {} {} {} {} {}\n", m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2));
    }

    std::string m_text;
};

//------------------------------------------------------------------------------------------ reading
class Reader {
public:
    Reader(std::string_view text, const std::string& file) : m_text(text), m_file(file) {}

    ModalBasis read() {
        readKind();
        checkSum();
        ModalBasis b;
        expect("name");
        b.name = std::string(takeLine());
        expect("modes");
        const int modes = takeCount();
        expect("nodes");
        const int nodes = takeCount();
        expect("interfaces");
        for (int left = takeCount(); left > 0; --left) b.interfaces.push_back(take<int>());
        expect("mass");
        b.rigid.mass = takePositive("a mass");
        expect("center");
        b.rigid.center = takeVector();
        expect("inertia");
        b.rigid.inertia = takeInertia();
        expect("frequencies");
        for (int k = 0; k < modes; ++k) b.frequencies.push_back(takePositive("a frequency"));
        expect("inertia_change");
        for (int k = 0; k < modes; ++k) b.inertiaChange.push_back(takeSymmetric());
        expect("gyroscopic");
        for (std::int64_t left = std::int64_t(modes) * (modes - 1) / 2; left > 0; --left)
            b.gyroscopic.push_back(takeVector());
        for (int i = 0; i < nodes; ++i) b.nodes.push_back(takeNode(modes));
        expect("checksum");
        checkIds(b);
        checkCenter(b);
        return b;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("{}:{}", m_file, m_line), what);
    }

    void readKind() {
        if (takeWord() != Kind)
            throw Error(m_file,
                        "is not a file of modes; `jprim reduce` makes one from a finite-element mesh");
        if (const int version = take<int>(); version != Version)
            throw Error(m_file,
                        fmt::format("has version {}; this program reads version {}", version, Version));
    }

    void checkSum() const {
        constexpr std::size_t digits = 16;
        const std::size_t at = m_text.rfind("\n" + std::string(ChecksumWord)) + 1;  // 0 if there is none
        const std::size_t end = at + ChecksumWord.size() + digits;
        if (at == 0 || m_text.size() < end)
            throw Error(m_file, "is cut off; copy it again or make it again with `jprim reduce`");
        const std::uint64_t checksum = calcChecksum(m_text.substr(0, at));
        if (m_text.substr(at, end - at) != fmt::format("{}{:016x}", ChecksumWord, checksum))
            throw Error(m_file,
                        "has been changed since it was written (its checksum does not fit); copy it "
                        "again or make it again with `jprim reduce`");
        std::string_view rest = m_text.substr(end);
        if (!rest.empty() && rest.front() == '\n') rest.remove_prefix(1);  // editors may leave it out
        if (!rest.empty())
            throw Error(m_file,
                        fmt::format("goes on after its last line, the checksum, for {} byte{}; delete what "
                                    "is too much",
                                    rest.size(), rest.size() == 1 ? "" : "s"));
    }

    // Ids that nodes have once, and interfaces that are nodes.
    void checkIds(const ModalBasis& b) const {
        std::set<int> ids;
        for (const ModalNode& node : b.nodes)
            if (!ids.insert(node.id).second)
                throw Error(m_file, fmt::format("node {} is given twice", node.id));
        std::set<int> others;
        for (const int id : b.interfaces) {
            if (ids.count(id) == 0) throw Error(m_file, fmt::format("interface {} is none of the nodes", id));
            if (!others.insert(id).second)
                throw Error(m_file, fmt::format("interface {} is given twice", id));
        }
    }

    // Nodes are parts of the body, which is about as large as its radius of gyration.
    void checkCenter(const ModalBasis& b) const {
        constexpr double Absurd = 1000;
        double nearest = SimTK::Infinity, size = std::sqrt(b.rigid.inertia.trace() / b.rigid.mass);
        for (const ModalNode& node : b.nodes) {
            nearest = std::min(nearest, double((node.position - b.rigid.center).norm()));
            size = std::max(size, double((node.position - b.nodes.front().position).norm()));
        }
        if (b.nodes.empty() || nearest <= Absurd * size) return;
        throw Error(m_file,
                    fmt::format("the mass centre is {:.3g} m away from all nodes of a body of {:.3g} m",
                                nearest, size));
    }

    std::string_view takeWord() {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\n'))
            if (m_text[m_at++] == '\n') ++m_line;
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && m_text[m_at] != ' ' && m_text[m_at] != '\n') ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    // The rest of the line after one blank.
    std::string_view takeLine() {
        const std::size_t begin = m_at + 1;
        m_at = std::min(m_text.find('\n', m_at), m_text.size());
        return begin < m_at ? m_text.substr(begin, m_at - begin) : std::string_view();
    }

    void expect(std::string_view word) {
        if (const std::string_view found = takeWord(); found != word)
            fail(fmt::format("'{}' is expected, not '{}'", word, found));
    }

    template <class Number>
    Number take() {
        const std::string_view word = takeWord();
        Number value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            fail(fmt::format("a number is expected, not '{}'", word));
        if (!std::isfinite(double(value))) fail(fmt::format("a finite number is expected, not '{}'", word));
        if (std::abs(double(value)) > Largest) fail(fmt::format("{} is too large to calculate with", word));
        return value;
    }

    double takePositive(const char* what) {
        const double value = take<double>();
        if (!(value > 0)) fail(fmt::format("{} is {}; it must be positive", what, value));
        if (value < 1 / Largest) fail(fmt::format("{} is {}, too small to calculate with", what, value));
        return value;
    }

    int takeCount() {
        const int count = take<int>();
        if (count < 0) fail(fmt::format("{} is no number of things", count));
        return count;
    }

    Vec3 takeVector() {
        Vec3 v;
        for (int k = 0; k < 3; ++k) v[k] = take<double>();
        return v;
    }

    Mat33 takeSymmetric() {
        const Vec3 d = takeVector(), o = takeVector();
        return Mat33(d[0], o[0], o[1], o[0], d[1], o[2], o[1], o[2], d[2]);
    }

    // Principal moments are positive, but for a rod's own axis, and none exceeds the sum of the other two.
    Mat33 takeInertia() {
        constexpr double Rounding = 1e-9;  // of the largest moment
        const Mat33 I = takeSymmetric();
        const Eigen::Vector3d m = calcPrincipalValues(toEigen(I));
        if (!(m[0] >= -Rounding * m[2] && m[1] > 0))
            fail(fmt::format(
                "the inertia has the principal moments {:.6g}, {:.6g}, {:.6g}; they must be positive", m[0],
                m[1], m[2]));
        if (!(m[2] <= m[0] + m[1] + Rounding * m[2]))
            fail(fmt::format(
                "the inertia is impossible: its largest principal moment {:.6g} exceeds the sum of "
                "the others, {:.6g} and {:.6g}",
                m[2], m[1], m[0]));
        return I;
    }

    ModalNode takeNode(int modes) {
        expect("node");
        ModalNode node;
        node.id = take<int>();
        node.position = takeVector();
        for (int k = 0; k < modes; ++k) {
            node.translation.push_back(takeVector());
            node.rotation.push_back(takeVector());
        }
        return node;
    }

    std::string_view m_text;
    std::string m_file;
    std::size_t m_at = 0;
    int m_line = 1;
};

}  // namespace

void saveModalBasis(const ModalBasis& basis, const std::string& file) {
    Writer writer;
    writer.write(basis);
    std::ofstream stream(file, std::ios::binary);
    stream.write(writer.getText().data(), std::streamsize(writer.getText().size()));
    stream.close();
    if (!stream) throw Error(file, "cannot be written");
}

ModalBasis loadModalBasis(const std::string& file) {
    const std::optional<std::string> text = readFile(file);
    if (!text) throw Error(file, "cannot be opened");
    return Reader(endLinesWithLf(*text), file).read();
}

}  // namespace jprim
