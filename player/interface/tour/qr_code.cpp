#include "player/interface/tour/qr_code.h"

#include <qrencode.h>

#include <memory>

namespace vantage {

QrCode qr_code(const std::string& text) {
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(
        QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_M), QRcode_free);
    QrCode out;
    if (!made) return out;
    out.size = made->width;
    for (int i = 0; i < out.size * out.size; ++i) out.modules.push_back(made->data[i] & 1);
    return out;
}

}  // namespace vantage
