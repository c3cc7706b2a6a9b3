// The part of recorder.cpp for Linux and macOS.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "recorder.h"

extern char** environ;

namespace drench::demo {

/// A program with a pipe to its stdin. It is started without a shell, so arguments may hold anything.
class Recorder::Process {
  public:
    explicit Process(const std::vector<std::string>& command) {
        int ends[2];
        if (pipe(ends) != 0) throw std::runtime_error(std::string("no pipe to ffmpeg: ") + strerror(errno));
        for (const int descriptor : ends) fcntl(descriptor, F_SETFD, FD_CLOEXEC);
        toChild_ = ends[1];
        const int problem = start(command, ends[0]);
        close(ends[0]);
        if (problem == 0) return;
        close(toChild_);
        throw std::runtime_error(
            problem == ENOENT
                ? "there is no ffmpeg to make films with; install it (Debian: apt-get install ffmpeg), or "
                  "write pictures with --frames FOLDER --every 1"
                : std::string("ffmpeg cannot be started: ") + strerror(problem));
    }
    ~Process() { end(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// @return whether the program has taken all of it
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

    /// Tells the program that nothing more comes, and waits. @return its exit status; 128 or more after a signal
    int end() {
        if (child_ <= 0) return status_;
        close(toChild_);
        int how = 0;
        while (waitpid(child_, &how, 0) < 0 && errno == EINTR) {
        }
        child_ = 0;
        status_ = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
        return status_;
    }

  private:
    /// While it lives, a pipe that nobody reads is an error of this thread's writes and ends no program.
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

    /// @return 0, or what went wrong as errno has it
    int start(const std::vector<std::string>& command, int input) {
        std::vector<char*> arguments;
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

    pid_t child_ = 0;
    int toChild_ = -1;
    int status_ = 0;
};

}  // namespace drench::demo
