#pragma once
/// Bytes as text (RFC 4648).

#include <string>
#include <string_view>

namespace creepcontact::report {

std::string base64(std::string_view bytes);
/// "data:image/png;base64,..." @param type  "image/png"
std::string data_url(std::string_view type, std::string_view bytes);

}  // namespace creepcontact::report
