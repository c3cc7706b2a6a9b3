#include "run/recorder.h"

#ifndef _WIN32
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <chrono>
#include <csignal>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "checks/text.h"
#include "state/whole_file.h"

#ifndef _WIN32
extern char** environ;  // NOLINT(readability-redundant-declaration): only glibc declares it
#endif

namespace drench::demo {

#ifdef _WIN32

// On this system ffmpeg is not started.
class Recorder::Process {
  public:
    explicit Process(const std::vector<std::string>&) {
        throw std::runtime_error(
            "films are made on Linux and macOS only; here, write pictures with --frames FOLDER --every 1");
    }
    bool write(const std::uint8_t*, std::size_t) { return false; }
    int end() { return 0; }
    void waitAtMost(double) {}
};

#else

// A program with a pipe to its stdin. It is started without a shell, so arguments may contain any characters.
class Recorder::Process {
  public:
    explicit Process(const std::vector<std::string>& command) {
        int ends[2];
        if (pipe(ends) != 0) throw std::runtime_error("no pipe to ffmpeg: " + nameOf(errno));
        for (const int descriptor : ends) fcntl(descriptor, F_SETFD, FD_CLOEXEC);
        toChild_ = ends[1];
        const int problem = start(command, ends[0]);
        close(ends[0]);
        if (problem == 0) return;
        closePipe();
        throw std::runtime_error(
            problem == ENOENT
                ? "there is no ffmpeg to make films with; install it (Debian: apt-get install ffmpeg), or "
                  "write pictures with --frames FOLDER --every 1"
                : "ffmpeg cannot be started: " + nameOf(problem));
    }
    ~Process() { end(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // @return whether the program has read all of it
    bool write(const std::uint8_t* data, std::size_t size) {
        const SilentPipe silent;
        while (size > 0) {
            const ssize_t written = ::write(toChild_, data, size);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            data += written;
            size -= static_cast<std::size_t>(written);
        }
        return true;
    }

    // Closes the pipe, and waits for the program. @return its exit status; 128 or more after a signal
    int end() {
        if (child_ <= 0) return status_;
        closePipe();
        int how = 0;
        while (waitpid(child_, &how, 0) < 0 && errno == EINTR) {
        }
        child_ = 0;
        status_ = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
        return status_;
    }

    // Closes the pipe, and kills the program if it takes longer than the given time, s.
    void waitAtMost(double seconds) {
        closePipe();
        const auto start = std::chrono::steady_clock::now();
        siginfo_t ended{};
        while (waitid(P_PID, id_t(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0) {
            if (std::chrono::steady_clock::now() - start > std::chrono::duration<double>(seconds))
                kill(child_, SIGKILL);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

  private:
    // While this object exists, writing to a pipe without a reader is an error of the write, not a signal
    // that ends the program.
    class SilentPipe {
      public:
        SilentPipe() {
            sigemptyset(&pipe_);
            sigaddset(&pipe_, SIGPIPE);
            pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
        }
        ~SilentPipe() {
            sigset_t pending;
            sigpending(&pending);
            int signal = 0;
            if (sigismember(&pending, SIGPIPE) && !sigismember(&before_, SIGPIPE)) sigwait(&pipe_, &signal);
            pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        }
        SilentPipe(const SilentPipe&) = delete;
        SilentPipe& operator=(const SilentPipe&) = delete;

      private:
        sigset_t pipe_;
        sigset_t before_;
    };

    static std::string nameOf(int problem) { return std::generic_category().message(problem); }

    // @return 0, or an errno value
    int start(const std::vector<std::string>& command, int input) {
        std::vector<char*> arguments;
        arguments.reserve(command.size() + 1);
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
        const int problem = posix_spawnp(&child_, arguments[0], &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (problem != 0) child_ = 0;
        return problem;
    }

    void closePipe() {
        if (toChild_ >= 0) close(toChild_);
        toChild_ = -1;
    }

    pid_t child_ = 0;
    int toChild_ = -1;
    int status_ = 0;
};

#endif

namespace {

// Pictures are read from stdin; there is no sound.
std::vector<std::string> commandFor(const std::filesystem::path& file, int width, int height,
                                    double framesPerSecond) {
    return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24",
            "-video_size", std::to_string(width) + "x" + std::to_string(height), "-framerate",
            std::to_string(framesPerSecond), "-i", "pipe:0", "-pix_fmt", "yuv420p",
            // The name is a file, whatever it looks like.
            "file:" + file.string()};
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& file, int width, int height, double framesPerSecond)
    : file_(file), width_(width), height_(height) {
    files::checkWritable(file);
    ffmpeg_ = std::make_unique<Process>(commandFor(file, width, height, framesPerSecond));
}

Recorder::~Recorder() = default;

void Recorder::add(const viewer::Image& image) {
    if (image.width != width_ || image.height != height_)
        throw std::invalid_argument(textOf("a film of ", width_, " x ", height_, " takes no picture of ",
                                           image.width, " x ", image.height));
    if (!ffmpeg_ || !ffmpeg_->write(image.rgb.data(), image.rgb.size()))
        throw std::runtime_error(textOf("ffmpeg has ended before the film ", file_.string(),
                                        " was whole; see what it says above"));
}

void Recorder::finish() {
    if (!ffmpeg_) return;
    const int status = ffmpeg_->end();
    ffmpeg_.reset();
    if (status != 0)
        throw std::runtime_error(textOf("ffmpeg could not make the film ", file_.string(), " (exit status ",
                                        status, "); see what it says above"));
}

void Recorder::check(const std::filesystem::path& file) {
    constexpr int width = 64, height = 64;
    constexpr double patience = 20;  // s
    std::filesystem::path trial = file;
    trial.replace_filename("trial-" + std::to_string(std::random_device()()) + file.extension().string());
    bool whole = true;
    Recorder recorder(trial, width, height, 60);
    try {
        constexpr int pictures = 3;  // a single picture also fits into a file that is not a video
        for (int i = 0; i < pictures; ++i)
            recorder.add({width, height, std::vector<std::uint8_t>(std::size_t(3) * width * height)});
        recorder.ffmpeg_->waitAtMost(patience);
        recorder.finish();
    } catch (const std::runtime_error&) {
        whole = false;
    }
    std::error_code ignored;
    std::filesystem::remove(trial, ignored);
    if (!whole)
        throw std::runtime_error(textOf("ffmpeg cannot make the film ", file.string(),
                                        "; see what it says above, or choose another ending, such as .mp4"));
}

}  // namespace drench::demo
