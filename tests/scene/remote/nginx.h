#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/scene/remote/fault_server.h"

namespace vantage {

/// An nginx server on 127.0.0.1 that serves a folder until the object is destroyed. nginx keeps its own files
/// in another folder.
class Nginx {
  public:
    static bool installed() { return !program().empty(); }

    /// `settings`: directives for the location, such as `limit_rate 1m;`.
    Nginx(const std::filesystem::path& own, const std::filesystem::path& served,
          const std::string& settings = "", const std::string& server_settings = "", bool tls = false)
        : own_(own), port_(free_port()), tls_(tls) {
        std::filesystem::create_directories(own);
        std::ofstream(own / "nginx.conf")
            << "daemon off; master_process off; pid " << (own / "pid").string() << ";\nerror_log "
            << (own / "error.log").string() << ";\nevents {}\nhttp { access_log "
            << (own / "access.log").string() << ";\n"
            << temporary_folders() << "keepalive_requests 100000; server { listen 127.0.0.1:" << port_
            << (tls ? " ssl http2" : "") << "; " << server_settings << " root " << served.string()
            << "; location / { " << settings << " } } }\n";
        start();
    }
    ~Nginx() { stop(); }

    void start() {
        const std::string config = (own_ / "nginx.conf").string(), log = (own_ / "error.log").string();
        const std::string path = program();
        child_ = ::fork();
        if (child_ == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // does not outlive a test that crashes
            ::execl(path.c_str(), "nginx", "-e", log.c_str(), "-c", config.c_str(), nullptr);
            ::_exit(127);
        }
        for (int tries = 0; tries < 1000 && !accepts(); ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    void stop() {
        if (child_ <= 0) return;
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
        child_ = 0;
    }

    std::string url(const std::string& path = "/scan.vantage") const {
        return (tls_ ? "https://127.0.0.1:" : "http://127.0.0.1:") + std::to_string(port_) + path;
    }

  private:
    static std::string program() {
        for (const char* path : {"/usr/sbin/nginx", "/usr/bin/nginx", "/usr/local/sbin/nginx"})
            if (::access(path, X_OK) == 0) return path;
        return {};
    }
    std::string temporary_folders() const {
        std::string text;
        for (const char* name : {"client_body", "proxy", "fastcgi", "uwsgi", "scgi"})
            text += std::string(name) + "_temp_path " + (own_ / name).string() + ";\n";
        return text;
    }
    bool accepts() const {
        const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(std::uint16_t(port_));
        const bool connected = ::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
        ::close(fd);
        return connected;
    }

    std::filesystem::path own_;
    int port_ = 0;
    bool tls_ = false;
    pid_t child_ = 0;
};

}  // namespace vantage
