// SPDX-License-Identifier: Apache-2.0
#include "paper/records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>

#include "model/files.hpp"

namespace quadbound {
namespace {

namespace fs = std::filesystem;

/// Without the marks of bold text and links, which the report does not have.
std::string plain(std::string text) {
  static const std::regex kLink(R"(\[([^\]]*)\]\([^)]*\))");
  static const std::regex kBold(R"(\*\*)");
  static const std::regex kBar(R"(&#124;|\\\|)");
  text = std::regex_replace(text, kLink, "$1");
  text = std::regex_replace(text, kBold, "");
  return std::regex_replace(text, kBar, "|");
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// "| a | b |"; a bar after a backslash belongs to its cell.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '|' && line[i - 1] != '\\') {
      cells.push_back(plain(trimmed(cell)));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

class MarkdownReader {
 public:
  MarkdownReader(const std::string& text, const std::string& folder)
      : lines_(text), folder_(folder) {}

  Document run() {
    for (std::string line; std::getline(lines_, line);) read(line);
    end_paragraph();
    return std::move(document_);
  }

 private:
  void read(const std::string& line) {
    if (line.starts_with("```")) {
      code();
    } else if (line.starts_with("|")) {
      table(line);
    } else if (line.starts_with("#")) {
      end_paragraph();
      const std::size_t level = line.find_first_not_of('#');
      document_.push_back(Heading{static_cast<int>(level), plain(trimmed(line.substr(level)))});
    } else if (line.starts_with("![")) {
      picture(line);
    } else if (line.starts_with("<!--") || line.empty()) {
      end_paragraph();
    } else if (line.starts_with("- ")) {
      end_paragraph();
      paragraph_ = "• " + line.substr(2);
    } else {
      paragraph_ += (paragraph_.empty() ? "" : " ") + trimmed(line);
    }
  }

  void end_paragraph() {
    if (!paragraph_.empty()) document_.push_back(Paragraph{plain(paragraph_)});
    paragraph_.clear();
  }

  void code() {
    end_paragraph();
    CodeBlock block;
    for (std::string line; std::getline(lines_, line) && !line.starts_with("```");)
      block.text += (block.text.empty() ? "" : "\n") + line;
    document_.push_back(std::move(block));
  }

  /// The line of dashes below the head is left out.
  void table(const std::string& head) {
    end_paragraph();
    TextTable block{cells_of(head), {}};
    std::string line;
    std::getline(lines_, line);
    while (lines_.peek() == '|' && std::getline(lines_, line)) block.rows.push_back(cells_of(line));
    document_.push_back(std::move(block));
  }

  void picture(const std::string& line) {
    static const std::regex kPicture(R"(!\[([^\]]*)\]\(([^)]*)\).*)");
    end_paragraph();
    std::smatch match;
    if (!std::regex_match(line, match, kPicture)) return;
    const fs::path file = fs::path(folder_) / match[2].str();
    if (fs::exists(file))
      document_.push_back(DocumentPicture{match[2], match[1], read_file(file.string())});
    else
      document_.push_back(Paragraph{match[1]});
  }

  std::istringstream lines_;
  std::string folder_;
  std::string paragraph_;
  Document document_;
};

/// Relative to the folder; those of bench/ last.
std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::path& at : {folder, folder / "bench"}) {
    if (!fs::is_directory(at)) continue;
    const auto start = static_cast<std::ptrdiff_t>(files.size());
    for (const auto& entry : fs::directory_iterator(at)) {
      const fs::path name = entry.path().filename();
      if (name.extension() == ".md" && name != "README.md" && name != "reproduction.md")
        files.push_back(entry.path().lexically_relative(folder));
    }
    std::sort(files.begin() + start, files.end());
  }
  return files;
}

std::string folded(const fs::path& folder, const fs::path& file) {
  const fs::path path = folder / file;
  Document document = read_markdown(read_file(path.string()), path.parent_path().string());
  std::string title = file.string();
  if (!document.empty() && std::holds_alternative<Heading>(document.front())) {
    title = std::get<Heading>(document.front()).text;
    document.erase(document.begin());
  }
  for (Block& block : document)
    if (auto* const heading = std::get_if<Heading>(&block)) ++heading->level;
  return fmt::format(
      "<details><summary>{} <span class=\"why\">results/{}</span></summary>\n{}"
      "</details>\n",
      inline_html(title), file.string(), to_html(document));
}

}  // namespace

Document read_markdown(const std::string& text, const std::string& folder) {
  return MarkdownReader(text, folder).run();
}

PageBlock records_block(const std::string& folder) {
  PageBlock block;
  std::string names;
  for (const fs::path& file : files_of(folder)) {
    block.html += folded(folder, file);
    names += (names.empty() ? "`" : ", `") + file.string() + "`";
  }
  if (!names.empty()) block.markdown.emplace_back(Paragraph{names + "."});
  return block;
}

}  // namespace quadbound
