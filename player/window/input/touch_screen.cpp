#include "player/window/input/touch_screen.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <xcb/xinput.h>

#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

// GLFW's native access, declared without Xlib headers; missing in GLFW for Wayland.
extern "C" [[gnu::weak]] unsigned long glfwGetX11Window(GLFWwindow*);

namespace vantage {
namespace {

struct Disconnect {
    void operator()(xcb_connection_t* c) const { xcb_disconnect(c); }
};
using Connection = std::unique_ptr<xcb_connection_t, Disconnect>;

template <class T>
struct Free {
    void operator()(T* p) const { std::free(p); }
};
template <class T>
using Reply = std::unique_ptr<T, Free<T>>;

/// A connection that receives the window's touch events; empty if the server does not support them.
Connection listen_to_touches(xcb_window_t window) {
    Connection c(xcb_connect(nullptr, nullptr));
    if (xcb_connection_has_error(c.get())) return {};
    const xcb_query_extension_reply_t* input = xcb_get_extension_data(c.get(), &xcb_input_id);
    if (!input || !input->present) return {};
    const Reply<xcb_input_xi_query_version_reply_t> version(
        xcb_input_xi_query_version_reply(c.get(), xcb_input_xi_query_version(c.get(), 2, 2), nullptr));
    if (!version ||
        std::pair(version->major_version, version->minor_version) < std::pair(uint16_t(2), uint16_t(2)))
        return {};
    const struct {
        xcb_input_event_mask_t head{XCB_INPUT_DEVICE_ALL_MASTER, 1};
        std::uint32_t mask = XCB_INPUT_XI_EVENT_MASK_TOUCH_BEGIN | XCB_INPUT_XI_EVENT_MASK_TOUCH_UPDATE |
                             XCB_INPUT_XI_EVENT_MASK_TOUCH_END;
    } wanted;
    const xcb_void_cookie_t selected = xcb_input_xi_select_events_checked(c.get(), window, 1, &wanted.head);
    const Reply<xcb_generic_error_t> refused(xcb_request_check(c.get(), selected));
    return refused ? Connection() : std::move(c);
}

/// Converts an event of the connection; empty if the event is of another kind.
std::optional<TouchEvent> touch_of(const xcb_generic_event_t& event) {
    constexpr int sent_bit = 0x80;
    if ((event.response_type & ~sent_bit) != XCB_GE_GENERIC) return {};
    // Update and end events have the same layout as begin events.
    const auto& touch = reinterpret_cast<const xcb_input_touch_begin_event_t&>(event);
    const auto pixels = [](xcb_input_fp1616_t fixed) { return double(fixed) / 65536; };
    const auto made = [&](TouchEvent::What what) {
        return TouchEvent{what, touch.detail, pixels(touch.event_x), pixels(touch.event_y)};
    };
    switch (touch.event_type) {
        case XCB_INPUT_TOUCH_BEGIN:
            return made(TouchEvent::What::begin);
        case XCB_INPUT_TOUCH_UPDATE:
            return made(TouchEvent::What::move);
        case XCB_INPUT_TOUCH_END:
            return made(TouchEvent::What::end);
        default:
            return {};
    }
}

}  // namespace

struct TouchScreen::Listener {
    Connection connection;
    int stop;  ///< an eventfd
    std::mutex mutex;
    std::vector<TouchEvent> touches;
    std::thread thread;

    Listener(Connection c, int stop_by)
        : connection(std::move(c)), stop(stop_by), thread([this] { listen(); }) {}
    ~Listener() {
        const std::uint64_t one = 1;
        [[maybe_unused]] const auto written = ::write(stop, &one, sizeof one);
        thread.join();
        ::close(stop);
    }
    void listen() {
        pollfd sources[] = {{xcb_get_file_descriptor(connection.get()), POLLIN, 0}, {stop, POLLIN, 0}};
        while (!xcb_connection_has_error(connection.get())) {
            while (const Reply<xcb_generic_event_t> event{xcb_poll_for_event(connection.get())})
                if (const auto touch = touch_of(*event)) {
                    const std::scoped_lock lock(mutex);
                    touches.push_back(*touch);
                }
            glfwPostEmptyEvent();
            ::poll(sources, 2, -1);
            if (sources[1].revents) return;
        }
    }
};

TouchScreen::TouchScreen(GLFWwindow* window) {
    const xcb_window_t id = glfwGetX11Window ? xcb_window_t(glfwGetX11Window(window)) : 0;
    Connection connection = id ? listen_to_touches(id) : Connection();
    const int stop = connection ? ::eventfd(0, EFD_CLOEXEC) : -1;
    if (stop >= 0) listener_ = std::make_unique<Listener>(std::move(connection), stop);
}

TouchScreen::~TouchScreen() = default;

std::vector<TouchEvent> TouchScreen::take() {
    if (!listener_) return {};
    const std::scoped_lock lock(listener_->mutex);
    return std::exchange(listener_->touches, {});
}

}  // namespace vantage
