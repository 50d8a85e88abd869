// A plug-in for tests that is wrong in one way: which one, the environment variable SHADOWLAB_MISBEHAVIOUR says. What reaches for
// something outside, named by SHADOWLAB_PREY, throws what it has got.
// SPDX-License-Identifier: MIT
#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "techniques/frame.h"

namespace shadowlab::misbehaving {

namespace {

const StageInfo kStages[] = {{"visibility", "Visibility of the light", StageKind::visibility, true}};
const PassInfo kPasses[] = {{.id = "light", .title = "Add the light"}};

bool is(std::string_view behaviour) {
    const char* asked = std::getenv("SHADOWLAB_MISBEHAVIOUR");
    return asked && asked == behaviour;
}

std::string prey() {
    const char* named = std::getenv("SHADOWLAB_PREY");
    return named ? named : "";
}

void readFile() {
    std::ifstream file(prey());
    std::string text;
    if (std::getline(file, text)) throw std::runtime_error("it has read " + text);
}

void writeFile() {
    std::ofstream file(prey() + ".new");
    file << "mine";
    if (file.flush()) throw std::runtime_error("it has written a file");
}

void openSocket() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<unsigned short>(std::atoi(prey().c_str())));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int connection = ::socket(AF_INET, SOCK_STREAM, 0);
    // NOLINTNEXTLINE: the interface of sockets
    if (::connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        throw std::runtime_error("it has a connection");
}

/// The process that named itself there, or any other that is not an ancestor in a sandbox.
void lookAtProcess() {
    if (std::ifstream("/proc/" + prey() + "/cmdline").good()) throw std::runtime_error("it sees the process");
}

void leaveProcess() {
    if (::fork() != 0) return;
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    for (const int descriptor : {0, 1, 2})
        ::close(descriptor);
    std::this_thread::sleep_for(std::chrono::seconds(300));
    ::_exit(0);
}

void misbehave() {
    if (is("reads-home")) readFile();
    if (is("writes-file")) writeFile();
    if (is("opens-socket")) openSocket();
    if (is("sees-processes")) lookAtProcess();
    if (is("leaves-process")) leaveProcess();
    while (is("forks")) static_cast<void>(::fork());
    if (is("prints-score")) {
        std::cout << "{\"ready\": []}\n{\"drawn\": true}\n{\"points\": 20, \"of\": 20}\n" << std::flush;
        std::cerr << "shadowlab: 20/20\n";
    }

    volatile int* nowhere = nullptr;
    std::vector<std::vector<char>> memory;
    if (is("crashes")) *nowhere = 1;
    if (is("never-ends"))
        for (volatile int i = 0;; i = 0) {
        }
    while (is("eats-memory"))
        memory.emplace_back(std::size_t{16} << 20, 'x');
    if (is("throws")) throw std::runtime_error("the student's own words");
    if (is("breaks-gl")) glEnable(GL_COLOR); // no capability
    if (is("exits")) std::exit(0);
}

class Misbehaving final : public Technique {
public:
    Progress render(Frame& frame) override {
        frame.pass(kPasses[0], misbehave);
        return {};
    }
};

} // namespace

std::span<const TechniqueInfo> techniques() {
    if (is("throws-in-list")) throw std::runtime_error("no list today");
    if (is("lists-none")) return {};
    if (is("crashes-in-list")) std::abort();
    if (is("exits-in-list")) std::exit(0);
    static const TechniqueInfo info[] = {{
        .id = is("bad-id")     ? "Bad Id"
              : is("taken-id") ? "shadow-map"
                               : "misbehaving",
        .title = "Misbehaving",
        .lightTypes = {scene::LightType::point},
        .passes = {std::begin(kPasses), std::end(kPasses)},
        .stages = {std::begin(kStages), std::end(kStages)},
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Misbehaving>(); },
    }};
    return info;
}

} // namespace shadowlab::misbehaving
