"""Of each wrong translation below, translations.py says what is wrong, and nothing of a right one; a
language in which three sentences are translated is right: translations_rules.py PROJECT"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import translations
from translations import pages, project

right = [
    ("The ray hits: $t > 0$, see `hit` in [errata 5](errata.md#erratum-5), 0.5 % of 10,000 rays.",
     "Le rayon intersecte : $t > 0$, voir `hit` dans [errata 5](errata.md#erratum-5), 0,5 % de 10 000 rayons."),
    ("intersect: a box is cut at its center; lamps touch a wall. *Ray Tracing: The Next Week*",
     "intersect: une boîte est coupée au centre ; des lampes touchent un mur. *Ray Tracing: The Next Week*"),
    ("Your file is yours.", "Vous gardez votre fichier."),
]
wrong = [
    ("formulas", "$t > 0$ is in front.", "$t < 0$ est devant."),
    ("formulas", "$$t = 1$$", "t vaut un"),
    ("code", "Call `hit`.", "Appeler `Hit`."),
    ("links", "[stage 5](step05.md#see-it)", "[étape 5](step05.md#voir)"),
    ("numbers", "0.5 of all", "0,6 de tous"),
    ("numbers", "It has 2 sides.", "Il a des côtés."),
    ("places", "{file}: {number} files", "{fichier} : {number} fichiers"),
    ("intersecte", "The ray hits the sphere.", "Le rayon coupe la sphère."),
    ("intersecte", "Rays hit it.", "Les rayons ne la touchent pas."),
    ("intersecte", "To hit a plane", "Rencontrer le plan"),
    ("intersecte", "It is hit.", "Elle est frappée."),
    ("intersection", "the point of the hit", "le point d'impact"),
    ("infinitive", "You look.", "Tu regardes."),
    ("derivation", "With $t$ you get it.", "Avec $t$ vous l'obtenez."),
    ("discriminant", "the discriminant Δ", "le déterminant Δ"),
    ("no-break", "Why?", "Pourquoi?"),
    ("no-break", "Why?", "Pourquoi ?"),
    ("no-break", "a “word”", "un « mot »"),
    ("no-break", "5 %", "5 %"),
    ("strictement", "$t$ is positive.", "$t$ est positif."),
    ("norme", "a direction of any length", "une direction de longueur quelconque"),
    ("orthogonal", "X is at right angles to Z.", "X est perpendiculaire à Z."),
    ("thread", "two threads", "deux fils d'exécution"),
    ("four digits", "1,024 rays", "1 024 rayons"),
]


def said(english, own):
    translations.errors.clear()
    translations.check_entry("", english, own, translations.refused_words("fr"))
    return translations.errors


def said_of_terms(english, own):
    translations.errors.clear()
    translations.check_terms("", english, own, translations.glossary())
    return translations.errors


failed = [f"refused: {own}: {said(english, own)}" for english, own in right if said(english, own)]
failed += [f"not refused for {why}: {own}" for why, english, own in wrong
           if not any(re.search(why, error) for error in said(english, own))]

labels = {"got": {"obtenu"}}
for own, is_right in [("*obtenu* est votre résultat", True), ("**got** est votre résultat", False), ("« got »", False)]:
    translations.errors.clear()
    translations.check_citations("", own, labels)
    if bool(translations.errors) == is_right:
        failed.append(f"{own} is {'right' if is_right else 'not what is printed'}")
if said_of_terms("An area light has soft shadows.", "Une source étendue fait des ombres douces."):
    failed.append("the glossary's words are right")
if len(said_of_terms("An area light has soft shadows.", "Une lampe large fait des bords flous.")) != 2:
    failed.append("other words than the glossary's are refused")

page = "docs/step05_triangle.md"
three = [('"Stage 5: triangles"', '"Etappe 5: Dreiecke"'), ('"The idea"', '"Die Idee"'), ('"See it"', '"Das Bild"')]
with tempfile.TemporaryDirectory() as folder:
    for name in ["common", "docs", "steps", "README.md", "tests"]:
        (Path(folder) / name).symlink_to(project / name)
    german = Path(folder) / "lang/de"
    german.mkdir(parents=True)
    shutil.copy(project / "lang/pages.py", german.parent)
    (german / "book.po").write_text('msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"\n', encoding="utf-8")

    def run(program, *words):
        return subprocess.run([sys.executable, Path(folder) / program, *words], text=True, stdout=subprocess.PIPE)

    listed = run("lang/pages.py", "de").stdout
    if f"lang/de/{page[:-3]}.po: " not in listed:
        failed.append(f"lang/pages.py lists what is to be translated, not {listed}")
    catalogue = german / page.replace(".md", ".po")
    text = catalogue.read_text(encoding="utf-8")
    for english, own in three:
        text = text.replace(f'msgid {english}\nmsgstr ""', f"msgid {english}\nmsgstr {own}")
    catalogue.write_text(text, encoding="utf-8")
    run("lang/pages.py", "de")
    pages.project, pages.lang = Path(folder), german.parent
    made, source = pages.translated("de")[page].split("\n"), (project / page).read_text(encoding="utf-8").split("\n")
    changed = [(a, b) for a, b in zip(source, made) if a != b]
    if len(made) != len(source) or len(changed) != 3 or changed[1] != ("## The idea", "## Die Idee"):
        failed.append(f"three sentences are translated, and the rest is English, not {changed}")
    checked = run("tests/documents/translations.py", folder)
    if checked.returncode:
        failed.append(f"a language begins with three sentences: {checked.stdout}")
    readme = Path(folder) / "README.de.md"
    readme.write_text(readme.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    (german / "words.txt").write_text("Dreick  Dreieck\n", encoding="utf-8")
    checked = run("tests/documents/translations.py", folder).stdout
    for why in ["README.de.md is not what", "are fuzzy or not translated: at most 2%"]:
        if why not in checked:
            failed.append(f"not said: {why}: {checked}")

print("\n".join(failed), end="\n" if failed else "")
sys.exit(bool(failed))
