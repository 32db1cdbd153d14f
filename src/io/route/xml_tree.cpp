#include <fmt/format.h>

#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "io/route/xml_tree_internal.h"
#include "mesh/base/error.h"

namespace swathplan::internal {
namespace {

template <class Use>
void each_child(const CPLXMLNode& node, Use use) {
  for (const CPLXMLNode* child = node.psChild; child != nullptr; child = child->psNext) use(*child);
}

}  // namespace

XmlTree xml_tree(std::string_view text, const std::string& file) {
  const QuietGdal quiet;
  XmlTree tree;
  tree.owned.reset(CPLParseXMLString(std::string(text).c_str()));
  for (const CPLXMLNode* node = tree.owned.get(); node != nullptr; node = node->psNext) {
    if (node->eType == CXT_Element && *node->pszValue != '?' && *node->pszValue != '!') {
      tree.root = node;
    }
  }
  if (tree.root == nullptr) {
    throw InvalidInput(
        fmt::format("'{}' is not complete XML{}; is it truncated?", file, QuietGdal::why()));
  }
  return tree;
}

std::string_view local_name(const CPLXMLNode& node) {
  if (node.eType != CXT_Element && node.eType != CXT_Attribute) return {};
  const std::string_view name(node.pszValue);
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<const CPLXMLNode*> children(const CPLXMLNode& node, std::string_view name) {
  std::vector<const CPLXMLNode*> found;
  each_child(node, [&](const CPLXMLNode& child) {
    if (child.eType == CXT_Element && (name.empty() || local_name(child) == name)) {
      found.push_back(&child);
    }
  });
  return found;
}

std::string_view attribute(const CPLXMLNode& node, std::string_view name) {
  std::string_view value;
  each_child(node, [&](const CPLXMLNode& child) {
    if (child.eType == CXT_Attribute && local_name(child) == name && child.psChild != nullptr) {
      value = child.psChild->pszValue;
    }
  });
  return value;
}

std::string_view text_in(const CPLXMLNode& node) {
  std::string_view text;
  each_child(node, [&](const CPLXMLNode& child) {
    if (child.eType == CXT_Text && text.empty()) text = trim(child.pszValue);
  });
  return text;
}

std::string_view text_of_child(const CPLXMLNode& node, std::string_view name) {
  const auto found = children(node, name);
  return found.empty() ? std::string_view() : text_in(*found.front());
}

}  // namespace swathplan::internal
