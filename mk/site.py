"""The documents as pages that need no network: site.py FOLDER MORE...

Every Markdown page of the project becomes a page in FOLDER, the files it links to are copied, and
so are the folders MORE (NAME=FOLDER). A link to a page or heading that does not exist is an error.
"""
import re
import shutil
import subprocess
import sys
from html import unescape
from pathlib import Path

from reference import STYLE

ROOT = Path(__file__).resolve().parent.parent
LAYOUT = """
body { max-width: none; display: flex; gap: 2.5rem }
nav { flex: 0 0 13rem; font-size: .9rem; position: sticky; top: 1rem; align-self: flex-start;
      max-height: 96vh; overflow-y: auto }
nav ul { list-style: none; padding: 0; margin: .2rem 0 1rem }
main { flex: 1; min-width: 0; max-width: 52rem }
img { max-width: 100% }
th { text-align: left; padding: .1rem 1rem .1rem 0 }
table { display: block; overflow-x: auto }
@media (max-width: 50rem) { body { display: block } nav { position: static; max-height: none } }
"""


def sources():
    """The Markdown pages: those of the top folder first."""
    pages = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
    return pages + [ROOT / folder / "README.md" for folder in ("c_examples", "benches", "python")]


def page_of(source):
    """Where the page of a Markdown file stands in the site."""
    relative = source.relative_to(ROOT)
    return relative.with_name("index.html") if relative.name == "README.md" else relative.with_suffix(".html")


def anchor(heading):
    """A heading's anchor by GitHub's rule."""
    text = unescape(re.sub(r"<[^>]+>", "", heading)).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def rendered(source):
    """The HTML of a page, its headings with anchors."""
    command = ["cmark-gfm", "--unsafe", "-e", "table", "-e", "autolink", str(source)]
    html = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return re.sub(r"<h([1-6])>(.*?)</h\1>",
                  lambda found: f'<h{found[1]} id="{anchor(found[2])}">{found[2]}</h{found[1]}>', html)


def navigation(here):
    """The map of docs/README.md, as links from a page at `here`."""
    lines = []
    for row in (ROOT / "docs/README.md").read_text().splitlines():
        links = re.findall(r"\[([^]]+)\]\(([^)]+\.md)\)", row)
        if not links or not row.startswith("|"):
            continue
        lines.append(f"<b>{row.split('|')[1].strip()}</b><ul>")
        for name, target in links:
            page = page_of((ROOT / "docs" / target).resolve())
            lines.append(f'<li><a href="{up(here)}{page}">{name}</a></li>')
        lines.append("</ul>")
    home = f'<p><a href="{up(here)}index.html"><b>VIDES</b></a></p>'
    gallery = f'<p><a href="{up(here)}gallery/index.html">Gallery</a> · <a href="{up(here)}c/index.html">C reference</a></p>'
    return home + gallery + "\n".join(lines)


def up(here):
    return "../" * (len(here.parts) - 1)


def write(site, source):
    """Writes the page of a Markdown file, and copies what it links to."""
    here = page_of(source)

    def link(found):
        target, mark, part = found[2].partition("#")
        if not target or re.match(r"\w+:", target):
            return found[0]
        file = (source.parent / target).resolve()
        if not file.exists() or not file.is_relative_to(ROOT):
            return found[0]
        if file.is_dir():
            shutil.copytree(file, site / file.relative_to(ROOT), dirs_exist_ok=True)
        if file.suffix == ".md":
            return f'{found[1]}="{up(here)}{page_of(file)}{mark}{part}"'
        if file.is_file():
            copy = site / file.relative_to(ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
        return f'{found[1]}="{up(here)}{file.relative_to(ROOT)}"'

    body = re.sub(r'(href|src)="([^"]*)"', link, rendered(source))
    title = re.search(r"<h1[^>]*>(.*?)</h1>", body)
    title = re.sub(r"<[^>]+>", "", title[1]) if title else source.stem
    page = site / here
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(f"""<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title><style>{STYLE}{LAYOUT}</style>
<body><nav>{navigation(here)}</nav><main>{body}</main></body></html>
""")


def broken(site):
    """The links of all pages that lead nowhere."""
    text = {page: page.read_text() for page in site.rglob("*.html")}
    anchors = {page: set(re.findall(r'\bid="([^"]+)"', html)) for page, html in text.items()}
    for page, html in text.items():
        html = re.sub(r"<script.*?</script>", "", html, flags=re.S)
        for target in re.findall(r'(?:href|src)="([^"]*)"', html):
            target, _, part = unescape(target).partition("#")
            if re.match(r"\w+:", target):
                continue
            goal = (page.parent / target).resolve() if target else page
            if not goal.exists() or (part and part not in anchors.get(goal, ())):
                yield f"{page.relative_to(site)}: no {target}{'#' * bool(part)}{part}"


def main():
    site = Path(sys.argv[1]).resolve()
    shutil.rmtree(site, ignore_errors=True)
    for source in sources():
        if source.exists():
            write(site, source)
    for more in sys.argv[2:]:
        name, folder = more.split("=", 1)
        shutil.copytree(folder, site / name)
    wrong = sorted(set(broken(site)))
    print("\n".join(wrong) or f"{len(list(site.rglob('*.html')))} pages, no broken link: {site / 'index.html'}")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
