# SPDX-License-Identifier: BSD-3-Clause
"""Makes the man page and the bash completion of a program from what it says to --help.

usage: help_pages.py PROGRAM VERSION MAN_PAGE COMPLETION

Whoever changes an option changes it in the program alone."""
import os
import re
import subprocess
import sys
from dataclasses import dataclass, field

TEXT_COLUMN = 30  # where CLI11 begins the text of a row


@dataclass
class Row:
    """One line of a table: `-o,--out TEXT` and what it does."""

    head: str
    text: str

    @property
    def names(self):
        return self.head.split()[0].split(",")

    @property
    def takes_value(self):
        return bool(re.search(r" (TEXT|INT|FLOAT)\b", self.head))

    @property
    def choices(self):
        found = re.search(r"\{([^}]*)\}", self.head)
        return found.group(1).split(",") if found else []


@dataclass
class Help:
    """What `PROGRAM [COMMAND] --help` says."""

    about: str = ""
    usage: str = ""
    footer: str = ""
    tables: dict = field(default_factory=dict)

    def rows(self, table):
        return self.tables.get(table, [])


def said(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def parse(text):
    """The parts of a help text of CLI11; a line that fits nowhere is an error, so that nothing is lost."""
    result, table, before = Help(), None, []
    for line in text.splitlines():
        title = re.fullmatch(r"([A-Z]\w+):", line)
        if title:
            table = result.tables.setdefault(title.group(1), [])
        elif line.startswith("Usage: "):
            result.about = " ".join(before)
            result.usage = re.sub(r"^Usage: \S+ ", "", line)
        elif table is None or (line and not line.startswith(" ")):
            if result.usage and line:
                result.footer = f"{result.footer} {line}".strip()
            elif line:
                before.append(line)
        elif line.startswith(" " * TEXT_COLUMN):
            table[-1].text = f"{table[-1].text} {line.strip()}".strip()
        elif line:
            head, text_part = line[:TEXT_COLUMN], line[TEXT_COLUMN:]
            table.append(Row(head.strip(), text_part.strip()) if head.endswith(" ") else Row(line.strip(), ""))
    if not result.usage or not result.tables:
        raise SystemExit(f"help_pages.py: this is no help text of CLI11:\n{text}")
    return result


def troff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return f"\\&{text}" if text.startswith((".", "'")) else text


def man_rows(rows):
    lines = []
    for row in rows:
        lines += [".TP", f".B {troff(row.head)}", troff(row.text) if row.text else "\\&"]
    return lines


def man_page(name, version, top, commands):
    lines = [f'.TH {name.upper()} 1 "" "scarp {version}" "User Commands"',
             ".SH NAME", f"{troff(name)} \\- {troff(top.about[0].lower() + top.about[1:])}",
             ".SH SYNOPSIS", f".B {troff(name)}", troff(top.usage),
             ".SH OPTIONS", *man_rows(top.rows("Options")), ".SH COMMANDS"]
    for command, page in commands.items():
        usage = page.usage.removeprefix(command).strip()
        lines += [f".SS {troff(name)} {troff(command)} {troff(usage)}", f"{troff(page.about)}."]
        # --help is in all of them.
        lines += man_rows(row for table in ("Positionals", "Options") for row in page.rows(table)
                          if "--help" not in row.names)
    codes = re.fullmatch(r"Exit codes: (.*)", top.footer)
    if codes:
        lines += [".SH EXIT STATUS"]
        for code, meaning in re.findall(r"(\d+) ([^,]*)", codes.group(1)):
            lines += [".TP", f".B {code}", troff(meaning.rstrip("."))]
    lines += [".SH SEE ALSO", "The pages in share/doc/scarp, of which engine/MANUAL.md describes each command."]
    return "\n".join(lines) + "\n"


def value_of(row, words):
    """How bash completes the value of an option or a positional: arguments of compgen, or a word for a function."""
    name = row.names[-1].strip("-")
    if row.choices:
        return f"-W '{' '.join(row.choices)}'"
    if name in words:
        return f"-W '{' '.join(words[name])}'"
    if name == "scene":
        return "scenes"
    # The table of `scarp element` is a file, every other --out a folder.
    if name == "folder" or name == "out" and "older" in row.text:
        return "-d"
    if name in ("file", "json", "out"):
        return "-f"
    return ""


def completion(name, top, commands, words):
    function = "_" + name.replace("-", "_")
    cases = []
    for command, page in commands.items():
        names = " ".join(n for row in page.rows("Options") for n in row.names)
        valued = [row for row in page.rows("Options") if row.takes_value]
        cases.append(f"    {command})\n      case $previous in")
        for row in valued:
            cases.append(f"        {' | '.join(row.names)}) values=\"{value_of(row, words)}\" ;;")
        positionals = page.rows("Positionals")
        first = f"\"{value_of(positionals[0], words)}\"" if positionals else '""'
        cases.append(f"        *) values={first} options='{names}' ;;\n      esac ;;")
    options = " ".join(n for row in top.rows("Options") for n in row.names)
    body = "\n".join(cases)
    return f"""# Completion of {name} for bash, made from its --help by cmake/help_pages.py.
{function}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} values='' options='' IFS=$' \\t\\n'
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{" ".join(commands)} {options}' -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{body}
  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  fi
  IFS=$'\\n'
  case $values in
    scenes)
      compopt -o filenames 2>/dev/null
      COMPREPLY=($(compgen -f -X '!*.toml' -- "$current") $(compgen -d -- "$current")) ;;
    -W*) COMPREPLY=($(IFS=' ' && compgen -W "${{values:4:-1}}" -- "$current")) ;;
    -?)
      compopt -o filenames 2>/dev/null
      COMPREPLY=($(compgen "$values" -- "$current")) ;;
  esac
}}
complete -F {function} {name}
"""


def known_words(program, commands):
    """Names that the program lists: templates of `new`, cases of `list`."""
    words = {}
    if "new" in commands:
        words["template"] = re.findall(r"^(\w+)  +\S", said(program, "new"), re.MULTILINE)
    if "list" in commands:
        words["cases"] = re.findall(r"^(\w+) ", said(program, "list"), re.MULTILINE)
    return words


def main(program, version, man_file, completion_file):
    name = os.path.basename(program)
    top = parse(said(program, "--help"))
    commands = {row.names[0]: parse(said(program, row.names[0], "--help")) for row in top.rows("Subcommands")}
    for path, text in ((man_file, man_page(name, version, top, commands)),
                       (completion_file, completion(name, top, commands, known_words(program, commands)))):
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
