// A strict reader of the XML that figures are written in, for tests: tags must balance.
#pragma once

#include <cctype>
#include <cstddef>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ucvt::oracle {

struct SvgElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;
  std::string group;  ///< class of the nearest group around it that has one

  [[nodiscard]] double number(const std::string& key) const {
    return std::stod(attributes.at(key));
  }
};

inline std::string unescaped(const std::string& s) {
  static const std::map<std::string, char> entities{
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}};
  std::string out;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i] == '<' || s[i] == '"') {
      throw std::runtime_error("bare markup in: " + s);
    }
    if (s[i] != '&') {
      out += s[i];
      continue;
    }
    const std::size_t end = s.find(';', i);
    out += entities.at(s.substr(i + 1, end - i - 1));
    i = end;
  }
  return out;
}

/// One tag's name and attributes, from the text between its brackets.
inline SvgElement read_tag(const std::string& tag) {
  SvgElement out;
  std::size_t i = 0;
  while (i < tag.size() && (std::isalnum(static_cast<unsigned char>(tag[i])) != 0)) {
    out.name += tag[i++];
  }
  while (i < tag.size()) {
    if (tag[i] != ' ') {
      throw std::runtime_error("no space before attribute in: " + tag);
    }
    const std::size_t equals = tag.find("=\"", i);
    const std::size_t end = equals == std::string::npos ? equals : tag.find('"', equals + 2);
    if (end == std::string::npos) {
      throw std::runtime_error("attribute without value: " + tag);
    }
    const std::string key = tag.substr(i + 1, equals - i - 1);
    const std::string value = unescaped(tag.substr(equals + 2, end - equals - 2));
    if (!out.attributes.emplace(key, value).second) {
      throw std::runtime_error("attribute twice in: " + tag);
    }
    i = end + 1;
  }
  return out;
}

/// All elements in their order. Throws when the text is not one well-formed element.
inline std::vector<SvgElement> read_svg(const std::string& svg) {
  std::vector<SvgElement> out;
  std::vector<std::size_t> open;
  std::size_t i = svg.find("?>");
  if (svg.rfind("<?xml ", 0) != 0 || i == std::string::npos) {
    throw std::runtime_error("no XML declaration");
  }
  i += 2;
  while (true) {
    const std::size_t from = svg.find('<', i);
    const std::string text = svg.substr(i, from == std::string::npos ? from : from - i);
    if (!open.empty()) {
      out[open.back()].text += unescaped(text);
    } else if (text.find_first_not_of(" \n") != std::string::npos) {
      throw std::runtime_error("text outside of the root element");
    }
    if (from == std::string::npos) {
      break;
    }
    const std::size_t to = svg.find('>', from);
    if (to == std::string::npos) {
      throw std::runtime_error("tag without end");
    }
    std::string tag = svg.substr(from + 1, to - from - 1);
    i = to + 1;
    if (tag[0] == '/') {
      if (open.empty() || out[open.back()].name != tag.substr(1)) {
        throw std::runtime_error("closing tag does not match: " + tag);
      }
      open.pop_back();
      continue;
    }
    const bool alone = tag.back() == '/';
    if (alone) {
      tag.pop_back();
    }
    if (open.empty() && !out.empty()) {
      throw std::runtime_error("two root elements");
    }
    SvgElement e = read_tag(tag);
    for (const std::size_t k : open) {
      if (out[k].attributes.count("class") > 0) {
        e.group = out[k].attributes.at("class");
      }
    }
    out.push_back(e);
    if (!alone) {
      open.push_back(out.size() - 1);
    }
  }
  if (!open.empty()) {
    throw std::runtime_error("element not closed: " + out[open.back()].name);
  }
  return out;
}

/// The elements of one name in the groups of one class.
inline std::vector<SvgElement> in_group(const std::string& svg, const std::string& group,
                                        const std::string& name) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : read_svg(svg)) {
    if (e.group == group && e.name == name) {
      out.push_back(e);
    }
  }
  return out;
}

struct PathStep {
  char command = 'M';
  double radius = 0;
  bool clockwise = false;
  double x = 0, y = 0;
};

/// The steps of path data of M, L, A (small circular arcs) and Z, as figures use them.
inline std::vector<PathStep> read_path(const std::string& data) {
  std::istringstream in(data);
  std::vector<PathStep> out;
  for (PathStep s; in >> s.command;) {
    double ry = 0, rotation = 0;
    int large = 0, sweep = 0;
    if (s.command == 'A') {
      in >> s.radius >> ry >> rotation >> large >> sweep;
      s.clockwise = sweep == 1;
      if (ry != s.radius || large != 0) {
        throw std::runtime_error("not a small circular arc");
      }
    }
    if (s.command != 'Z') {
      in >> s.x >> s.y;
    }
    if (!in) {
      throw std::runtime_error("bad path data: " + data);
    }
    out.push_back(s);
  }
  return out;
}

}  // namespace ucvt::oracle
