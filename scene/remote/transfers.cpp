#include "scene/remote/transfers.h"

#include <curl/curl.h>
#include <strings.h>

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include "scene/remote/rate.h"
#include "scene/remote/url.h"

namespace vantage {

namespace {

using Clock = std::chrono::steady_clock;

constexpr long receive_buffer = 64 << 10;           // bytes per request
constexpr std::size_t max_header_bytes = 64 << 10;  // per answer
constexpr long max_redirects = 5;
constexpr long stall_rate = 256;                    // bytes per second; slower is a stall
constexpr std::uint64_t progress_bytes = 64 << 10;  // minimum per try to count as progress

struct CloseEasy {
    void operator()(CURL* easy) const { curl_easy_cleanup(easy); }
};
struct CloseMulti {
    void operator()(CURLM* multi) const { curl_multi_cleanup(multi); }
};
struct FreeList {
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};

bool starts_library() {
    static const bool started = curl_global_init(CURL_GLOBAL_DEFAULT) == CURLE_OK;
    return started;
}

/// A request and its current try.
struct Active {
    std::shared_ptr<Request> request;
    const std::string& shown_url;
    std::atomic<std::uint64_t>& bytes_received;
    Rate& rate;
    const int tries;
    int tries_left = tries;
    std::uint64_t received = 0;  ///< bytes received in all tries
    Clock::time_point not_before{};

    std::unique_ptr<CURL, CloseEasy> easy{};
    std::unique_ptr<curl_slist, FreeList> headers{};
    ByteRange asked{};  ///< the range that this try requests
    Answer answer{};
    bool answered = false;           ///< all headers have arrived and are valid
    std::optional<Failure> fault{};  ///< set by a callback, which then ends the transfer
    std::array<char, CURL_ERROR_SIZE> error{};

