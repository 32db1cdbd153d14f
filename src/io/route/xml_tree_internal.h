#pragma once

#include <cpl_minixml.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan::internal {

/// The parts of an XML text.
struct XmlTree {
  std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)> owned{nullptr, &CPLDestroyXMLNode};
  const CPLXMLNode* root = nullptr;  ///< the outermost element
};

/// @throws InvalidInput that names `file`.
[[nodiscard]] XmlTree xml_tree(std::string_view text, const std::string& file);

/// The name of an element or attribute without a prefix; empty for other nodes.
[[nodiscard]] std::string_view local_name(const CPLXMLNode& node);
/// The children that are elements of that name, all elements for an empty one.
[[nodiscard]] std::vector<const CPLXMLNode*> children(const CPLXMLNode& node,
                                                      std::string_view name = {});
/// The value of an attribute; empty if it is missing.
[[nodiscard]] std::string_view attribute(const CPLXMLNode& node, std::string_view name);
/// The text of an element.
[[nodiscard]] std::string_view text_in(const CPLXMLNode& node);
/// The text of its first child of that name; empty if there is none.
[[nodiscard]] std::string_view text_of_child(const CPLXMLNode& node, std::string_view name);

}  // namespace swathplan::internal
