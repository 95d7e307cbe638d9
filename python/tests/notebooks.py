"""Executes a notebook, so that what it states is true: notebooks.py NOTEBOOK [FOLDER], which then has it as Markdown."""

import os
import sys

import nbformat
from nbclient import NotebookClient


def executed(file: str) -> nbformat.NotebookNode:
    notebook = nbformat.read(file, as_version=4)
    for cell in notebook.cells:
        if cell.cell_type == "code" and (cell.outputs or cell.execution_count):
            sys.exit(f"{file}: notebooks are kept without their results")
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    return notebook


def write_page(notebook: nbformat.NotebookNode, name: str, folder: str) -> None:
    from nbconvert import MarkdownExporter

    page, resources = MarkdownExporter().from_notebook_node(notebook, {"output_files_dir": name})
    os.makedirs(os.path.join(folder, name), exist_ok=True)
    for file, content in resources["outputs"].items():
        with open(os.path.join(folder, file), "wb") as output:
            output.write(content)
    with open(os.path.join(folder, name + ".md"), "w", encoding="utf-8") as output:
        output.write(page)


if __name__ == "__main__":
    result = executed(sys.argv[1])
    pictures = sum("image/png" in output.get("data", {}) for cell in result.cells for output in cell.get("outputs", []))
    print(f"{len(result.cells)} cells, {pictures} pictures")
    if len(sys.argv) > 2:
        write_page(result, os.path.splitext(os.path.basename(sys.argv[1]))[0], sys.argv[2])
    sys.exit(pictures == 0)