    std::uint64_t received_in_try() const { return request->range().begin + received - asked.begin; }
    Failure failure(const std::string& what) const { return {Exit::input, shown_url + ": " + what}; }
    std::string progress() const {
        return std::to_string(received) + " of " + std::to_string(request->range().size()) +
               " bytes had arrived";
    }
};

/// True for redirects such as 301, which libcurl follows; 304 is a final response.
bool is_redirect(const Answer& answer) {
    return answer.status >= 301 && answer.status <= 308 && answer.status != 304 && !answer.location.empty();
}

bool may_pass(int status) { return status == 429 || status == 502 || status == 503 || status == 504; }

/// Called after the last header line. Returns whether to continue.
bool headers_end(Active& a) {
    if (a.answer.status >= 100 && a.answer.status < 200) return true;
    if (is_redirect(a.answer)) {
        const char* from = nullptr;
        curl_easy_getinfo(a.easy.get(), CURLINFO_EFFECTIVE_URL, &from);
        const bool secure = from && ::strncasecmp(from, "https:", 6) == 0;
        if (!secure || ::strncasecmp(a.answer.location.c_str(), "http:", 5) != 0) return true;
        a.fault = a.failure("the server redirects from https to http; such redirects are not followed");
        return false;
    }
    if (const std::string flaw = a.request->flaw(a.answer, a.asked); !flaw.empty()) {
        a.fault = a.failure(flaw);
        a.fault->transient = a.fault->unreachable = may_pass(a.answer.status);
        return false;
    }
    return a.answered = true;
}

/// Calls `f` and stores its exceptions, which must not propagate through libcurl.
template <class F>
std::size_t guarded(Active& a, std::size_t bytes, F f) {
    try {
        if (f()) return bytes;
    } catch (const Error& e) {
        a.fault = Failure{e.code(), e.what()};
    } catch (const std::exception& e) {
        a.fault = Failure{Exit::memory, a.shown_url + ": " + e.what()};
    }
    if (!a.fault) a.fault = a.failure("the transfer was stopped");
    return bytes + 1;  // any number other than `bytes` ends the transfer
}

std::size_t on_header(char* data, std::size_t, std::size_t size, void* active) {
    Active& a = *static_cast<Active*>(active);
    const std::string_view line(data, size);
    return guarded(a, size, [&] {
        if (a.answered && !line.starts_with("HTTP/")) return true;  // trailer after the body
        a.answered = false;
        take_header_line(a.answer, line);
        if (a.answer.header_bytes > max_header_bytes) {
            a.fault = a.failure("the headers of the response exceed " + std::to_string(max_header_bytes) +
                                " bytes");
            return false;
        }
        return line.find_first_not_of("\r\n") != std::string_view::npos || headers_end(a);
    });
}

std::size_t on_body(char* data, std::size_t, std::size_t size, void* active) {
    Active& a = *static_cast<Active*>(active);
    return guarded(a, size, [&] {
        const ByteRange range = a.request->range();
        if (!a.answered || a.request->cancelled()) return false;
        if (size > range.size() - a.received) {
            a.fault = a.failure("the server sends more than the " + std::to_string(a.asked.size()) +
                                " bytes requested");
            return false;
        }
        a.request->store(range.begin + a.received, std::as_bytes(std::span(data, size)));
        a.received += size;
        a.bytes_received += size;
        a.rate.add(size);
        return true;
    });
}

struct Reason {
    std::string text;
    bool transient = false;
};

Reason reason_of(const Active& a, CURLcode code, const TransferOptions& options) {
    const std::string detail = a.error[0] ? a.error.data() : curl_easy_strerror(code);
    curl_off_t sent = 0;  // microseconds until the request was sent, or 0
    curl_easy_getinfo(a.easy.get(), CURLINFO_PRETRANSFER_TIME_T, &sent);
    switch (code) {
        case CURLE_COULDNT_RESOLVE_HOST:
        case CURLE_COULDNT_RESOLVE_PROXY:
            return {"cannot find the host: " + detail, true};
        case CURLE_COULDNT_CONNECT:
        case CURLE_SSL_CONNECT_ERROR:
            return {"cannot connect: " + detail, true};
        case CURLE_OPERATION_TIMEDOUT:
            if (sent == 0) return {"cannot connect: " + detail, true};
            return {"the server stalls: fewer than " + std::to_string(stall_rate) + " bytes per second for " +
                        std::to_string(options.stall_timeout.count()) + " s; " + a.progress(),
                    true};
        case CURLE_PARTIAL_FILE:
        case CURLE_RECV_ERROR:
        case CURLE_SEND_ERROR:
        case CURLE_GOT_NOTHING:
        case CURLE_HTTP2:
        case CURLE_HTTP2_STREAM:
            return {"the connection was cut; " + a.progress(), true};
        case CURLE_PEER_FAILED_VERIFICATION:
        case CURLE_SSL_CACERT_BADFILE:
            return {"the server's certificate is not valid: " + detail};
        case CURLE_TOO_MANY_REDIRECTS:
            return {"the server redirects more than " + std::to_string(max_redirects) + " times"};
        case CURLE_UNSUPPORTED_PROTOCOL:
            return {"the server redirects to a URL that is neither http nor https: " + detail};
        default:
            return {detail};
    }
}

std::optional<Failure> failure_of(const Active& a, CURLcode code, const TransferOptions& options) {
    if (a.fault) return a.fault;
    if (code == CURLE_OK && !a.answered) return a.failure("the response has no headers");
    if (code == CURLE_OK && a.received == a.request->range().size()) return {};
    Reason reason{"the body of the response is too short; " + a.progress(), true};
    if (code != CURLE_OK) reason = reason_of(a, code, options);
    Failure failure = a.failure(reason.text);
    failure.transient = failure.unreachable = reason.transient;
    return failure;
}

}  // namespace

struct Transfers::Impl {
    Impl(std::string url, const TransferOptions& given)
        : url_(std::move(url)), shown_url_(shown_url(url_)), options_(given) {
        if (starts_library()) multi_.reset(curl_multi_init());
        if (!multi_) throw Error(Exit::internal, "cannot start libcurl");
        curl_multi_setopt(multi_.get(), CURLMOPT_MAXCONNECTS, long(options_.max_in_flight));
        try {
            thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
        } catch (const std::system_error&) {
            throw Error(Exit::memory, shown_url_ + ": cannot start a thread for transfers");
        }
    }

    ~Impl() {
        thread_.request_stop();
        curl_multi_wakeup(multi_.get());
        thread_.join();
        for (const auto& a : in_flight_) curl_multi_remove_handle(multi_.get(), a->easy.get());
    }

    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            take_incoming();
            drop_cancelled();
            start_due();
            int running = 0;
            curl_multi_perform(multi_.get(), &running);
            collect();
            curl_multi_poll(multi_.get(), nullptr, 0, pause(), nullptr);
        }
    }

    void take_incoming() {
        const std::scoped_lock lock(mutex_);
        for (auto& a : incoming_) enqueue(std::move(a));
        incoming_.clear();
    }

    void enqueue(std::unique_ptr<Active> a) {
        const auto turn = [](const auto& other) { return other->request->turn(); };
        const auto at = std::ranges::upper_bound(waiting_, a->request->turn(), {}, turn);
        waiting_.insert(at, std::move(a));
    }

    void drop_cancelled() {
        std::erase_if(waiting_, [](const auto& a) { return a->request->cancelled(); });
        std::erase_if(in_flight_, [&](const auto& a) {
            if (!a->request->cancelled()) return false;
            curl_multi_remove_handle(multi_.get(), a->easy.get());
            return true;
        });
    }

    bool room() const { return in_flight_.size() < std::size_t(std::max(1, options_.max_in_flight)); }

    void start_due() {
        for (auto a = waiting_.begin(); a != waiting_.end() && room();) {
            if ((*a)->not_before > Clock::now()) {
                ++a;
                continue;
            }
            if (start_try(**a)) {
                in_flight_.push_back(std::move(*a));
            } else {
                const Failure failure{Exit::memory, shown_url_ + ": out of memory for a request"};
                (*a)->request->done(&failure);
            }
            a = waiting_.erase(a);
        }
    }

    /// The number of milliseconds until the next try is due. Other events wake the thread earlier.
    int pause() const {
        using namespace std::chrono;
        auto wait = milliseconds(1000);
        if (!room()) return int(wait.count());
        for (const auto& a : waiting_)
            wait = std::min(wait,
                            ceil<milliseconds>(std::max(a->not_before - Clock::now(), Clock::duration(0))));
        return int(wait.count());
    }

    bool start_try(Active& a) {
        a.asked = {a.request->range().begin + a.received, a.request->range().end};
        a.answer = {};
        a.answered = false;
        a.fault.reset();
        a.error.fill(0);
        a.easy.reset(curl_easy_init());
        if (!a.easy) return false;
        set_request(a);
        set_limits(a.easy.get());
        if (curl_multi_add_handle(multi_.get(), a.easy.get()) != CURLM_OK) return false;
        ++requests_;
        return true;
    }

    void set_request(Active& a) const {
        CURL* easy = a.easy.get();
        const std::string range = std::to_string(a.asked.begin) + "-" + std::to_string(a.asked.end - 1);
        curl_slist* headers = curl_slist_append(nullptr, "Accept-Encoding: identity");
        // After a disconnection, the rest of the body is requested without a condition about the cached copy.
        const std::string condition = a.received == 0 ? a.request->condition() : "";
        if (!condition.empty()) headers = curl_slist_append(headers, condition.c_str());
        a.headers.reset(headers);
        curl_easy_setopt(easy, CURLOPT_URL, url_.c_str());
        curl_easy_setopt(easy, CURLOPT_RANGE, range.c_str());
        curl_easy_setopt(easy, CURLOPT_HTTPHEADER, headers);
        curl_easy_setopt(easy, CURLOPT_USERAGENT, "vantage/" VANTAGE_VERSION);
        curl_easy_setopt(easy, CURLOPT_HEADERDATA, &a);
        curl_easy_setopt(easy, CURLOPT_HEADERFUNCTION, on_header);
        curl_easy_setopt(easy, CURLOPT_WRITEDATA, &a);
        curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, on_body);
        curl_easy_setopt(easy, CURLOPT_ERRORBUFFER, a.error.data());
    }

    void set_limits(CURL* easy) const {
        curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
        curl_easy_setopt(easy, CURLOPT_REDIR_PROTOCOLS_STR, "http,https");
        curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 1L);
        curl_easy_setopt(easy, CURLOPT_MAXREDIRS, max_redirects);
        curl_easy_setopt(easy, CURLOPT_SSL_VERIFYPEER, 1L);
        curl_easy_setopt(easy, CURLOPT_SSL_VERIFYHOST, 2L);
        if (!options_.certificates.empty())
            curl_easy_setopt(easy, CURLOPT_CAINFO, options_.certificates.c_str());
        curl_easy_setopt(easy, CURLOPT_HTTP_VERSION, long(CURL_HTTP_VERSION_2TLS));
        curl_easy_setopt(easy, CURLOPT_PIPEWAIT, 1L);  // instead of opening a new connection
        curl_easy_setopt(easy, CURLOPT_BUFFERSIZE, receive_buffer);
        curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT_MS, long(options_.connect_timeout.count()));
        curl_easy_setopt(easy, CURLOPT_LOW_SPEED_LIMIT, stall_rate);
        curl_easy_setopt(easy, CURLOPT_LOW_SPEED_TIME, long(options_.stall_timeout.count()));
        curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
    }

    void collect() {
        int left = 0;
        while (const CURLMsg* message = curl_multi_info_read(multi_.get(), &left)) {
            if (message->msg != CURLMSG_DONE) continue;
            CURL* easy = message->easy_handle;
            const CURLcode code = message->data.result;
            const auto at = std::ranges::find(in_flight_, easy, [](const auto& a) { return a->easy.get(); });
            std::unique_ptr<Active> a = std::move(*at);
            in_flight_.erase(at);
            const auto failure = failure_of(*a, code, options_);
            curl_multi_remove_handle(multi_.get(), easy);
            if (failure && try_again(*a, *failure))
                enqueue(std::move(a));
            else if (!a->request->cancelled())
                a->request->done(failure ? &*failure : nullptr);
        }
    }

    bool try_again(Active& a, const Failure& failure) const {
        if (a.received_in_try() >= progress_bytes) a.tries_left = a.tries;
        if (!failure.transient || --a.tries_left <= 0) return false;
        auto pause = options_.retry_pause;
        for (int tried = a.tries - a.tries_left; tried > 1; --tried) pause *= 4;
        a.not_before = Clock::now() + pause;
        return true;
    }

    const std::string url_, shown_url_;
    const TransferOptions options_;
    std::atomic<std::uint64_t> bytes_received_ = 0, requests_ = 0;
    Rate rate_;
    std::unique_ptr<CURLM, CloseMulti> multi_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Active>> incoming_;  ///< guarded by the mutex
    // Used only by the transfer thread.
    std::deque<std::unique_ptr<Active>> waiting_;  ///< sorted by turn, then in order of arrival
    std::vector<std::unique_ptr<Active>> in_flight_;
    std::jthread thread_;
};

Transfers::Transfers(std::string url, const TransferOptions& options)
    : impl_(std::make_unique<Impl>(std::move(url), options)) {}

Transfers::~Transfers() = default;

void Transfers::start(std::shared_ptr<Request> request, int tries) {
    {
        const std::scoped_lock lock(impl_->mutex_);
        impl_->incoming_.push_back(std::unique_ptr<Active>(
            new Active{std::move(request), impl_->shown_url_, impl_->bytes_received_, impl_->rate_, tries}));
    }
    curl_multi_wakeup(impl_->multi_.get());
}

void Transfers::cancel(Request& request) {
    request.cancel();
    curl_multi_wakeup(impl_->multi_.get());
}

std::uint64_t Transfers::bytes_received() const { return impl_->bytes_received_; }
std::uint64_t Transfers::requests() const { return impl_->requests_; }
double Transfers::bytes_per_second() const { return impl_->rate_.per_second(); }

}  // namespace vantage
