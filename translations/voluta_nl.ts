<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl_NL" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Afsluiten</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Venster sluiten</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>&amp;Sneltoetsen…</translation>
    </message>
    <message>
        <source>See and change the keys</source>
        <translation>Sneltoetsen bekijken en wijzigen</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Donker</translation>
    </message>
    <message>
        <source>Light text on a dark background</source>
        <translation>Lichte tekst op een donkere achtergrond</translation>
    </message>
    <message>
        <source>P&amp;icture…</source>
        <translation>A&amp;fbeelding…</translation>
    </message>
    <message>
        <source>Save the viewport as a PNG</source>
        <translation>Weergave opslaan als PNG</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Volledig scherm</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>Het hele scherm</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Sneltoetsen</translation>
    </message>
    <message>
        <source>All keys at a glance</source>
        <translation>Alle sneltoetsen in één overzicht</translation>
    </message>
    <message>
        <source>Show &amp;log</source>
        <translation>&amp;Logboek tonen</translation>
    </message>
    <message>
        <source>Files opened, plans, findings and errors</source>
        <translation>Geopende bestanden, plannen, bevindingen en fouten</translation>
    </message>
    <message>
        <source>&amp;About Voluta</source>
        <translation>&amp;Over Voluta</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versie en licentie</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergelijken</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporteren</translation>
    </message>
    <message>
        <source>Robot &amp;programs…</source>
        <translation>Robot&amp;programma&apos;s…</translation>
    </message>
    <message>
        <source>Write the chosen programs into a folder</source>
        <translation>De gekozen programma&apos;s in een map opslaan</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Lagen</translation>
    </message>
    <message>
        <source>Go to this page</source>
        <translation>Naar deze pagina</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verplaatsen</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Draaien</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Schalen</translation>
    </message>
    <message>
        <source>&amp;Lay on face</source>
        <translation>Op v&amp;lak leggen</translation>
    </message>
    <message>
        <source>Click the face to place on the plate</source>
        <translation>Klik op het vlak dat op de plaat moet komen</translation>
    </message>
    <message>
        <source>&amp;Drop to plate</source>
        <translation>Op &amp;plaat zetten</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>Laat het onderdeel op de plaat zakken</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Centreren</translation>
    </message>
    <message>
        <source>Centres the part on the plate</source>
        <translation>Centreert het onderdeel op de plaat</translation>
    </message>
    <message>
        <source>Place on touched &amp;points…</source>
        <translation>Op aangeraakte p&amp;unten plaatsen…</translation>
    </message>
    <message>
        <source>Moves the part to a cylinder measured by touching</source>
        <translation>Verplaatst het onderdeel naar een door aantasten gemeten cilinder</translation>
    </message>
    <message>
        <source>&amp;Prepare</source>
        <translation>&amp;Voorbereiden</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Alle para&amp;meters herstellen</translation>
    </message>
    <message>
        <source>Resets every parameter to its default</source>
        <translation>Zet elke parameter terug op de standaardwaarde</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Simuleren</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Nieuw project</translation>
    </message>
    <message>
        <source>Start without a part</source>
        <translation>Beginnen zonder onderdeel</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Openen…</translation>
    </message>
    <message>
        <source>Open a mesh or a project</source>
        <translation>Een mesh of project openen</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>Vaas</translation>
    </message>
    <message>
        <source>A fluted vase, 60 mm high</source>
        <translation>Een gegroefde vaas, 60 mm hoog</translation>
    </message>
    <message>
        <source>Mushroom</source>
        <translation>Paddenstoel</translation>
    </message>
    <message>
        <source>A wide cap on a stem, made of voxels</source>
        <translation>Een brede hoed op een steel, van voxels</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Vork</translation>
    </message>
    <message>
        <source>A stem with two branches, made of voxels</source>
        <translation>Een steel met twee takken, van voxels</translation>
    </message>
    <message>
        <source>Dumb-bell for tension</source>
        <translation>Trekproefstaaf</translation>
    </message>
    <message>
        <source>A specimen of 165 × 19 × 3 mm</source>
        <translation>Een proefstuk van 165 × 19 × 3 mm</translation>
    </message>
    <message>
        <source>Bar for bending</source>
        <translation>Buigproefstaaf</translation>
    </message>
    <message>
        <source>A specimen of 250 × 10 × 5 mm</source>
        <translation>Een proefstuk van 250 × 10 × 5 mm</translation>
    </message>
    <message>
        <source>Plate with a hole</source>
        <translation>Plaat met gat</translation>
    </message>
    <message>
        <source>A specimen of 120 × 60 × 3 mm</source>
        <translation>Een proefstuk van 120 × 60 × 3 mm</translation>
    </message>
    <message>
        <source>Curved bar on its mould</source>
        <translation>Gebogen balk op zijn mal</translation>
    </message>
    <message>
        <source>Seven layers around a cylinder of 60 mm radius</source>
        <translation>Zeven lagen rond een cilinder met een straal van 60 mm</translation>
    </message>
    <message>
        <source>Rib on a gable roof</source>
        <translation>Rib op een zadeldak</translation>
    </message>
    <message>
        <source>Ten layers over both slopes; the nozzle tilts by 60°</source>
        <translation>Tien lagen over beide hellingen; de nozzle kantelt 60°</translation>
    </message>
    <message>
        <source>Rib on a half cylinder</source>
        <translation>Rib op een halve cilinder</translation>
    </message>
    <message>
        <source>Ten layers around it; the nozzle tilts by 87°</source>
        <translation>Tien lagen eromheen; de nozzle kantelt 87°</translation>
    </message>
    <message>
        <source>Accuracy plate</source>
        <translation>Nauwkeurigheidsplaat</translation>
    </message>
    <message>
        <source>Slots and a hole of known sizes, to be measured</source>
        <translation>Sleuven en een gat met bekende maten, om na te meten</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Op&amp;slaan</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Project opslaan</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Opslaan &amp;als…</translation>
    </message>
    <message>
        <source>Save the project under a new name</source>
        <translation>Project onder een nieuwe naam opslaan</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Plannen</translation>
    </message>
    <message>
        <source>From the part to verified robot programs</source>
        <translation>Van onderdeel tot geverifieerde robotprogramma&apos;s</translation>
    </message>
    <message>
        <source>Plan up to the &amp;layers</source>
        <translation>Plannen tot en met de &amp;lagen</translation>
    </message>
    <message>
        <source>Stops before tool-paths and motion</source>
        <translation>Stopt vóór gereedschapsbanen en beweging</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuleren</translation>
    </message>
    <message>
        <source>Stop; the last results stay visible</source>
        <translation>Stoppen; de laatste resultaten blijven zichtbaar</translation>
    </message>
    <message>
        <source>&amp;Update voxels while editing</source>
        <translation>Voxels &amp;bijwerken tijdens bewerken</translation>
    </message>
    <message>
        <source>After the first plan, voxels follow the settings; layers and paths wait for Plan</source>
        <translation>Na het eerste plan volgen de voxels de instellingen; lagen en banen wachten op Plannen</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Voor</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Achter</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Boven</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Onder</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Schuin</translation>
    </message>
    <message>
        <source>View from this side</source>
        <translation>Vanaf deze kant bekijken</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Bestand</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Be&amp;werken</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Beel&amp;d</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Uitvoeren</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xporteren</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Venster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Help</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Onlangs geopen&amp;d</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>&amp;Voorbeelden</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Taal</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>&amp;Alles tonen</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>Alles passend in beeld brengen</translation>
    </message>
    <message>
        <source>&amp;Section plane</source>
        <translation>&amp;Doorsnedevlak</translation>
    </message>
    <message>
        <source>Cut the view open with a plane</source>
        <translation>De weergave met een vlak opensnijden</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Legenda</translation>
    </message>
    <message>
        <source>Meaning of the colours in the view</source>
        <translation>Betekenis van de kleuren in de weergave</translation>
    </message>
    <message>
        <source>&amp;Unrolled layer</source>
        <translation>&amp;Uitgerolde laag</translation>
    </message>
    <message>
        <source>Shows layers around an axis unrolled, next to the view</source>
        <translation>Toont lagen rond een as uitgerold, naast de weergave</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Afspelen of pauzeren</translation>
    </message>
    <message>
        <source>Play or pause the time-line</source>
        <translation>De tijdlijn afspelen of pauzeren</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Volgende beweging</translation>
    </message>
    <message>
        <source>One move forward</source>
        <translation>Eén beweging vooruit</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Vorige beweging</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>Eén beweging terug</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Volgende laag</translation>
    </message>
    <message>
        <source>One layer forward</source>
        <translation>Eén laag vooruit</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Vorige laag</translation>
    </message>
    <message>
        <source>One layer back</source>
        <translation>Eén laag terug</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Afbeelding opslaan</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Afbeeldingen (*.png)</translation>
    </message>
    <message>
        <source>About Voluta</source>
        <translation>Over Voluta</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;3D printing with robot arms: layers without support, tool-paths, motion checked against the growing part, and programs verified by replay.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;3D-printen met robotarmen: lagen zonder ondersteuning, gereedschapsbanen, bewegingen gecontroleerd tegen het groeiende onderdeel, en programma&apos;s geverifieerd met een controlerun.&lt;/p&gt;&lt;p&gt;Vrije software onder de GNU General Public License, versie 3 of later.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>%1 ongedaan maken</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>%1 opnieuw</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>&amp;Resume print from here…</source>
        <translation>Print vanaf hier &amp;hervatten…</translation>
    </message>
    <message>
        <source>Opens the rest of a print stopped at this moment as a new project</source>
        <translation>Opent de rest van een op dit moment gestopte print als nieuw project</translation>
    </message>
    <message>
        <source>&amp;Verify a program…</source>
        <translation>Programma &amp;verifiëren…</translation>
    </message>
    <message>
        <source>Replay a program from disk against the plan shown</source>
        <translation>Controlerun van een programma op schijf tegen het getoonde plan</translation>
    </message>
    <message>
        <source>Edit &amp;cell…</source>
        <translation>&amp;Cel bewerken…</translation>
    </message>
    <message>
        <source>Robot, and positions of nozzle, plate and obstacles</source>
        <translation>Robot, en posities van nozzle, plaat en obstakels</translation>
    </message>
    <message>
        <source>Import robot &amp;arm…</source>
        <translation>Robot&amp;arm importeren…</translation>
    </message>
    <message>
        <source>Your own robot from its URDF, with a cell</source>
        <translation>Je eigen robot uit zijn URDF, met een cel</translation>
    </message>
    <message>
        <source>D&amp;uplicate part</source>
        <translation>Onderdeel d&amp;upliceren</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part beside the others</source>
        <translation>Voegt een kopie van het geselecteerde onderdeel naast de andere toe</translation>
    </message>
    <message>
        <source>&amp;Remove part</source>
        <translation>Onderdeel ve&amp;rwijderen</translation>
    </message>
    <message>
        <source>A&amp;dd part…</source>
        <translation>On&amp;derdeel toevoegen…</translation>
    </message>
    <message>
        <source>Adds a part beside the others</source>
        <translation>Voegt een onderdeel naast de andere toe</translation>
    </message>
    <message>
        <source>&amp;Arrange parts</source>
        <translation>&amp;Onderdelen schikken</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>Zet alle onderdelen naast elkaar, met ruimte voor de printkop</translation>
    </message>
    <message>
        <source>Processes and &amp;materials…</source>
        <translation>Processen en &amp;materialen…</translation>
    </message>
    <message>
        <source>Nozzle, bead sizes, speeds, head; own processes and materials</source>
        <translation>Nozzle, strengmaten, snelheden, kop; eigen processen en materialen</translation>
    </message>
    <message>
        <source>Compare with a recor&amp;ded run…</source>
        <translation>Vergelijken met een op&amp;genomen run…</translation>
    </message>
    <message>
        <source>Lays a run that the controller recorded beside the plan shown</source>
        <translation>Legt een door de besturing opgenomen run naast het getoonde plan</translation>
    </message>
    <message>
        <source>&amp;Mill from a block…</source>
        <translation>Uit een blok &amp;frezen…</translation>
    </message>
    <message>
        <source>Mills the part out of a block and writes the G-code, checked on the block</source>
        <translation>Freest het onderdeel uit een blok en schrijft de G-code, gecontroleerd op het blok</translation>
    </message>
    <message>
        <source>Print to&amp;gether with other machines…</source>
        <translation>&amp;Samen met andere machines printen…</translation>
    </message>
    <message>
        <source>Places other machines beside this one and finds an order of work in which they do not meet</source>
        <translation>Zet andere machines naast deze en zoekt een werkvolgorde waarin ze elkaar niet raken</translation>
    </message>
    <message>
        <source>Moves the part: drag a handle, or type X 10 Enter</source>
        <translation>Verplaatst het onderdeel: sleep een greep, of typ X 10 Enter</translation>
    </message>
    <message>
        <source>Rotates the part: drag a ring, or type Z 45 Enter</source>
        <translation>Draait het onderdeel: sleep een ring, of typ Z 45 Enter</translation>
    </message>
    <message>
        <source>Scales the part: drag a handle, or type 120 Enter for 120 %</source>
        <translation>Schaalt het onderdeel: sleep een greep, of typ 120 Enter voor 120 %</translation>
    </message>
    <message>
        <source>Removes the selected parts from the plate</source>
        <translation>Verwijdert de geselecteerde onderdelen van de plaat</translation>
    </message>
    <message>
        <source>&amp;Number of copies…</source>
        <translation>Aa&amp;ntal kopieën…</translation>
    </message>
    <message>
        <source>Prints the selected part several times, or as often as the plate has room</source>
        <translation>Print het geselecteerde onderdeel meermaals, of zo vaak als er op de plaat past</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiëren</translation>
    </message>
    <message>
        <source>Copies the selected parts with their settings</source>
        <translation>Kopieert de geselecteerde onderdelen met hun instellingen</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Plakken</translation>
    </message>
    <message>
        <source>Adds the copied parts beside the others</source>
        <translation>Voegt de gekopieerde onderdelen naast de andere toe</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles selecteren</translation>
    </message>
    <message>
        <source>Selects all parts, to copy or to remove them</source>
        <translation>Selecteert alle onderdelen, om ze te kopiëren of te verwijderen</translation>
    </message>
    <message>
        <source>Show the &amp;part</source>
        <translation>&amp;Onderdeel tonen</translation>
    </message>
    <message>
        <source>Fit the selected part into the view</source>
        <translation>Brengt het geselecteerde onderdeel passend in beeld</translation>
    </message>
    <message>
        <source>Show the &amp;arm</source>
        <translation>&amp;Arm tonen</translation>
    </message>
    <message>
        <source>On the Prepare page, shows the arm whole instead of dimmed behind the part</source>
        <translation>Toont de arm op de pagina Voorbereiden volledig in plaats van gedimd achter het onderdeel</translation>
    </message>
    <message>
        <source>&amp;Find a command or setting…</source>
        <translation>Opdracht of instelling &amp;zoeken…</translation>
    </message>
    <message>
        <source>Lists commands and settings while you type</source>
        <translation>Toont opdrachten en instellingen tijdens het typen</translation>
    </message>
    <message>
        <source>&amp;Quote…</source>
        <translation>&amp;Offerte…</translation>
    </message>
    <message>
        <source>Cost of the print, and its page for a customer</source>
        <translation>Kosten van de print, en de pagina voor een klant</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handleiding</translation>
    </message>
    <message>
        <source>The page of the manual about what is shown</source>
        <translation>De pagina van de handleiding over wat te zien is</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporteren…</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>M&amp;eten</translation>
    </message>
    <message>
        <source>Click places on the part: radius, wall, distance, angle</source>
        <translation>Klik op plaatsen van het onderdeel: straal, wand, afstand, hoek</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Licht</translation>
    </message>
    <message>
        <source>Dark text on a light background</source>
        <translation>Donkere tekst op een lichte achtergrond</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Hoog contrast</translation>
    </message>
    <message>
        <source>White text on black, with strong outlines</source>
        <translation>Witte tekst op zwart, met sterke omlijningen</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>&amp;Film…</translation>
    </message>
    <message>
        <source>Save a film of the robot that prints the part (WebM)</source>
        <translation>Een film opslaan van de robot die het onderdeel print (WebM)</translation>
    </message>
    <message>
        <source>C&amp;ut…</source>
        <translation>S&amp;nijden…</translation>
    </message>
    <message>
        <source>Cuts the part in two with a plane, with dowels, pegs or a dovetail</source>
        <translation>Snijdt het onderdeel in tweeën met een vlak, met deuvels, pennen of een zwaluwstaart</translation>
    </message>
    <message>
        <source>Split to &amp;parts</source>
        <translation>Splitsen in &amp;onderdelen</translation>
    </message>
    <message>
        <source>Makes a part of each body of the mesh</source>
        <translation>Maakt van elk lichaam van het net een onderdeel</translation>
    </message>
    <message>
        <source>Re&amp;name part</source>
        <translation>Onderdeel her&amp;noemen</translation>
    </message>
    <message>
        <source>Edits the name of the part in the tree</source>
        <translation>Bewerkt de naam van het onderdeel in de boom</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>&amp;Uiterlijk</translation>
    </message>
    <message>
        <source>Darken cor&amp;ners</source>
        <translation>&amp;Hoeken donkerder maken</translation>
    </message>
    <message>
        <source>Darkens corners and gaps, so that shapes are clearer; slow without a graphics card</source>
        <translation>Maakt hoeken en spleten donkerder, zodat vormen duidelijker zijn; traag zonder grafische kaart</translation>
    </message>
    <message>
        <source>Re&amp;gions…</source>
        <translation>&amp;Gebieden…</translation>
    </message>
    <message>
        <source>Places in the part with settings, or layers, of their own</source>
        <translation>Plaatsen in het onderdeel met eigen instellingen of lagen</translation>
    </message>
    <message>
        <source>Add &amp;region…</source>
        <translation>Gebied &amp;toevoegen…</translation>
    </message>
    <message>
        <source>Adds a place with settings, or layers, of its own</source>
        <translation>Voegt een plaats met eigen instellingen of lagen toe</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>&quot;{text}&quot; is not a point</source>
        <translation>&quot;{text}&quot; is geen punt</translation>
    </message>
    <message>
        <source>&apos;end&apos; closes no function</source>
        <translation>&apos;end&apos; sluit geen functie af</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not a number</source>
        <translation>&apos;{attribute}&apos; is geen getal</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not an integer</source>
        <translation>&apos;{attribute}&apos; is geen geheel getal</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex</source>
        <translation>&apos;{corner}&apos; is niet de index van een hoekpunt</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex read so far</source>
        <translation>&apos;{corner}&apos; is niet de index van een tot hier gelezen hoekpunt</translation>
    </message>
    <message>
        <source>&apos;{loaded}&apos; is not unloaded</source>
        <translation>&apos;{loaded}&apos; wordt niet ontladen</translation>
    </message>
    <message>
        <source>&apos;{member}&apos; in it {what}</source>
        <translation>&apos;{member}&apos; daarin {what}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is called outside the function</source>
        <translation>&apos;{name}&apos; wordt buiten de functie aangeroepen</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not of type {type}</source>
        <translation>&apos;{name}&apos; is niet van het type {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not declared as {type}</source>
        <translation>&apos;{name}&apos; is niet gedeclareerd als {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not known to the reader</source>
        <translation>&apos;{name}&apos; is onbekend voor de lezer</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a weight</source>
        <translation>&apos;{text}&apos; is geen gewicht</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a number</source>
        <translation>&apos;{text}&apos; is geen getal</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not expected here</source>
        <translation>&apos;{text}&apos; wordt hier niet verwacht</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not key=value</source>
        <translation>&apos;{text}&apos; heeft niet de vorm key=value</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is neither true nor false</source>
        <translation>&apos;{value}&apos; is noch true noch false</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a number</source>
        <translation>&apos;{value}&apos; is geen getal</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a whole number</source>
        <translation>&apos;{value}&apos; is geen geheel getal</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not one of {choices}</source>
        <translation>&apos;{value}&apos; is geen van {choices}</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is out of range</source>
        <translation>&apos;{value}&apos; valt buiten het bereik</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not known to the reader</source>
        <translation>&apos;{word}&apos; is onbekend voor de lezer</translation>
    </message>
    <message>
        <source>--ik: the quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>--ik: de lengte van het quaternion is {length:.4g}, niet 1</translation>
    </message>
    <message>
        <source>0: round rod. 3 or more: prism; its diameter is measured across the corners.</source>
        <translation>0: ronde staaf. 3 of meer: prisma; de diameter wordt over de hoeken gemeten.</translation>
    </message>
    <message>
        <source>Adaptive layers: largest distance between the edges of layers and the surface.</source>
        <translation>Adaptieve lagen: grootste afstand tussen de randen van lagen en het oppervlak.</translation>
    </message>
    <message>
        <source>Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp and trajectory.csv.</source>
        <translation>Voegt voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp en trajectory.csv toe.</translation>
    </message>
    <message>
        <source>Also writes programs that the replay refused, as refused-NAME. For inspection only: never run them.</source>
        <translation>Schrijft ook programma&apos;s die de controlerun heeft geweigerd, als refused-NAME. Alleen ter inspectie: nooit uitvoeren.</translation>
    </message>
    <message>
        <source>Beads along circles are written as arcs (G2 and G3, movec, MoveC, CIRC), within the resolution or 0.02 mm.</source>
        <translation>Strengen langs cirkels worden als bogen geschreven (G2 en G3, movec, MoveC, CIRC), binnen de resolutie of 0,02 mm.</translation>
    </message>
    <message>
        <source>Layers at constant radius around the axis, or at constant distance from the rod&apos;s profile.</source>
        <translation>Lagen met constante straal rond de as, of op constante afstand van het staafprofiel.</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>Strengen</translation>
    </message>
    <message>
        <source>an arc on a table that tilts is not understood</source>
        <translation>een boog op een kantelende tafel wordt niet begrepen</translation>
    </message>
    <message>
        <source>export straight lines</source>
        <translation>rechte lijnen exporteren</translation>
    </message>
    <message>
        <source>Number of beads along the outline of each layer.</source>
        <translation>Aantal strengen langs de omtrek van elke laag.</translation>
    </message>
    <message>
        <source>Colli-
sions</source>
        <translation>Bot-
singen</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Convex front</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Opdeling</translation>
    </message>
    <message>
        <source>Direction of straight lines on the first layer, measured from x to y.</source>
        <translation>Richting van rechte lijnen op de eerste laag, gemeten van x naar y.</translation>
    </message>
    <message>
        <source>Minimum distance of everything but the print head from printed material.</source>
        <translation>Minimale afstand van alles behalve de printkop tot geprint materiaal.</translation>
    </message>
    <message>
        <source>Minimum distance between links, plate, nozzle holder and obstacles.</source>
        <translation>Minimale afstand tussen schakels, plaat, nozzlehouder en obstakels.</translation>
    </message>
    <message>
        <source>ENDMODULE is missing: the file was cut short</source>
        <translation>ENDMODULE ontbreekt: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>ENDPROC without a procedure</source>
        <translation>ENDPROC zonder procedure</translation>
    </message>
    <message>
        <source>Fermat spiral</source>
        <translation>Fermatspiraal</translation>
    </message>
    <message>
        <source>Field rounds</source>
        <translation>Veldrondes</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Spleetvulling</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groep</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Groeistap</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Largest overhang, measured from the vertical, that prints without support; in all modes except curved.</source>
        <translation>Grootste overhang, gemeten vanaf de verticaal, die zonder ondersteuning print; in alle modi behalve curved.</translation>
    </message>
    <message>
        <source>Minimum distance by which the nozzle lifts off the part before it travels.</source>
        <translation>Minimale afstand waarover de nozzle van het onderdeel omhooggaat voordat hij verplaatst.</translation>
    </message>
    <message>
        <source>How many rotations of the part about the nozzle&apos;s axis are tried at each point.</source>
        <translation>Hoeveel rotaties van het onderdeel om de as van de nozzle per punt worden geprobeerd.</translation>
    </message>
    <message>
        <source>Points of beads are omitted if the path, the nozzle&apos;s direction, the bead&apos;s section and the speed stay within tolerance without them; this is the tolerance of the path. 0: all points are written. Cells with external axes keep all points.</source>
        <translation>Punten van strengen worden weggelaten als de baan, de richting van de nozzle, de strengdoorsnede en de snelheid zonder die punten binnen de tolerantie blijven; dit is de tolerantie van de baan. 0: alle punten worden geschreven. Cellen met externe assen behouden alle punten.</translation>
    </message>
    <message>
        <source>Rotation of straight lines from layer to layer; 0: the same direction throughout.</source>
        <translation>Draaiing van rechte lijnen van laag tot laag; 0: overal dezelfde richting.</translation>
    </message>
    <message>
        <source>Maximum number of rounds that fit the growth order and the smooth field to each other. 0: layers follow the growth order.</source>
        <translation>Maximaal aantal rondes waarin de groeivolgorde en het gladde veld op elkaar worden afgestemd. 0: lagen volgen de groeivolgorde.</translation>
    </message>
    <message>
        <source>Pattern that fills the interior of each layer.</source>
        <translation>Patroon dat het binnenste van elke laag vult.</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Soort</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Laag</translation>
    </message>
    <message>
        <source>Layer spacing</source>
        <translation>Laagafstand</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Surface on which flattening layers end: flat (at the part&apos;s top), flat:Z, radius:R (a larger cylinder) or mesh:FILE, placed together with the platform&apos;s mesh.</source>
        <translation>Vlak waarop afvlakkende lagen eindigen: flat (aan de bovenkant van het onderdeel), flat:Z, radius:R (een grotere cilinder) of mesh:FILE, geplaatst samen met de mesh van het platform.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Missed, cascade</source>
        <translation>Gemist, cascade</translation>
    </message>
    <message>
        <source>Missed, shadowed</source>
        <translation>Gemist, afgeschaduwd</translation>
    </message>
    <message>
        <source>Missed, unreached</source>
        <translation>Gemist, niet bereikt</translation>
    </message>
    <message>
        <source>Mode flat: a JSON file or JSON text with the plane or quadrilateral of each layer. Empty: horizontal layers.</source>
        <translation>Modus flat: een JSON-bestand of JSON-tekst met het vlak of de vierhoek van elke laag. Leeg: horizontale lagen.</translation>
    </message>
    <message>
        <source>Mode planar: a JSON file or JSON text with a point and a normal for each cutting plane, in cutting order. Empty: automatic.</source>
        <translation>Modus planar: een JSON-bestand of JSON-tekst met een punt en een normaal voor elk snijvlak, in snijvolgorde. Leeg: automatisch.</translation>
    </message>
    <message>
        <source>Mode planar: materials or filaments of the pieces, separated by commas. The list starts over if there are more pieces. Empty: the process&apos;s material.</source>
        <translation>Modus planar: materialen of filamenten van de delen, gescheiden door komma&apos;s. De lijst begint opnieuw als er meer delen zijn. Leeg: het materiaal van het proces.</translation>
    </message>
    <message>
        <source>Mode planar: beam is a beam search that checks the true shape of the head; greedy is the published scheme, based on the part&apos;s skeleton.</source>
        <translation>Modus planar: beam is een bundelzoektocht die de werkelijke vorm van de kop controleert; greedy is de gepubliceerde methode, gebaseerd op het skelet van het onderdeel.</translation>
    </message>
    <message>
        <source>Mode substrate: layers at constant distance from the surface, on spheres, on cylinders along x, or flattening from the surface to an end surface with varying thickness.</source>
        <translation>Modus substrate: lagen op constante afstand van het oppervlak, op bollen, op cilinders langs x, of afvlakkend van het oppervlak naar een eindvlak met variërende dikte.</translation>
    </message>
    <message>
        <source>Height of the first layer; in all modes except curved. 0: same as the other layers.</source>
        <translation>Hoogte van de eerste laag; in alle modi behalve curved. 0: gelijk aan de andere lagen.</translation>
    </message>
    <message>
        <source>Modes planar and flat: thinner layers where the surface is inclined, within the process&apos;s limits.</source>
        <translation>Modi planar en flat: dunnere lagen waar het oppervlak schuin staat, binnen de grenzen van het proces.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Beweging</translation>
    </message>
    <message>
        <source>Needs support</source>
        <translation>Ondersteuning nodig</translation>
    </message>
    <message>
        <source>For helical infill: 0 winds around the axis, 90 runs along it.</source>
        <translation>Voor spiraalvulling: 0 wikkelt om de as, 90 loopt langs de as.</translation>
    </message>
    <message>
        <source>Centre of spheres and cylinders: x,y,z in mm. Empty: that of the sphere or cylinder below the part, or a point below the part.</source>
        <translation>Middelpunt van bollen en cilinders: x,y,z in mm. Leeg: dat van de bol of cilinder onder het onderdeel, of een punt onder het onderdeel.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Uitvoer</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with such pairs. A step needs two pairs at the same x. Beyond the pairs the rod keeps its own diameter. Empty: straight.</source>
        <translation>Paren van x en straal in mm, zoals -20,2.5 0,2.5 0,3.5 20,3.5, of een bestand met zulke paren. Een trap vereist twee paren op dezelfde x. Buiten de paren behoudt de staaf zijn eigen diameter. Leeg: recht.</translation>
    </message>
    <message>
        <source>Peeling rank</source>
        <translation>Pelrang</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Deel</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Delen</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Plaatsing</translation>
    </message>
    <message>
        <source>RAPID (ABB)</source>
        <translation>RAPID (ABB)</translation>
    </message>
    <message>
        <source>Reach
%</source>
        <translation>Bereik
%</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Controlerun</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Staaf</translation>
    </message>
    <message>
        <source>Scheme greedy: number of thickness classes that distinguish the part&apos;s branches. 0: automatic.</source>
        <translation>Methode greedy: aantal dikteklassen dat de takken van het onderdeel onderscheidt. 0: automatisch.</translation>
    </message>
    <message>
        <source>Scheme greedy: a point x,y,z (mm) on the piece to print first; that piece must touch the plate. Empty: the piece with the largest contact area.</source>
        <translation>Methode greedy: een punt x,y,z (mm) op het deel dat eerst wordt geprint; dat deel moet de plaat raken. Leeg: het deel met het grootste contactoppervlak.</translation>
    </message>
    <message>
        <source>Head shape that must clear the part printed so far. flat: a plate of unlimited width. nozzle: the real head where voxels would be lost otherwise, and under wide roofs. auto: the real head only under wide roofs.</source>
        <translation>Vorm van de kop die vrij moet blijven van het al geprinte onderdeel. flat: een plaat van onbeperkte breedte. nozzle: de werkelijke kop waar anders voxels verloren zouden gaan, en onder brede daken. auto: de werkelijke kop alleen onder brede daken.</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>Skirt of brim</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Current growth step</source>
        <translation>Huidige groeistap</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Ondersteuning</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Ondersteuning</translation>
    </message>
    <message>
        <source>Supports
mm³</source>
        <translation>Ondersteuning
mm³</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oppervlak</translation>
    </message>
    <message>
        <source>Tilt of the nozzle</source>
        <translation>Kanteling van de nozzle</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Too thick to print</source>
        <translation>Te dik om te printen</translation>
    </message>
    <message>
        <source>Too thin to print</source>
        <translation>Te dun om te printen</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>Gereedschapsbanen</translation>
    </message>
    <message>
        <source>URScript (Universal Robots)</source>
        <translation>URScript (Universal Robots)</translation>
    </message>
    <message>
        <source>Use voxel width {fits}</source>
        <translation>Voxelbreedte {fits} gebruiken</translation>
    </message>
    <message>
        <source>Voxel width</source>
        <translation>Voxelbreedte</translation>
    </message>
    <message>
        <source>WaitTime without a time in seconds</source>
        <translation>WaitTime zonder tijd in seconden</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Nominal layer height; limited by the process.</source>
        <translation>Nominale laaghoogte; begrensd door het proces.</translation>
    </message>
    <message>
        <source>Nominal bead width; limited by the process.</source>
        <translation>Nominale strengbreedte; begrensd door het proces.</translation>
    </message>
    <message>
        <source>The axis of the part that is aligned with the rod. auto: the axis parallel to its sides.</source>
        <translation>De as van het onderdeel die met de staaf wordt uitgelijnd. auto: de as evenwijdig aan de zijden.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Voxel width used for growth; the layer height is independent of it.</source>
        <translation>Voxelbreedte voor de groei; de laaghoogte staat hier los van.</translation>
    </message>
    <message>
        <source>an arc from a position that is not known</source>
        <translation>een boog vanaf een onbekende positie</translation>
    </message>
    <message>
        <source>an arc that changes its height is not understood</source>
        <translation>een boog die van hoogte verandert wordt niet begrepen</translation>
    </message>
    <message>
        <source>an arc without its centre, I and J</source>
        <translation>een boog zonder middelpunt, I en J</translation>
    </message>
    <message>
        <source>arc fitting</source>
        <translation>boogbenadering</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for, or slice it with beads of this process</source>
        <translation>kies het proces waarvoor het bestand is geslicet, of slice het met strengen van dit proces</translation>
    </message>
    <message>
        <source>movec needs two poses</source>
        <translation>movec vereist twee poses</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>resolutie</translation>
    </message>
    <message>
        <source>the end of an arc is not at the distance of its start from the centre</source>
        <translation>het eindpunt van een boog ligt niet even ver van het middelpunt als het beginpunt</translation>
    </message>
    <message>
        <source>the file heats {heat}: programs heat as the material states, choose one that fits</source>
        <translation>het bestand verwarmt {heat}: programma&apos;s verwarmen volgens het materiaal, kies een passend materiaal</translation>
    </message>
    <message>
        <source>the three points of an arc are on a line</source>
        <translation>de drie punten van een boog liggen op één lijn</translation>
    </message>
    <message>
        <source>unknown G command</source>
        <translation>onbekend G-commando</translation>
    </message>
    <message>
        <source>a PLY file begins with &quot;ply&quot;</source>
        <translation>een PLY-bestand begint met &quot;ply&quot;</translation>
    </message>
    <message>
        <source>a call of a module that is not loaded</source>
        <translation>een aanroep van een module die niet is geladen</translation>
    </message>
    <message>
        <source>support column of {voxels} from {foot}: it carries {carried} that would be missed</source>
        <translation>steunkolom van {voxels} vanaf {foot}: draagt {carried} die anders gemist zouden worden</translation>
    </message>
    <message>
        <source>a configuration that is not in whole quarter turns</source>
        <translation>een configuratie die niet uit hele kwartslagen bestaat</translation>
    </message>
    <message>
        <source>a digital output must be 0 or 1</source>
        <translation>een digitale uitgang moet 0 of 1 zijn</translation>
    </message>
    <message>
        <source>a direction needs nX, nY and nZ</source>
        <translation>een richting vereist nX, nY en nZ</translation>
    </message>
    <message>
        <source>a direction is not a unit vector</source>
        <translation>een richting is geen eenheidsvector</translation>
    </message>
    <message>
        <source>a face refers to vertex {vertex} of {vertices}</source>
        <translation>een vlak verwijst naar hoekpunt {vertex} van {vertices}</translation>
    </message>
    <message>
        <source>a face needs its number of corners, then the corners</source>
        <translation>een vlak vereist het aantal hoeken, gevolgd door de hoeken</translation>
    </message>
    <message>
        <source>a face needs at least three corners</source>
        <translation>een vlak vereist ten minste drie hoeken</translation>
    </message>
    <message>
        <source>a facet with fewer than three vertices</source>
        <translation>een facet met minder dan drie hoekpunten</translation>
    </message>
    <message>
        <source>flow of {flow:.1f}, above the extruder&apos;s limit of {limit:.1f#}</source>
        <translation>doorvoer van {flow:.1f}, boven de grens van de extruder van {limit:.1f#}</translation>
    </message>
    <message>
        <source>a joint value far outside any limit</source>
        <translation>een gewrichtswaarde ver buiten elke grens</translation>
    </message>
    <message>
        <source>use a larger platform, or turn the part</source>
        <translation>gebruik een groter platform, of draai het onderdeel</translation>
    </message>
    <message>
        <source>use a larger platform or supports, or join this piece to the part</source>
        <translation>gebruik een groter platform of ondersteuning, of voeg dit deel samen met het onderdeel</translation>
    </message>
    <message>
        <source>a line does not end with CR LF</source>
        <translation>een regel eindigt niet met CR LF</translation>
    </message>
    <message>
        <source>a line without a command</source>
        <translation>een regel zonder commando</translation>
    </message>
    <message>
        <source>a list has an invalid length</source>
        <translation>een lijst heeft een ongeldige lengte</translation>
    </message>
    <message>
        <source>triangles with missing vertices</source>
        <translation>driehoeken met ontbrekende hoekpunten</translation>
    </message>
    <message>
        <source>a module must begin with MODULE and its name</source>
        <translation>een module moet beginnen met MODULE en zijn naam</translation>
    </message>
    <message>
        <source>a motion before X, Y and Z are all known</source>
        <translation>een beweging voordat X, Y en Z allemaal bekend zijn</translation>
    </message>
    <message>
        <source>a motion before any speed (F)</source>
        <translation>een beweging vóór een snelheid (F)</translation>
    </message>
    <message>
        <source>the motion never arrives: no speed or acceleration</source>
        <translation>de beweging komt nooit aan: geen snelheid of versnelling</translation>
    </message>
    <message>
        <source>a motion with a word {letter} is not understood</source>
        <translation>een beweging met een woord {letter} wordt niet begrepen</translation>
    </message>
    <message>
        <source>a motion without a target</source>
        <translation>een beweging zonder doel</translation>
    </message>
    <message>
        <source>a name is declared twice</source>
        <translation>een naam is twee keer gedeclareerd</translation>
    </message>
    <message>
        <source>use a narrower bead or a lower layer height for fine detail, supports for areas that begin in the air</source>
        <translation>gebruik een smallere streng of een lagere laaghoogte voor fijne details, ondersteuning voor gebieden die in de lucht beginnen</translation>
    </message>
    <message>
        <source>a picture of {width} x {height} pixels cannot be drawn</source>
        <translation>een afbeelding van {width} x {height} pixels kan niet worden getekend</translation>
    </message>
    <message>
        <source>a platform must be a mesh, not a voxel object</source>
        <translation>een platform moet een mesh zijn, geen voxelobject</translation>
    </message>
    <message>
        <source>a point has NaN or infinite coordinates</source>
        <translation>een punt heeft NaN of oneindige coördinaten</translation>
    </message>
    <message>
        <source>a point needs three numbers</source>
        <translation>een punt vereist drie getallen</translation>
    </message>
    <message>
        <source>point too far from the origin</source>
        <translation>punt te ver van de oorsprong</translation>
    </message>
    <message>
        <source>a pose before set_tcp: its TCP is unknown</source>
        <translation>een pose vóór set_tcp: de TCP is onbekend</translation>
    </message>
    <message>
        <source>a pose far outside any robot&apos;s reach</source>
        <translation>een pose ver buiten het bereik van elke robot</translation>
    </message>
    <message>
        <source>a pose p[x,y,z,rx,ry,rz] is needed</source>
        <translation>een pose p[x,y,z,rx,ry,rz] is vereist</translation>
    </message>
    <message>
        <source>a position far outside any robot&apos;s reach</source>
        <translation>een positie ver buiten het bereik van elke robot</translation>
    </message>
    <message>
        <source>a property of unknown type</source>
        <translation>een eigenschap van onbekend type</translation>
    </message>
    <message>
        <source>a quadrilateral cannot cut a part</source>
        <translation>een vierhoek kan geen onderdeel snijden</translation>
    </message>
    <message>
        <source>a quadrilateral needs four corners</source>
        <translation>een vierhoek vereist vier hoeken</translation>
    </message>
    <message>
        <source>a quaternion that is not normalised</source>
        <translation>een quaternion die niet genormaliseerd is</translation>
    </message>
    <message>
        <source>a rod is round or has at least three sides</source>
        <translation>een staaf is rond of heeft ten minste drie zijden</translation>
    </message>
    <message>
        <source>a rod needs at least two points</source>
        <translation>een staaf vereist ten minste twee punten</translation>
    </message>
    <message>
        <source>row beyond the end of its array</source>
        <translation>rij voorbij het einde van de array</translation>
    </message>
    <message>
        <source>a second, different TCP</source>
        <translation>een tweede, andere TCP</translation>
    </message>
    <message>
        <source>a second, different tool</source>
        <translation>een tweede, ander gereedschap</translation>
    </message>
    <message>
        <source>a shifted origin is not understood</source>
        <translation>een verschoven oorsprong wordt niet begrepen</translation>
    </message>
    <message>
        <source>a space</source>
        <translation>een spatie</translation>
    </message>
    <message>
        <source>an invalid speed</source>
        <translation>een ongeldige snelheid</translation>
    </message>
    <message>
        <source>a speed that is not positive</source>
        <translation>een snelheid die niet positief is</translation>
    </message>
    <message>
        <source>a statement outside the procedure</source>
        <translation>een instructie buiten de procedure</translation>
    </message>
    <message>
        <source>a step at the end of the rod</source>
        <translation>een trap aan het einde van de staaf</translation>
    </message>
    <message>
        <source>target with fewer than six joints</source>
        <translation>doel met minder dan zes gewrichten</translation>
    </message>
    <message>
        <source>an invalid time</source>
        <translation>een ongeldige tijd</translation>
    </message>
    <message>
        <source>a transform does not have twelve numbers</source>
        <translation>een transformatie heeft geen twaalf getallen</translation>
    </message>
    <message>
        <source>a transform contains a value that is not a number</source>
        <translation>een transformatie bevat een waarde die geen getal is</translation>
    </message>
    <message>
        <source>a triangle refers to the missing vertex {vertex}</source>
        <translation>een driehoek verwijst naar het ontbrekende hoekpunt {vertex}</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>een hoekpunt vereist drie getallen</translation>
    </message>
    <message>
        <source>use a voxel width of at most {fits}</source>
        <translation>gebruik een voxelbreedte van hoogstens {fits}</translation>
    </message>
    <message>
        <source>wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}</source>
        <translation>wand {usual:.2f} dik ({thinnest:.2f} op het dunste punt), dunner dan een voxel van {voxel}</translation>
    </message>
    <message>
        <source>a waypoint number has to be an integer of at least -1</source>
        <translation>een baanpuntnummer moet een geheel getal van ten minste -1 zijn</translation>
    </message>
    <message>
        <source>a work object must name the mechanical unit that moves it, or be stationary</source>
        <translation>een werkobject moet de mechanische eenheid noemen die het beweegt, of stilstaan</translation>
    </message>
    <message>
        <source>an invalid zone</source>
        <translation>een ongeldige zone</translation>
    </message>
    <message>
        <source>a zone for orientation or external axes smaller than the TCP&apos;s</source>
        <translation>een zone voor oriëntatie of externe assen kleiner dan die van de TCP</translation>
    </message>
    <message>
        <source>a {type} must have other components</source>
        <translation>een {type} moet andere componenten hebben</translation>
    </message>
    <message>
        <source>adaptive layers</source>
        <translation>adaptieve lagen</translation>
    </message>
    <message>
        <source>add a row of - under the part, where it should be placed</source>
        <translation>voeg onder het onderdeel een rij met - toe, waar het geplaatst moet worden</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), cut there, or use curved mode</source>
        <translation>voeg ondersteuning toe (`supports=auto`), snijd daar, of gebruik modus curved</translation>
    </message>
    <message>
        <source>along</source>
        <translation>langs de as</translation>
    </message>
    <message>
        <source>unknown M command</source>
        <translation>onbekend M-commando</translation>
    </message>
    <message>
        <source>an OFF file begins with &quot;OFF&quot;</source>
        <translation>een OFF-bestand begint met &quot;OFF&quot;</translation>
    </message>
    <message>
        <source>an analogue output outside 0..1</source>
        <translation>een analoge uitgang buiten 0..1</translation>
    </message>
    <message>
        <source>an argument of {name} is unknown or given twice</source>
        <translation>een argument van {name} is onbekend of dubbel opgegeven</translation>
    </message>
    <message>
        <source>an element needs its count</source>
        <translation>een element vereist zijn aantal</translation>
    </message>
    <message>
        <source>an external axis far outside any limit</source>
        <translation>een externe as ver buiten elke grens</translation>
    </message>
    <message>
        <source>an external axis that moves no work object is not supported</source>
        <translation>een externe as die geen werkobject beweegt wordt niet ondersteund</translation>
    </message>
    <message>
        <source>an output needs a number and a value</source>
        <translation>een uitgang vereist een nummer en een waarde</translation>
    </message>
    <message>
        <source>an unknown PLY format</source>
        <translation>een onbekend PLY-formaat</translation>
    </message>
    <message>
        <source>an unknown line in the header</source>
        <translation>een onbekende regel in de kop</translation>
    </message>
    <message>
        <source>further defects from here on are not listed</source>
        <translation>verdere gebreken vanaf hier worden niet vermeld</translation>
    </message>
    <message numerus="yes">
        <source>{count} more collisions</source>
        <translation>
            <numerusform>nog één botsing</numerusform>
            <numerusform>nog {count} botsingen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more violations</source>
        <translation>
            <numerusform>nog één overschrijding</numerusform>
            <numerusform>nog {count} overschrijdingen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more waypoints, the first: {what}</source>
        <translation>
            <numerusform>nog één baanpunt: {what}</numerusform>
            <numerusform>nog {count} baanpunten, het eerste: {what}</numerusform>
        </translation>
    </message>
    <message>
        <source>{length:.0f} of the file&apos;s beads are outside the limits of process {process} (width {widthMin:.3g} to {widthMax:.3g}, height {heightMin:.3g} to {heightMax:.3g}): the worst is {width:.2f} wide and {height:.2f} high</source>
        <translation>{length:.0f} van de strengen in het bestand valt buiten de grenzen van proces {process} (breedte {widthMin:.3g} tot {widthMax:.3g}, hoogte {heightMin:.3g} tot {heightMax:.3g}): de ergste is {width:.2f} breed en {height:.2f} hoog</translation>
    </message>
    <message numerus="yes">
        <source>{what}; {more} more voxels depend on this</source>
        <translation>
            <numerusform>{what}; nog één voxel hangt hiervan af</numerusform>
            <numerusform>{what}; nog {more} voxels hangen hiervan af</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part or add supports</source>
        <translation>draai het onderdeel of voeg ondersteuning toe</translation>
    </message>
    <message>
        <source>another column</source>
        <translation>nog een kolom</translation>
    </message>
    <message>
        <source>argument {key} is not a valid number</source>
        <translation>argument {key} is geen geldig getal</translation>
    </message>
    <message>
        <source>around</source>
        <translation>om de as</translation>
    </message>
    <message>
        <source>at {point:.1f}</source>
        <translation>op {point:.1f}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>as</translation>
    </message>
    <message>
        <source>part axis</source>
        <translation>as van het onderdeel</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>strengbreedte</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>bundel</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; of the job file is damaged</source>
        <translation>blok &apos;{name}&apos; van het opdrachtbestand is beschadigd</translation>
    </message>
    <message>
        <source>break it off after printing</source>
        <translation>breek het na het printen af</translation>
    </message>
    <message>
        <source>broken precondition: {what}</source>
        <translation>geschonden voorwaarde: {what}</translation>
    </message>
    <message>
        <source>byte {code}</source>
        <translation>byte {code}</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>kan niet tot het einde worden gelezen</translation>
    </message>
    <message>
        <source>cannot be read: {why}</source>
        <translation>kan niet worden gelezen: {why}</translation>
    </message>
    <message>
        <source>cannot be written: {why}</source>
        <translation>kan niet worden geschreven: {why}</translation>
    </message>
    <message>
        <source>cell {cell}</source>
        <translation>cel {cell}</translation>
    </message>
    <message>
        <source>cell {cell} has a rod, but mode {mode} prints on a plate</source>
        <translation>cel {cell} heeft een staaf, maar modus {mode} print op een plaat</translation>
    </message>
    <message>
        <source>cell {id} has no rod to print on</source>
        <translation>cel {id} heeft geen staaf om op te printen</translation>
    </message>
    <message>
        <source>layer centre</source>
        <translation>laagmiddelpunt</translation>
    </message>
    <message>
        <source>check the flow and the infill density</source>
        <translation>controleer de doorvoer en de vullingsdichtheid</translation>
    </message>
    <message>
        <source>checking layers</source>
        <translation>lagen controleren</translation>
    </message>
    <message>
        <source>checking the motion</source>
        <translation>beweging controleren</translation>
    </message>
    <message>
        <source>choose a smaller `voxelMm` or `beadWidthMm`</source>
        <translation>kies een kleinere `voxelMm` of `beadWidthMm`</translation>
    </message>
    <message>
        <source>choose layers that reach all of it (`layerShape`, `layerCentre`, `endSurface`)</source>
        <translation>kies lagen die het hele onderdeel bereiken (`layerShape`, `layerCentre`, `endSurface`)</translation>
    </message>
    <message>
        <source>choose {least} to {most} pixels per side</source>
        <translation>kies {least} tot {most} pixels per zijde</translation>
    </message>
    <message>
        <source>arm clearance</source>
        <translation>vrije afstand van de arm</translation>
    </message>
    <message>
        <source>clearance to the part</source>
        <translation>vrije afstand tot het onderdeel</translation>
    </message>
    <message numerus="yes">
        <source>closed {count} holes, the largest of {edges} edges at {at:.2f}</source>
        <translation>
            <numerusform>één gat gesloten, van {edges} randen bij {at:.2f}</numerusform>
            <numerusform>{count} gaten gesloten, het grootste van {edges} randen bij {at:.2f}</numerusform>
        </translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>botsingen</translation>
    </message>
    <message>
        <source>comparing with the plan</source>
        <translation>vergelijken met het plan</translation>
    </message>
    <message>
        <source>concentric</source>
        <translation>concentrisch</translation>
    </message>
    <message>
        <source>contact area + {sizes} mm</source>
        <translation>contactoppervlak + {sizes} mm</translation>
    </message>
    <message numerus="yes">
        <source>cut it off after printing: it touches the part at {faces} more faces</source>
        <translation>
            <numerusform>snijd het na het printen af: het raakt het onderdeel aan nog één vlak</numerusform>
            <numerusform>snijd het na het printen af: het raakt het onderdeel aan nog {faces} vlakken</numerusform>
        </translation>
    </message>
    <message>
        <source>truncated</source>
        <translation>afgekapt</translation>
    </message>
    <message>
        <source>truncated within a facet</source>
        <translation>afgekapt binnen een facet</translation>
    </message>
    <message>
        <source>truncated, or not a mesh: {what}</source>
        <translation>afgekapt, of geen mesh: {what}</translation>
    </message>
    <message>
        <source>truncated: {bytes} bytes are too few for an STL file</source>
        <translation>afgekapt: {bytes} bytes zijn te weinig voor een STL-bestand</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} faces</source>
        <translation>afgekapt: {there} van {wanted} vlakken</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} vertices</source>
        <translation>afgekapt: {there} van {wanted} hoekpunten</translation>
    </message>
    <message>
        <source>cut {number}</source>
        <translation>snede {number}</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>snijden</translation>
    </message>
    <message>
        <source>cutting layers</source>
        <translation>lagen snijden</translation>
    </message>
    <message>
        <source>cutting layers from the field</source>
        <translation>lagen uit het veld snijden</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>snijvlakken</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cilinder</translation>
    </message>
    <message>
        <source>damaged STL: {what}</source>
        <translation>beschadigde STL: {what}</translation>
    </message>
    <message>
        <source>data of the type {type} is not known to the reader</source>
        <translation>gegevens van het type {type} zijn onbekend voor de lezer</translation>
    </message>
    <message>
        <source>did you mean &apos;{name}&apos;?</source>
        <translation>bedoelde je &apos;{name}&apos;?</translation>
    </message>
    <message>
        <source>did you mean {name}?</source>
        <translation>bedoelde je {name}?</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>richtingen</translation>
    </message>
    <message>
        <source>disc, {sizes} mm</source>
        <translation>schijf, {sizes} mm</translation>
    </message>
    <message>
        <source>is {height} by default, more than the default of beadWidthMm, {width}: beads are no higher than wide</source>
        <translation>is standaard {height}, meer dan de standaardwaarde van beadWidthMm, {width}: strengen zijn niet hoger dan breed</translation>
    </message>
    <message>
        <source>is {tolerance}, not less than the maximum of layerHeightMm, {height}: the head would pass through a layer</source>
        <translation>is {tolerance}, niet minder dan het maximum van layerHeightMm, {height}: de kop zou door een laag gaan</translation>
    </message>
    <message>
        <source>is {most:.3g} mm3/s, less than the smallest bead needs at speedMmPerS, {flow:.3g} mm3/s</source>
        <translation>is {most:.3g} mm3/s, minder dan de kleinste streng nodig heeft bij speedMmPerS, {flow:.3g} mm3/s</translation>
    </message>
    <message>
        <source>does not rise from z = 0</source>
        <translation>stijgt niet vanaf z = 0</translation>
    </message>
    <message>
        <source>drop it to the plate</source>
        <translation>laat het op de plaat zakken</translation>
    </message>
    <message>
        <source>drop it to the plate, or choose a platform below it</source>
        <translation>laat het op de plaat zakken, of kies een platform eronder</translation>
    </message>
    <message>
        <source>move the part down to the plate</source>
        <translation>verplaats het onderdeel omlaag naar de plaat</translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} duplicate triangles</source>
        <translation>
            <numerusform>één dubbele driehoek verwijderd</numerusform>
            <numerusform>{count} dubbele driehoeken verwijderd</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles of sheets without volume</source>
        <translation>
            <numerusform>één driehoek van vellen zonder volume verwijderd</numerusform>
            <numerusform>{count} driehoeken van vellen zonder volume verwijderd</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles without area</source>
        <translation>
            <numerusform>één driehoek zonder oppervlakte verwijderd</numerusform>
            <numerusform>{count} driehoeken zonder oppervlakte verwijderd</numerusform>
        </translation>
    </message>
    <message>
        <source>eax_a is missing: an external axis moves the work object</source>
        <translation>eax_a ontbreekt: een externe as beweegt het werkobject</translation>
    </message>
    <message>
        <source>end surface</source>
        <translation>eindvlak</translation>
    </message>
    <message>
        <source>`endSurface` &apos;{text}&apos; is not an end surface</source>
        <translation>`endSurface` &apos;{text}&apos; is geen eindvlak</translation>
    </message>
    <message>
        <source>`endSurface` mesh:FILE requires a platform that is a body</source>
        <translation>`endSurface` mesh:FILE vereist een platform dat een lichaam is</translation>
    </message>
    <message>
        <source>ending layers on the surface</source>
        <translation>lagen op het oppervlak laten eindigen</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>exporteer of kopieer het bestand opnieuw</translation>
    </message>
    <message>
        <source>the extruded volume decreases</source>
        <translation>het geëxtrudeerde volume neemt af</translation>
    </message>
    <message>
        <source>fewest missed voxels</source>
        <translation>minste gemiste voxels</translation>
    </message>
    <message>
        <source>field</source>
        <translation>veld</translation>
    </message>
    <message>
        <source>file {file}, line {line}</source>
        <translation>bestand {file}, regel {line}</translation>
    </message>
    <message>
        <source>file {file}, line {line}: {what}</source>
        <translation>bestand {file}, regel {line}: {what}</translation>
    </message>
    <message>
        <source>fill the hollow first, or use `layerShape=offset`</source>
        <translation>vul eerst de holte, of gebruik `layerShape=offset`</translation>
    </message>
    <message>
        <source>first layer</source>
        <translation>eerste laag</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>vlak</translation>
    </message>
    <message>
        <source>flatten</source>
        <translation>afvlakken</translation>
    </message>
    <message>
        <source>flattening</source>
        <translation>afvlakking</translation>
    </message>
    <message>
        <source>front</source>
        <translation>front</translation>
    </message>
    <message>
        <source>give `--cell lathe`</source>
        <translation>geef `--cell lathe` op</translation>
    </message>
    <message>
        <source>give `--mode {modes}`, or another cell</source>
        <translation>geef `--mode {modes}` op, of een andere cel</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`</source>
        <translation>geef `--platform {platforms}` op</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`, or `endSurface` flat:Z</source>
        <translation>geef `--platform {platforms}` op, of `endSurface` flat:Z</translation>
    </message>
    <message>
        <source>give 0, or {least#} to {most}</source>
        <translation>geef 0 op, of {least#} tot {most}</translation>
    </message>
    <message>
        <source>choose a higher end surface (`endSurface`)</source>
        <translation>kies een hoger eindvlak (`endSurface`)</translation>
    </message>
    <message>
        <source>give a list of {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} or {&quot;corners&quot;: [four points]}, in mm</source>
        <translation>geef een lijst op van {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} of {&quot;corners&quot;: [four points]}, in mm</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>geef een getal op</translation>
    </message>
    <message>
        <source>give a number from 0.0001 to 10000, or fit</source>
        <translation>geef een getal van 0.0001 tot 10000 op, of fit</translation>
    </message>
    <message>
        <source>give all slices the same number of rows</source>
        <translation>geef alle sneden hetzelfde aantal rijen</translation>
    </message>
    <message>
        <source>give an STL, OBJ, PLY, OFF or 3MF file</source>
        <translation>geef een STL-, OBJ-, PLY-, OFF- of 3MF-bestand op</translation>
    </message>
    <message>
        <source>choose an end surface over the part&apos;s foot</source>
        <translation>kies een eindvlak boven de voet van het onderdeel</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a narrower part</source>
        <translation>kies een eindvlak met een vorm die er meer op lijkt, of een smaller onderdeel</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a smaller part</source>
        <translation>kies een eindvlak met een vorm die er meer op lijkt, of een kleiner onderdeel</translation>
    </message>
    <message>
        <source>give `endSurface=flat:Z` or mesh:FILE</source>
        <translation>geef `endSurface=flat:Z` of mesh:FILE op</translation>
    </message>
    <message>
        <source>give `orient=none`</source>
        <translation>geef `orient=none` op</translation>
    </message>
    <message>
        <source>use other cutting planes (`cutPlanes`), turn the part, or use curved mode</source>
        <translation>gebruik andere snijvlakken (`cutPlanes`), draai het onderdeel, of gebruik modus curved</translation>
    </message>
    <message>
        <source>give pairs of x and radius in mm, x ascending</source>
        <translation>geef paren van x en straal in mm op, x oplopend</translation>
    </message>
    <message>
        <source>give planes: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</source>
        <translation>geef vlakken op: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</translation>
    </message>
    <message>
        <source>verify it against the job it was written from</source>
        <translation>controleer het aan de hand van de opdracht waaruit het is geschreven</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>geef true of false op</translation>
    </message>
    <message>
        <source>give {field} from {least#} to {most}</source>
        <translation>geef {field} op van {least#} tot {most}</translation>
    </message>
    <message>
        <source>give {forms}</source>
        <translation>geef {forms} op</translation>
    </message>
    <message>
        <source>give {key}=NUMBER, 0 or more</source>
        <translation>geef {key}=NUMBER op, 0 of meer</translation>
    </message>
    <message>
        <source>give {least#} to {most}</source>
        <translation>geef {least#} tot {most} op</translation>
    </message>
    <message>
        <source>give {least} to {most}</source>
        <translation>geef {least} tot {most} op</translation>
    </message>
    <message>
        <source>give {least} to {most} {unit}</source>
        <translation>geef {least} tot {most} {unit} op</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>greedy</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>groei</translation>
    </message>
    <message>
        <source>must have minDeg below maxDeg</source>
        <translation>minDeg moet kleiner zijn dan maxDeg</translation>
    </message>
    <message>
        <source>must not have zero length</source>
        <translation>mag geen lengte nul hebben</translation>
    </message>
    <message>
        <source>head</source>
        <translation>kop</translation>
    </message>
    <message>
        <source>helical</source>
        <translation>spiraalvormig</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>houder</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>inches</translation>
    </message>
    <message>
        <source>inches are not understood</source>
        <translation>inches worden niet begrepen</translation>
    </message>
    <message>
        <source>infill</source>
        <translation>vulling</translation>
    </message>
    <message>
        <source>infill &apos;{infill}&apos; needs an axis to wind around, but layer {layer} has none</source>
        <translation>vulling &apos;{infill}&apos; vereist een as om omheen te wikkelen, maar laag {layer} heeft er geen</translation>
    </message>
    <message>
        <source>infill density</source>
        <translation>vullingsdichtheid</translation>
    </message>
    <message>
        <source>infill direction</source>
        <translation>vullingsrichting</translation>
    </message>
    <message>
        <source>install Mesa (libegl1, libgl1-mesa-dri)</source>
        <translation>installeer Mesa (libegl1, libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>is &apos;{id}&apos;, but the file is named &apos;{file}&apos;</source>
        <translation>is &apos;{id}&apos;, maar het bestand heet &apos;{file}&apos;</translation>
    </message>
    <message>
        <source>is a directory, not a file</source>
        <translation>is een map, geen bestand</translation>
    </message>
    <message>
        <source>is truncated</source>
        <translation>is afgekapt</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>is beschadigd</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>is versleuteld</translation>
    </message>
    <message>
        <source>is larger than 1 GB</source>
        <translation>is groter dan 1 GB</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>ontbreekt</translation>
    </message>
    <message>
        <source>is outside the joint&apos;s limits</source>
        <translation>ligt buiten de grenzen van het gewricht</translation>
    </message>
    <message>
        <source>is compressed with an unsupported method</source>
        <translation>is gecomprimeerd met een niet-ondersteunde methode</translation>
    </message>
    <message>
        <source>is already used: &apos;{name}&apos;</source>
        <translation>wordt al gebruikt: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>it is a file, not a folder</source>
        <translation>het is een bestand, geen map</translation>
    </message>
    <message>
        <source>two blends overlap, {blend:.3f} in all on a motion of {way:.3f}: the controller skips the waypoint</source>
        <translation>twee afrondingen overlappen, samen {blend:.3f} op een beweging van {way:.3f}: de besturing slaat het baanpunt over</translation>
    </message>
    <message>
        <source>joint {number}</source>
        <translation>gewricht {number}</translation>
    </message>
    <message>
        <source>place the part on a larger face, or use other cutting planes (`cutPlanes`)</source>
        <translation>plaats het onderdeel op een groter vlak, of gebruik andere snijvlakken (`cutPlanes`)</translation>
    </message>
    <message>
        <source>layer height</source>
        <translation>laaghoogte</translation>
    </message>
    <message>
        <source>layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</source>
        <translation>laag {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</translation>
    </message>
    <message>
        <source>`layerCentre` &apos;{text}&apos; is not a point</source>
        <translation>`layerCentre` &apos;{text}&apos; is geen punt</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>lagen</translation>
    </message>
    <message>
        <source>layers are 1 to {count}</source>
        <translation>de lagen lopen van 1 tot {count}</translation>
    </message>
    <message>
        <source>layers around the rod</source>
        <translation>lagen rondom de staaf</translation>
    </message>
    <message>
        <source>layers on this surface would fold from layer {layer} on: its normals cross before the end surface</source>
        <translation>lagen op dit oppervlak zouden vanaf laag {layer} omvouwen: de normalen kruisen elkaar vóór het eindvlak</translation>
    </message>
    <message>
        <source>depositing beads</source>
        <translation>strengen leggen</translation>
    </message>
    <message>
        <source>minimum overhang</source>
        <translation>kleinste overhang</translation>
    </message>
    <message>
        <source>least overhang of pieces</source>
        <translation>kleinste overhang van de delen</translation>
    </message>
    <message>
        <source>least residual area</source>
        <translation>kleinste restoppervlakte</translation>
    </message>
    <message>
        <source>leaves a piece without a base</source>
        <translation>laat een deel zonder basis achter</translation>
    </message>
    <message>
        <source>leaves a piece only {thickness:.2g} thick, thinner than a bead ({least})</source>
        <translation>laat een deel van slechts {thickness:.2g} dik achter, dunner dan een streng ({least})</translation>
    </message>
    <message>
        <source>omitted: {what}</source>
        <translation>weggelaten: {what}</translation>
    </message>
    <message>
        <source>left to the controller</source>
        <translation>aan de besturing overgelaten</translation>
    </message>
    <message>
        <source>lengths taken as mm: unknown unit &apos;{unit}&apos;</source>
        <translation>lengtes opgevat als mm: onbekende eenheid &apos;{unit}&apos;</translation>
    </message>
    <message>
        <source>lengths converted from {unit} to mm</source>
        <translation>lengtes omgerekend van {unit} naar mm</translation>
    </message>
    <message>
        <source>reduce the flow, or space the beads further apart</source>
        <translation>verlaag de doorvoer, of leg de strengen verder uit elkaar</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the rod there</source>
        <translation>geef het onderdeel daar een flauwere helling vanaf de staaf</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the surface there</source>
        <translation>geef het onderdeel daar een flauwere helling vanaf het oppervlak</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>optillen</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>grens</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>regel {line}</translation>
    </message>
    <message>
        <source>line {line}: {what}</source>
        <translation>regel {line}: {what}</translation>
    </message>
    <message>
        <source>load</source>
        <translation>laden</translation>
    </message>
    <message>
        <source>longest side {longest:.4g}: the file may be in {unit} (scale {scale})</source>
        <translation>langste zijde {longest:.4g}: het bestand staat mogelijk in {unit} (schaal {scale})</translation>
    </message>
    <message>
        <source>checking support below the beads</source>
        <translation>ondersteuning onder de strengen controleren</translation>
    </message>
    <message>
        <source>checking for collisions</source>
        <translation>op botsingen controleren</translation>
    </message>
    <message>
        <source>saved by a newer version of Voluta (format {format}; this version reads up to {newest})</source>
        <translation>opgeslagen door een nieuwere versie van Voluta (formaat {format}; deze versie leest tot en met {newest})</translation>
    </message>
    <message>
        <source>make all rows equally long</source>
        <translation>maak alle rijen even lang</translation>
    </message>
    <message>
        <source>make the feature narrower</source>
        <translation>maak het vormelement smaller</translation>
    </message>
    <message>
        <source>make the object from fewer and larger cells</source>
        <translation>maak het object uit minder en grotere cellen</translation>
    </message>
    <message>
        <source>make the part narrower, or use `layerShape=offset`</source>
        <translation>maak het onderdeel smaller, of gebruik `layerShape=offset`</translation>
    </message>
    <message>
        <source>piece materials</source>
        <translation>materialen van de delen</translation>
    </message>
    <message>
        <source>measuring the beads</source>
        <translation>strengen meten</translation>
    </message>
    <message>
        <source>repair it in a modelling program</source>
        <translation>repareer het in een modelleerprogramma</translation>
    </message>
    <message>
        <source>repair the mesh in a modelling program if the result looks wrong</source>
        <translation>repareer de mesh in een modelleerprogramma als het resultaat er verkeerd uitziet</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} duplicate points</source>
        <translation>
            <numerusform>één dubbel punt samengevoegd</numerusform>
            <numerusform>{count} dubbele punten samengevoegd</numerusform>
        </translation>
    </message>
    <message>
        <source>metres</source>
        <translation>meter</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micrometer</translation>
    </message>
    <message>
        <source>missed voxels</source>
        <translation>gemiste voxels</translation>
    </message>
    <message>
        <source>mode {mode} does not print on platform {platform}</source>
        <translation>modus {mode} print niet op platform {platform}</translation>
    </message>
    <message>
        <source>mode {mode} prints around a rod, but cell {cell} has none</source>
        <translation>modus {mode} print rondom een staaf, maar cel {cell} heeft er geen</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>beweging</translation>
    </message>
    <message>
        <source>move it so that it crosses the part</source>
        <translation>verplaats het zodat het het onderdeel kruist</translation>
    </message>
    <message>
        <source>move or tilt the plane slightly</source>
        <translation>verplaats of kantel het vlak een beetje</translation>
    </message>
    <message>
        <source>move the part along the rod, or use a longer rod</source>
        <translation>verplaats het onderdeel langs de staaf, of gebruik een langere staaf</translation>
    </message>
    <message>
        <source>move the part on the rod, or extend it down to the rod there</source>
        <translation>verplaats het onderdeel op de staaf, of verleng het daar tot op de staaf</translation>
    </message>
    <message>
        <source>move the part on the surface, or extend it down to the surface there</source>
        <translation>verplaats het onderdeel op het oppervlak, of verleng het daar tot op het oppervlak</translation>
    </message>
    <message>
        <source>move the part onto the rod</source>
        <translation>verplaats het onderdeel tot op de staaf</translation>
    </message>
    <message>
        <source>move the part onto the surface</source>
        <translation>verplaats het onderdeel tot op het oppervlak</translation>
    </message>
    <message>
        <source>move the part out of the surface, or print it larger</source>
        <translation>verplaats het onderdeel uit het oppervlak, of print het groter</translation>
    </message>
    <message>
        <source>move the plane or remove it</source>
        <translation>verplaats of verwijder het vlak</translation>
    </message>
    <message>
        <source>move the plane, or point its normal to the side to cut off</source>
        <translation>verplaats het vlak, of richt de normaal naar de kant die wordt afgesneden</translation>
    </message>
    <message>
        <source>move the planes, or add planes between them</source>
        <translation>verplaats de vlakken, of voeg er vlakken tussen toe</translation>
    </message>
    <message>
        <source>move or remove them</source>
        <translation>verplaats of verwijder ze</translation>
    </message>
    <message>
        <source>must be a capsule, a box or a frustum</source>
        <translation>moet een capsule, een balk of een afgeknotte kegel zijn</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>moet een eindig getal zijn</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>moet een lijst zijn</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>moet een getal zijn</translation>
    </message>
    <message>
        <source>must be a pair of height and radius</source>
        <translation>moet een paar van hoogte en straal zijn</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>moet een tekst zijn</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>moet een geheel getal zijn</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>moet een object zijn</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>moet groter zijn dan 0</translation>
    </message>
    <message>
        <source>must be in 0..{dof}</source>
        <translation>moet binnen 0..{dof} liggen</translation>
    </message>
    <message>
        <source>must be greater than the rod&apos;s radius</source>
        <translation>moet groter zijn dan de straal van de staaf</translation>
    </message>
    <message>
        <source>must be unwinds or runsOn, is &apos;{end}&apos;</source>
        <translation>moet unwinds of runsOn zijn, is &apos;{end}&apos;</translation>
    </message>
    <message>
        <source>must be world or flange, is &apos;{mount}&apos;</source>
        <translation>moet world of flange zijn, is &apos;{mount}&apos;</translation>
    </message>
    <message>
        <source>must be world: a rod is held at both ends</source>
        <translation>moet world zijn: een staaf wordt aan beide uiteinden vastgehouden</translation>
    </message>
    <message>
        <source>must include the home position 0 in its limits</source>
        <translation>moet de uitgangspositie 0 binnen de grenzen hebben</translation>
    </message>
    <message>
        <source>must have three numbers</source>
        <translation>moet drie getallen hebben</translation>
    </message>
    <message>
        <source>must have two names</source>
        <translation>moet twee namen hebben</translation>
    </message>
    <message>
        <source>must have at least two sections</source>
        <translation>moet ten minste twee doorsneden hebben</translation>
    </message>
    <message>
        <source>must have 6 joints, has {found}</source>
        <translation>moet 6 gewrichten hebben, heeft er {found}</translation>
    </message>
    <message>
        <source>must have at least one shape</source>
        <translation>moet ten minste één vorm hebben</translation>
    </message>
    <message>
        <source>must have exactly one axis, which turns the rod</source>
        <translation>moet precies één as hebben, die de staaf draait</translation>
    </message>
    <message>
        <source>must have {wanted} joints, has {found}</source>
        <translation>moet {wanted} gewrichten hebben, heeft er {found}</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>mag niet 0 zijn</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>mag niet negatief zijn</translation>
    </message>
    <message>
        <source>must differ from the nozzle&apos;s: one of them moves, the other is fixed</source>
        <translation>moet verschillen van die van de nozzle: de ene beweegt, de andere staat vast</translation>
    </message>
    <message>
        <source>set its axis (`rodAxis`), or rotate the part onto the rod manually</source>
        <translation>stel de as in (`rodAxis`), of draai het onderdeel handmatig op de staaf</translation>
    </message>
    <message>
        <source>names an unknown body: &apos;{name}&apos;; did you mean &apos;{nearest}&apos;?</source>
        <translation>noemt een onbekend lichaam: &apos;{name}&apos;; bedoelde je &apos;{nearest}&apos;?</translation>
    </message>
    <message>
        <source>names an unknown kinematic family: &apos;{id}&apos;</source>
        <translation>noemt een onbekende kinematische familie: &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>names no model</source>
        <translation>noemt geen model</translation>
    </message>
    <message>
        <source>needs radii that are not negative, one of them greater than 0</source>
        <translation>vereist stralen die niet negatief zijn, waarvan één groter dan 0</translation>
    </message>
    <message>
        <source>neither a plane nor a quadrilateral</source>
        <translation>noch een vlak, noch een vierhoek</translation>
    </message>
    <message numerus="yes">
        <source>no support column from the platform reaches {voxels} voxels that would be missed</source>
        <translation>
            <numerusform>geen steunkolom vanaf het platform bereikt {voxels} voxel die gemist zou worden</numerusform>
            <numerusform>geen steunkolom vanaf het platform bereikt {voxels} voxels die gemist zouden worden</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown figure &apos;{key}&apos;</source>
        <translation>onbekend kengetal &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>no function is defined</source>
        <translation>er is geen functie gedefinieerd</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: their distance is {shortest:.3g} to {longest:.3g} mm</source>
        <translation>geen enkel aantal lagen tussen het oppervlak en het eindvlak houdt de laaghoogte tussen {least} en {most} mm: hun afstand is {shortest:.3g} tot {longest:.3g} mm</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: {layers} layers would be {thinnest:.3g} to {thickest:.3g} mm high</source>
        <translation>geen enkel aantal lagen tussen het oppervlak en het eindvlak houdt de laaghoogte tussen {least} en {most} mm: {layers} lagen zouden {thinnest:.3g} tot {thickest:.3g} mm hoog zijn</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>bestand bestaat niet</translation>
    </message>
    <message>
        <source>no tool-paths left</source>
        <translation>geen gereedschapsbanen over</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominaal</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>not JSON: {why}</source>
        <translation>geen JSON: {why}</translation>
    </message>
    <message>
        <source>not a Voluta job</source>
        <translation>geen Voluta-opdracht</translation>
    </message>
    <message>
        <source>invalid filament diameter</source>
        <translation>ongeldige filamentdiameter</translation>
    </message>
    <message>
        <source>not a mesh file</source>
        <translation>geen meshbestand</translation>
    </message>
    <message>
        <source>invalid module attributes</source>
        <translation>ongeldige module-attributen</translation>
    </message>
    <message>
        <source>not a program in any known format</source>
        <translation>geen programma in een bekend formaat</translation>
    </message>
    <message>
        <source>not a row of the table</source>
        <translation>geen rij van de tabel</translation>
    </message>
    <message>
        <source>not a zip file, or truncated</source>
        <translation>geen zipbestand, of afgekapt</translation>
    </message>
    <message>
        <source>not a valid procedure header</source>
        <translation>geen geldige procedurekop</translation>
    </message>
    <message>
        <source>not the header of a joint table</source>
        <translation>niet de kop van een gewrichtentabel</translation>
    </message>
    <message>
        <source>not understood: &apos;{code}&apos;</source>
        <translation>niet begrepen: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing is left of the mesh after repair</source>
        <translation>na de reparatie blijft er niets van de mesh over</translation>
    </message>
    <message>
        <source>no normal of the surface below the part hits the end surface</source>
        <translation>geen enkele normaal van het oppervlak onder het onderdeel raakt het eindvlak</translation>
    </message>
    <message>
        <source>nothing is on the platform</source>
        <translation>er staat niets op het platform</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>nozzle</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is missing</source>
        <translation>object &apos;{id}&apos; ontbreekt</translation>
    </message>
    <message>
        <source>objects contain each other, or there are too many to read</source>
        <translation>objecten bevatten elkaar, of het zijn er te veel om te lezen</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>offset</translation>
    </message>
    <message>
        <source>on the plate</source>
        <translation>op de plaat</translation>
    </message>
    <message>
        <source>a stop that ends by itself or is skipped</source>
        <translation>een stop die vanzelf eindigt of wordt overgeslagen</translation>
    </message>
    <message>
        <source>a stop that the operator ends</source>
        <translation>een stop die de operator beëindigt</translation>
    </message>
    <message>
        <source>only three-dimensional OFF files can be read</source>
        <translation>alleen driedimensionale OFF-bestanden kunnen worden gelezen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>openen</translation>
    </message>
    <message>
        <source>open it with the version that saved it</source>
        <translation>open het met de versie waarmee het is opgeslagen</translation>
    </message>
    <message>
        <source>ordering layers</source>
        <translation>lagen ordenen</translation>
    </message>
    <message>
        <source>to keep the orientation as given, use `orient=none`</source>
        <translation>gebruik `orient=none` om de opgegeven oriëntatie te behouden</translation>
    </message>
    <message>
        <source>`orient={orient}` is for parts on a plate; mode {mode} places them itself</source>
        <translation>`orient={orient}` is voor onderdelen op een plaat; modus {mode} plaatst ze zelf</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>oriëntatie</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>onvoldoende geheugen</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>buiten bereik</translation>
    </message>
    <message>
        <source>overhang angle</source>
        <translation>overhanghoek</translation>
    </message>
    <message>
        <source>pair {number}</source>
        <translation>paar {number}</translation>
    </message>
    <message>
        <source>pairs a body with itself</source>
        <translation>koppelt een lichaam aan zichzelf</translation>
    </message>
    <message>
        <source>peeling</source>
        <translation>pellen</translation>
    </message>
    <message>
        <source>pick a point on a piece that touches the plate, or place the part on the face to start from</source>
        <translation>kies een punt op een deel dat de plaat raakt, of plaats het onderdeel op het vlak waarmee wordt begonnen</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>delen</translation>
    </message>
    <message>
        <source>some areas are narrower than half a bead and stay empty</source>
        <translation>sommige gebieden zijn smaller dan een halve streng en blijven leeg</translation>
    </message>
    <message>
        <source>placed part</source>
        <translation>geplaatst onderdeel</translation>
    </message>
    <message>
        <source>plan again with more clearance, or place the part elsewhere</source>
        <translation>plan opnieuw met meer vrije afstand, of plaats het onderdeel elders</translation>
    </message>
    <message>
        <source>plan it without --until</source>
        <translation>plan het zonder --until</translation>
    </message>
    <message>
        <source>plan the part again</source>
        <translation>plan het onderdeel opnieuw</translation>
    </message>
    <message>
        <source>plan the part further: voluta-cli plan PART -o DIR</source>
        <translation>plan het onderdeel verder: voluta-cli plan PART -o DIR</translation>
    </message>
    <message>
        <source>layer planes</source>
        <translation>laagvlakken</translation>
    </message>
    <message>
        <source>layer planes miss the part: {planes}</source>
        <translation>laagvlakken missen het onderdeel: {planes}</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>platform</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; has no valid size</source>
        <translation>platform &apos;{platform}&apos; heeft geen geldige grootte</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; is not a plate</source>
        <translation>platform &apos;{platform}&apos; is geen plaat</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; names no file</source>
        <translation>platform &apos;{platform}&apos; noemt geen bestand</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos;: {field} {size} is out of range</source>
        <translation>platform &apos;{platform}&apos;: {field} {size} ligt buiten het toegestane bereik</translation>
    </message>
    <message>
        <source>point {i} is the third one at x = {x:.6g} mm</source>
        <translation>punt {i} is het derde op x = {x:.6g} mm</translation>
    </message>
    <message>
        <source>print the part larger, or with a finer process</source>
        <translation>print het onderdeel groter, of met een fijner proces</translation>
    </message>
    <message>
        <source>print the part smaller (scale)</source>
        <translation>print het onderdeel kleiner (schaal)</translation>
    </message>
    <message>
        <source>printed part</source>
        <translation>geprint onderdeel</translation>
    </message>
    <message>
        <source>rod profile</source>
        <translation>staafprofiel</translation>
    </message>
    <message>
        <source>put - only under the part or beside its lowest row</source>
        <translation>zet - alleen onder het onderdeel of naast de onderste rij ervan</translation>
    </message>
    <message>
        <source>put - directly under the part</source>
        <translation>zet - direct onder het onderdeel</translation>
    </message>
    <message>
        <source>orient it by hand</source>
        <translation>oriënteer het met de hand</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>straal</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>bereikbaar</translation>
    </message>
    <message>
        <source>relative positions are not understood</source>
        <translation>relatieve posities worden niet begrepen</translation>
    </message>
    <message>
        <source>repair</source>
        <translation>reparatie</translation>
    </message>
    <message>
        <source>repair it, or use curved mode, which takes any mesh</source>
        <translation>repareer het, of gebruik modus curved, die elke mesh accepteert</translation>
    </message>
    <message>
        <source>repair the part first</source>
        <translation>repareer eerst het onderdeel</translation>
    </message>
    <message>
        <source>repair: check</source>
        <translation>reparatie: controle</translation>
    </message>
    <message>
        <source>repair: diagnosis</source>
        <translation>reparatie: diagnose</translation>
    </message>
    <message>
        <source>repair: holes</source>
        <translation>reparatie: gaten</translation>
    </message>
    <message>
        <source>repair: orientation</source>
        <translation>reparatie: oriëntatie</translation>
    </message>
    <message>
        <source>repair: self-intersections</source>
        <translation>reparatie: zelfdoorsnijdingen</translation>
    </message>
    <message>
        <source>replaying {format}</source>
        <translation>controlerun van {format}</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>controlerun uitgevoerd</translation>
    </message>
    <message>
        <source>risky area</source>
        <translation>riskante oppervlakte</translation>
    </message>
    <message>
        <source>robot motion</source>
        <translation>robotbeweging</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>staaf</translation>
    </message>
    <message>
        <source>rod, {sizes} mm</source>
        <translation>staaf, {sizes} mm</translation>
    </message>
    <message>
        <source>`rodProfile`: &apos;{text}&apos; is neither a pair x,radius nor a file</source>
        <translation>`rodProfile`: &apos;{text}&apos; is geen paar x,straal en ook geen bestand</translation>
    </message>
    <message>
        <source>root</source>
        <translation>wortel</translation>
    </message>
    <message>
        <source>size of the table of patches</source>
        <translation>grootte van de tabel met patches</translation>
    </message>
    <message>
        <source>size of the table of pieces</source>
        <translation>grootte van de tabel met delen</translation>
    </message>
    <message>
        <source>running the program</source>
        <translation>programma uitvoeren</translation>
    </message>
    <message>
        <source>invalid scale &apos;{scale}&apos;</source>
        <translation>ongeldige schaal &apos;{scale}&apos;</translation>
    </message>
    <message>
        <source>scale fit would scale the platform&apos;s mesh with the part</source>
        <translation>schaal fit zou de mesh van het platform met het onderdeel meeschalen</translation>
    </message>
    <message>
        <source>scale the part down</source>
        <translation>verklein het onderdeel</translation>
    </message>
    <message>
        <source>scale the part down (`--scale fit`), turn it, or use a larger robot</source>
        <translation>verklein het onderdeel (`--scale fit`), draai het, of gebruik een grotere robot</translation>
    </message>
    <message>
        <source>scale the part down, or move it along the rod</source>
        <translation>verklein het onderdeel, of verplaats het langs de staaf</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>methode</translation>
    </message>
    <message>
        <source>see the findings before this one</source>
        <translation>zie de bevindingen vóór deze</translation>
    </message>
    <message>
        <source>see: list formats</source>
        <translation>zie: list formats</translation>
    </message>
    <message numerus="yes">
        <source>separated non-manifold edges at {count} points</source>
        <translation>
            <numerusform>niet-manifold randen bij één punt gescheiden</numerusform>
            <numerusform>niet-manifold randen bij {count} punten gescheiden</numerusform>
        </translation>
    </message>
    <message>
        <source>set {variable}</source>
        <translation>stel {variable} in</translation>
    </message>
    <message>
        <source>set_tcp needs a pose</source>
        <translation>set_tcp vereist een pose</translation>
    </message>
    <message>
        <source>layer shape</source>
        <translation>laagvorm</translation>
    </message>
    <message>
        <source>use shorter motions or smaller blends</source>
        <translation>gebruik kortere bewegingen of kleinere afrondingen</translation>
    </message>
    <message>
        <source>rod sides</source>
        <translation>zijden van de staaf</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>skelet</translation>
    </message>
    <message>
        <source>sleep needs a time in seconds</source>
        <translation>sleep vereist een tijd in seconden</translation>
    </message>
    <message>
        <source>slice {slice} ends after {rows} rows, the first one after {first}</source>
        <translation>snede {slice} eindigt na {rows} rijen, de eerste na {first}</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>slicen</translation>
    </message>
    <message>
        <source>print slower there, or place the part elsewhere in the cell</source>
        <translation>print daar langzamer, of plaats het onderdeel elders in de cel</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>bol</translation>
    </message>
    <message numerus="yes">
        <source>split edges at {count} T-junctions</source>
        <translation>
            <numerusform>randen bij één T-splitsing gesplitst</numerusform>
            <numerusform>randen bij {count} T-splitsingen gesplitst</numerusform>
        </translation>
    </message>
    <message>
        <source>stated</source>
        <translation>opgegeven</translation>
    </message>
    <message>
        <source>step</source>
        <translation>stap</translation>
    </message>
    <message>
        <source>step height</source>
        <translation>traphoogte</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>ondersteuning</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>oppervlak</translation>
    </message>
    <message>
        <source>choose a cell with a rod: `--cell lathe`</source>
        <translation>kies een cel met een staaf: `--cell lathe`</translation>
    </message>
    <message>
        <source>choose a shorter rod</source>
        <translation>kies een kortere staaf</translation>
    </message>
    <message>
        <source>choose a thinner rod</source>
        <translation>kies een dunnere staaf</translation>
    </message>
    <message>
        <source>subtract the rod from the part</source>
        <translation>trek de staaf van het onderdeel af</translation>
    </message>
    <message>
        <source>subtract the surface from the part</source>
        <translation>trek het oppervlak van het onderdeel af</translation>
    </message>
    <message>
        <source>use {formats}</source>
        <translation>gebruik {formats}</translation>
    </message>
    <message>
        <source>text after ENDMODULE</source>
        <translation>tekst na ENDMODULE</translation>
    </message>
    <message>
        <source>text after the end</source>
        <translation>tekst na het einde</translation>
    </message>
    <message>
        <source>the arm cannot reach this target</source>
        <translation>de arm kan dit doel niet bereiken</translation>
    </message>
    <message>
        <source>the arm&apos;s configuration is not the planned one: a joint differs by {angle:.1f}</source>
        <translation>de configuratie van de arm is niet de geplande: een gewricht wijkt {angle:.1f} af</translation>
    </message>
    <message>
        <source>the arm would have to change its configuration: {joint} would jump by {angle:.1f}</source>
        <translation>de arm zou van configuratie moeten wisselen: {joint} zou {angle:.1f} verspringen</translation>
    </message>
    <message>
        <source>configuration supervision is on: ConfL\Off, ConfJ\Off</source>
        <translation>configuratiebewaking staat aan: ConfL\Off, ConfJ\Off</translation>
    </message>
    <message>
        <source>the end sequence (M104 S0, M84, &apos;; end&apos;) is missing: the file is truncated</source>
        <translation>de eindreeks (M104 S0, M84, &apos;; end&apos;) ontbreekt: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>the end sequence is missing</source>
        <translation>de eindreeks ontbreekt</translation>
    </message>
    <message>
        <source>the end surface is {rise:.3g} mm above the top of the starting surface</source>
        <translation>het eindvlak ligt {rise:.3g} mm boven de top van het beginvlak</translation>
    </message>
    <message>
        <source>external axis {angle:.3f} off its planned position</source>
        <translation>externe as {angle:.3f} naast de geplande positie</translation>
    </message>
    <message>
        <source>the extruder is not switched off after the last motion</source>
        <translation>de extruder wordt na de laatste beweging niet uitgeschakeld</translation>
    </message>
    <message>
        <source>the extruder is off during a bead</source>
        <translation>de extruder is uit tijdens een streng</translation>
    </message>
    <message>
        <source>the extruder is on during a travel</source>
        <translation>de extruder is aan tijdens een verplaatsing</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not set before this motion</source>
        <translation>de uitgangen van de extruder zijn vóór deze beweging niet ingesteld</translation>
    </message>
    <message>
        <source>the feature is {width:.3g} mm wide, wider than its cylinder of {cylinder:.3g} mm</source>
        <translation>het vormelement is {width:.3g} mm breed, breder dan zijn cilinder van {cylinder:.3g} mm</translation>
    </message>
    <message>
        <source>the file ends without &quot;endsolid&quot;: it may be truncated</source>
        <translation>het bestand eindigt zonder &quot;endsolid&quot;: het is mogelijk afgekapt</translation>
    </message>
    <message>
        <source>the file contains no cells</source>
        <translation>het bestand bevat geen cellen</translation>
    </message>
    <message>
        <source>the file is truncated: {what}</source>
        <translation>het bestand is afgekapt: {what}</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>het bestand is leeg</translation>
    </message>
    <message>
        <source>the file&apos;s top {what}</source>
        <translation>het bovenste niveau van het bestand {what}</translation>
    </message>
    <message>
        <source>the first module has no procedure main</source>
        <translation>de eerste module heeft geen procedure main</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; has no end</source>
        <translation>de functie &apos;{defined}&apos; heeft geen einde</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is never called</source>
        <translation>de functie &apos;{defined}&apos; wordt nooit aangeroepen</translation>
    </message>
    <message>
        <source>the function is never called</source>
        <translation>de functie wordt nooit aangeroepen</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>de kop heeft geen einde</translation>
    </message>
    <message>
        <source>the header line is missing</source>
        <translation>de kopregel ontbreekt</translation>
    </message>
    <message>
        <source>the header states no format</source>
        <translation>de kop vermeldt geen formaat</translation>
    </message>
    <message>
        <source>the header states no facets; {facets} read</source>
        <translation>de kop vermeldt geen facetten; {facets} gelezen</translation>
    </message>
    <message>
        <source>the job file is inconsistent</source>
        <translation>het opdrachtbestand is inconsistent</translation>
    </message>
    <message>
        <source>the job file is inconsistent: {what}</source>
        <translation>het opdrachtbestand is inconsistent: {what}</translation>
    </message>
    <message>
        <source>the job file is truncated</source>
        <translation>het opdrachtbestand is afgekapt</translation>
    </message>
    <message>
        <source>the first line of the job file is damaged or truncated</source>
        <translation>de eerste regel van het opdrachtbestand is beschadigd of afgekapt</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; is missing in the job file</source>
        <translation>blok &apos;{name}&apos; ontbreekt in het opdrachtbestand</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged</source>
        <translation>de kop van het opdrachtbestand is beschadigd</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged: {why}</source>
        <translation>de kop van het opdrachtbestand is beschadigd: {why}</translation>
    </message>
    <message>
        <source>the job has no motion to verify against</source>
        <translation>de opdracht heeft geen beweging om mee te vergelijken</translation>
    </message>
    <message>
        <source>the job contains no {result}</source>
        <translation>de opdracht bevat geen {result}</translation>
    </message>
    <message>
        <source>the letter {letter} has no number</source>
        <translation>de letter {letter} heeft geen getal</translation>
    </message>
    <message>
        <source>the line &apos;# end&apos; is missing: the file is truncated</source>
        <translation>de regel &apos;# end&apos; ontbreekt: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>the list of modules has no end</source>
        <translation>de lijst met modules heeft geen einde</translation>
    </message>
    <message>
        <source>deposited volume: {share:.2f} of the part&apos;s</source>
        <translation>gelegd volume: {share:.2f} van dat van het onderdeel</translation>
    </message>
    <message>
        <source>mechanical unit &apos;{text}&apos; is not active: ActUnit</source>
        <translation>mechanische eenheid &apos;{text}&apos; is niet actief: ActUnit</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>de mesh heeft geen driehoeken</translation>
    </message>
    <message>
        <source>the mesh is empty: no facet has valid coordinates</source>
        <translation>de mesh is leeg: geen enkel facet heeft geldige coördinaten</translation>
    </message>
    <message>
        <source>the mesh is empty: the file has no triangles</source>
        <translation>de mesh is leeg: het bestand heeft geen driehoeken</translation>
    </message>
    <message>
        <source>the mesh is not closed</source>
        <translation>de mesh is niet gesloten</translation>
    </message>
    <message>
        <source>the module has no procedure</source>
        <translation>de module heeft geen procedure</translation>
    </message>
    <message>
        <source>the module with {procedure} is missing</source>
        <translation>de module met {procedure} ontbreekt</translation>
    </message>
    <message>
        <source>module {name} is missing</source>
        <translation>module {name} ontbreekt</translation>
    </message>
    <message>
        <source>the normal has zero length</source>
        <translation>de normaal heeft lengte nul</translation>
    </message>
    <message>
        <source>nozzle {distance:.3f} off the planned path</source>
        <translation>nozzle {distance:.3f} naast de geplande baan</translation>
    </message>
    <message>
        <source>nozzle axis {angle:.2f} off the planned direction</source>
        <translation>as van de nozzle wijkt {angle:.2f} af van de geplande richting</translation>
    </message>
    <message>
        <source>the numbers of vertices and faces are expected here</source>
        <translation>hier worden de aantallen hoekpunten en vlakken verwacht</translation>
    </message>
    <message>
        <source>no part: no 1 above the platform</source>
        <translation>geen onderdeel: geen 1 boven het platform</translation>
    </message>
    <message>
        <source>the object is too large</source>
        <translation>het object is te groot</translation>
    </message>
    <message>
        <source>the part below</source>
        <translation>het onderliggende onderdeel</translation>
    </message>
    <message>
        <source>the part does not touch the plate</source>
        <translation>het onderdeel raakt de plaat niet</translation>
    </message>
    <message>
        <source>the part does not touch the platform</source>
        <translation>het onderdeel raakt het platform niet</translation>
    </message>
    <message>
        <source>the part has no clear axis: its surface normals have no preferred direction</source>
        <translation>het onderdeel heeft geen duidelijke as: de oppervlaktenormalen hebben geen voorkeursrichting</translation>
    </message>
    <message>
        <source>the part has no surface</source>
        <translation>het onderdeel heeft geen oppervlak</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the rod is subtracted</source>
        <translation>het onderdeel is niet gesloten of doorsnijdt zichzelf waar de staaf wordt afgetrokken</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the surface&apos;s body is subtracted</source>
        <translation>het onderdeel is niet gesloten of doorsnijdt zichzelf waar het lichaam van het oppervlak wordt afgetrokken</translation>
    </message>
    <message>
        <source>the part is too large for a collision grid of this resolution</source>
        <translation>het onderdeel is te groot voor een botsingsraster met deze resolutie</translation>
    </message>
    <message numerus="yes">
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxels ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>
            <numerusform>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): {missed} gemiste voxel ({voxel:.2f} breed) in plaats van {missedBefore}, overhang {overhang:.0f} in plaats van {overhangBefore:.0f#}</numerusform>
            <numerusform>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): {missed} gemiste voxels ({voxel:.2f} breed) in plaats van {missedBefore}, overhang {overhang:.0f} in plaats van {overhangBefore:.0f#}</numerusform>
        </translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): estimated overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): geschatte overhang na het snijden {left:.0f} (delen: {pieces}) in plaats van {leftBefore:.0f#} (delen: {piecesBefore}); ongesneden {overhang:.0f} in plaats van {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): overhang {overhang:.0f} in plaats van {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): residual area on XY {xy:.0f} instead of {xyBefore:.0f#}, on XZ {xz:.0f} instead of {xzBefore:.0f#}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): restoppervlakte op XY {xy:.0f} in plaats van {xyBefore:.0f#}, op XZ {xz:.0f} in plaats van {xzBefore:.0f#}, overhang {overhang:.0f} in plaats van {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part is {width:.3g} mm wide, at least as wide as the cylinder below it</source>
        <translation>het onderdeel is {width:.3g} mm breed, minstens zo breed als de cilinder eronder</translation>
    </message>
    <message>
        <source>the part misses the rod: no layer of it rests on the rod</source>
        <translation>het onderdeel mist de staaf: geen enkele laag ervan rust op de staaf</translation>
    </message>
    <message>
        <source>the part misses the surface: no layer of it rests on the surface</source>
        <translation>het onderdeel mist het oppervlak: geen enkele laag ervan rust op het oppervlak</translation>
    </message>
    <message>
        <source>the part reaches below the platform</source>
        <translation>het onderdeel reikt tot onder het platform</translation>
    </message>
    <message>
        <source>the part extends from x = {from:.4g} to {to:.4g} mm, beyond an end of the rod at {firstEnd:.4g} or {lastEnd:.4g} mm</source>
        <translation>het onderdeel loopt van x = {from:.4g} tot {to:.4g} mm, voorbij een uiteinde van de staaf bij {firstEnd:.4g} of {lastEnd:.4g} mm</translation>
    </message>
    <message>
        <source>the part extends {height:.3g} mm beyond the rod, less than a layer of {least:.3g} mm</source>
        <translation>het onderdeel steekt {height:.3g} mm buiten de staaf uit, minder dan een laag van {least:.3g} mm</translation>
    </message>
    <message>
        <source>the part extends to {reach:.4g} from the rod&apos;s axis; the cell prints up to {limit}</source>
        <translation>het onderdeel reikt tot {reach:.4g} vanaf de as van de staaf; de cel print tot {limit}</translation>
    </message>
    <message>
        <source>the part rises {height:.3g} mm above the surface, less than a layer of {least:.3g} mm</source>
        <translation>het onderdeel steekt {height:.3g} mm boven het oppervlak uit, minder dan een laag van {least:.3g} mm</translation>
    </message>
    <message>
        <source>an end surface radius:R requires a cylinder along x below the part</source>
        <translation>een eindvlak radius:R vereist een cilinder langs x onder het onderdeel</translation>
    </message>
    <message numerus="yes">
        <source>the part keeps its orientation: none of {ways} stable ones is better</source>
        <translation>
            <numerusform>het onderdeel behoudt zijn oriëntatie: de enige stabiele is niet beter</numerusform>
            <numerusform>het onderdeel behoudt zijn oriëntatie: geen van de {ways} stabiele is beter</numerusform>
        </translation>
    </message>
    <message>
        <source>the placement is not a rotation and a position in mm</source>
        <translation>de plaatsing is geen rotatie en een positie in mm</translation>
    </message>
    <message>
        <source>the plane misses the part</source>
        <translation>het vlak mist het onderdeel</translation>
    </message>
    <message>
        <source>the planes are not a JSON list</source>
        <translation>de vlakken zijn geen JSON-lijst</translation>
    </message>
    <message>
        <source>the platform</source>
        <translation>het platform</translation>
    </message>
    <message>
        <source>the platform&apos;s mesh is not closed</source>
        <translation>de mesh van het platform is niet gesloten</translation>
    </message>
    <message>
        <source>the points are collinear</source>
        <translation>de punten liggen op één lijn</translation>
    </message>
    <message>
        <source>the print head would cut into printed material, however it is tilted</source>
        <translation>de printkop zou in geprint materiaal snijden, hoe hij ook wordt gekanteld</translation>
    </message>
    <message>
        <source>the procedure has no ENDPROC</source>
        <translation>de procedure heeft geen ENDPROC</translation>
    </message>
    <message numerus="yes">
        <source>the program ends here; {motions} planned motions are missing</source>
        <translation>
            <numerusform>het programma eindigt hier; één geplande beweging ontbreekt</numerusform>
            <numerusform>het programma eindigt hier; {motions} geplande bewegingen ontbreken</numerusform>
        </translation>
    </message>
    <message>
        <source>the program has no motions</source>
        <translation>het programma heeft geen bewegingen</translation>
    </message>
    <message>
        <source>the program runs from 0 to {end:.1f}</source>
        <translation>het programma loopt van 0 tot {end:.1f}</translation>
    </message>
    <message>
        <source>the program&apos;s data folder is missing</source>
        <translation>de gegevensmap van het programma ontbreekt</translation>
    </message>
    <message>
        <source>the program&apos;s motions do not match this plan</source>
        <translation>de bewegingen van het programma komen niet overeen met dit plan</translation>
    </message>
    <message>
        <source>the quadrilateral has no area</source>
        <translation>de vierhoek heeft geen oppervlakte</translation>
    </message>
    <message>
        <source>the quadrilateral is not convex</source>
        <translation>de vierhoek is niet convex</translation>
    </message>
    <message>
        <source>the quadrilateral is not flat</source>
        <translation>de vierhoek is niet vlak</translation>
    </message>
    <message>
        <source>the radius at point {i} is not positive</source>
        <translation>de straal bij punt {i} is niet positief</translation>
    </message>
    <message>
        <source>not a plan&apos;s report: {why}</source>
        <translation>geen rapport van een plan: {why}</translation>
    </message>
    <message>
        <source>the robot motion is empty</source>
        <translation>de robotbeweging is leeg</translation>
    </message>
    <message>
        <source>the rod is thicker than the part and contains all of it</source>
        <translation>de staaf is dikker dan het onderdeel en bevat het helemaal</translation>
    </message>
    <message>
        <source>the rod extends {reach} mm from its middle; the cell has room for {room} mm</source>
        <translation>de staaf reikt {reach} mm vanaf het midden; de cel heeft ruimte voor {room} mm</translation>
    </message>
    <message>
        <source>the rod&apos;s radius is {radius} mm; the cell prints up to {most} mm</source>
        <translation>de straal van de staaf is {radius} mm; de cel print tot {most} mm</translation>
    </message>
    <message>
        <source>the root at {x:.1f}, {y:.1f}, {z:.1f} mm is not on the plate</source>
        <translation>de wortel bij {x:.1f}, {y:.1f}, {z:.1f} mm ligt niet op de plaat</translation>
    </message>
    <message>
        <source>the row has {cells} cells, the first one {first}</source>
        <translation>de rij heeft {cells} cellen, de eerste {first}</translation>
    </message>
    <message>
        <source>the body of the surface contains the whole part</source>
        <translation>het lichaam van het oppervlak bevat het hele onderdeel</translation>
    </message>
    <message>
        <source>the voxel object is lifted by a fraction of a voxel: it is cut into new voxels</source>
        <translation>het voxelobject is een fractie van een voxel opgetild: het wordt in nieuwe voxels verdeeld</translation>
    </message>
    <message>
        <source>the voxel object is not rotated by a multiple of 90°: it is cut into new voxels</source>
        <translation>het voxelobject is niet over een veelvoud van 90° gedraaid: het wordt in nieuwe voxels verdeeld</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>de voxels zijn te klein voor een onderdeel van deze grootte</translation>
    </message>
    <message>
        <source>the {format} program is not released: {failed}</source>
        <translation>het {format}-programma is niet vrijgegeven: {failed}</translation>
    </message>
    <message>
        <source>there is no layer {layer}</source>
        <translation>laag {layer} bestaat niet</translation>
    </message>
    <message>
        <source>no module</source>
        <translation>geen module</translation>
    </message>
    <message>
        <source>there is no platform: no - in any row</source>
        <translation>er is geen platform: geen - in enige rij</translation>
    </message>
    <message>
        <source>there is no time {time}</source>
        <translation>tijd {time} bestaat niet</translation>
    </message>
    <message>
        <source>thicken the wall to {least} or more</source>
        <translation>maak de wand {least} dik of dikker</translation>
    </message>
    <message>
        <source>thickness classes</source>
        <translation>dikteklassen</translation>
    </message>
    <message>
        <source>OpenGL 3.2 without a display is not available: {why}</source>
        <translation>OpenGL 3.2 zonder beeldscherm is niet beschikbaar: {why}</translation>
    </message>
    <message>
        <source>this is not the module that main runs next</source>
        <translation>dit is niet de module die main als volgende uitvoert</translation>
    </message>
    <message>
        <source>this motion and the one at {other} are swapped</source>
        <translation>deze beweging en die op {other} zijn verwisseld</translation>
    </message>
    <message>
        <source>this motion deposits {volume:.3f} instead of {planned:.3f}</source>
        <translation>deze beweging legt {volume:.3f} in plaats van {planned:.3f}</translation>
    </message>
    <message>
        <source>this motion takes {time:.3f} instead of {planned:.3f}</source>
        <translation>deze beweging duurt {time:.3f} in plaats van {planned:.3f}</translation>
    </message>
    <message>
        <source>time decreases</source>
        <translation>tijd neemt af</translation>
    </message>
    <message>
        <source>too many triangles for an STL file</source>
        <translation>te veel driehoeken voor een STL-bestand</translation>
    </message>
    <message>
        <source>tool-paths</source>
        <translation>gereedschapsbanen</translation>
    </message>
    <message>
        <source>touch points farther apart around the cylinder</source>
        <translation>tast punten verder uit elkaar rondom de cilinder aan</translation>
    </message>
    <message>
        <source>touched points</source>
        <translation>aangeraakte punten</translation>
    </message>
    <message>
        <source>trimming layers on the part</source>
        <translation>lagen op het onderdeel bijsnijden</translation>
    </message>
    <message>
        <source>try a larger `voxelMm` or a smaller part</source>
        <translation>probeer een grotere `voxelMm` of een kleiner onderdeel</translation>
    </message>
    <message>
        <source>to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels</source>
        <translation>om de voxels te behouden: draai het over veelvouden van 90° en til het hele voxels op</translation>
    </message>
    <message>
        <source>infill rotation per layer</source>
        <translation>draaiing van de vulling per laag</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), add supports, or use planar or curved mode</source>
        <translation>draai het onderdeel (`orient=leastRisky`), voeg ondersteuning toe, of gebruik modus planar of curved</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), or use planar or curved mode</source>
        <translation>draai het onderdeel (`orient=leastRisky`), of gebruik modus planar of curved</translation>
    </message>
    <message>
        <source>turn the part about the vertical, or try more rotations (`redundancySamples`)</source>
        <translation>draai het onderdeel om de verticaal, of probeer meer rotaties (`redundancySamples`)</translation>
    </message>
    <message>
        <source>turn the part, enlarge the platform or add supports</source>
        <translation>draai het onderdeel, vergroot het platform of voeg ondersteuning toe</translation>
    </message>
    <message>
        <source>turn the part, make the platform smaller or add supports</source>
        <translation>draai het onderdeel, maak het platform kleiner of voeg ondersteuning toe</translation>
    </message>
    <message>
        <source>turn the part, or allow less clearance</source>
        <translation>draai het onderdeel, of sta minder vrije afstand toe</translation>
    </message>
    <message>
        <source>turn the part, use a smaller platform, or allow less clearance</source>
        <translation>draai het onderdeel, gebruik een kleiner platform, of sta minder vrije afstand toe</translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} inside-out components</source>
        <translation>
            <numerusform>één binnenstebuiten gekeerde component omgekeerd</numerusform>
            <numerusform>{count} binnenstebuiten gekeerde componenten omgekeerd</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} triangles to match their neighbours</source>
        <translation>
            <numerusform>één driehoek omgekeerd zodat die bij zijn buren past</numerusform>
            <numerusform>{count} driehoeken omgekeerd zodat ze bij hun buren passen</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part: other orientations may need fewer</source>
        <translation>draai het onderdeel: andere oriëntaties hebben er mogelijk minder nodig</translation>
    </message>
    <message>
        <source>rotations tried per point</source>
        <translation>geprobeerde rotaties per punt</translation>
    </message>
    <message>
        <source>two commands in one line</source>
        <translation>twee commando&apos;s in één regel</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} overlapping components</source>
        <translation>
            <numerusform>één overlappende component samengevoegd</numerusform>
            <numerusform>{count} overlappende componenten samengevoegd</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown cell &apos;{id}&apos;</source>
        <translation>onbekende cel &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown cell &apos;{name}&apos;</source>
        <translation>onbekende cel &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown colour &apos;{name}&apos;</source>
        <translation>onbekende kleur &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown failure</source>
        <translation>onbekende fout</translation>
    </message>
    <message>
        <source>unknown format &apos;{id}&apos;</source>
        <translation>onbekend formaat &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown format &apos;{name}&apos;</source>
        <translation>onbekend formaat &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown growth &apos;{name}&apos;</source>
        <translation>onbekende groei &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown infill &apos;{id}&apos;</source>
        <translation>onbekende vulling &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown key &apos;{key}&apos;</source>
        <translation>onbekende sleutel &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>unknown mode &apos;{name}&apos;</source>
        <translation>onbekende modus &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown parameter &apos;{key}&apos;</source>
        <translation>onbekende parameter &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>unknown picture &apos;{name}&apos;</source>
        <translation>onbekende afbeelding &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown platform &apos;{name}&apos;</source>
        <translation>onbekend platform &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown process &apos;{id}&apos;</source>
        <translation>onbekend proces &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown process &apos;{name}&apos;</source>
        <translation>onbekend proces &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown robot &apos;{id}&apos;</source>
        <translation>onbekende robot &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown sample &apos;{name}&apos;</source>
        <translation>onbekend voorbeeld &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown stage &apos;{name}&apos;</source>
        <translation>onbekende fase &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown view &apos;{name}&apos;</source>
        <translation>onbekende weergave &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print the part larger</source>
        <translation>gebruik een fijnere nozzle, of print het onderdeel groter</translation>
    </message>
    <message>
        <source>use a larger platform (fit:MARGIN), or turn the part</source>
        <translation>gebruik een groter platform (fit:MARGIN), of draai het onderdeel</translation>
    </message>
    <message>
        <source>use a slimmer print head, turn the part, or print it larger</source>
        <translation>gebruik een slankere printkop, draai het onderdeel, of print het groter</translation>
    </message>
    <message>
        <source>use a slimmer print head or thinner layers</source>
        <translation>gebruik een slankere printkop of dunnere lagen</translation>
    </message>
    <message>
        <source>use a smaller platform or place the part higher</source>
        <translation>gebruik een kleiner platform of plaats het onderdeel hoger</translation>
    </message>
    <message>
        <source>use a thinner rod, or print the part larger</source>
        <translation>gebruik een dunnere staaf, of print het onderdeel groter</translation>
    </message>
    <message>
        <source>use at least {least}</source>
        <translation>gebruik ten minste {least}</translation>
    </message>
    <message>
        <source>use at most {side} cells a side and {millions} million in all</source>
        <translation>gebruik hoogstens {side} cellen per zijde en in totaal {millions} miljoen</translation>
    </message>
    <message>
        <source>use infill zigzag or concentric, or mode lathe</source>
        <translation>gebruik vulling zigzag of concentric, of modus lathe</translation>
    </message>
    <message>
        <source>use lower layers or a finer nozzle, or print the part larger</source>
        <translation>gebruik lagere lagen of een fijnere nozzle, of print het onderdeel groter</translation>
    </message>
    <message>
        <source>voxelise</source>
        <translation>voxeliseren</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>voxels</translation>
    </message>
    <message>
        <source>voxels of {width} need about {needed} of memory; {available} are free</source>
        <translation>voxels van {width} vereisen ongeveer {needed} geheugen; {available} is vrij</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>wanden</translation>
    </message>
    <message>
        <source>UnLoad of a module that was not loaded and run</source>
        <translation>UnLoad van een module die niet is geladen en uitgevoerd</translation>
    </message>
    <message>
        <source>winding angle</source>
        <translation>wikkelhoek</translation>
    </message>
    <message>
        <source>woven</source>
        <translation>geweven</translation>
    </message>
    <message>
        <source>write 1 for the part, 0 for air, - for the platform</source>
        <translation>schrijf 1 voor het onderdeel, 0 voor lucht, - voor het platform</translation>
    </message>
    <message>
        <source>write 1 where the part is</source>
        <translation>schrijf 1 waar het onderdeel is</translation>
    </message>
    <message>
        <source>write files</source>
        <translation>bestanden schrijven</translation>
    </message>
    <message>
        <source>write flat, flat:Z, radius:R or mesh:FILE, in mm</source>
        <translation>schrijf flat, flat:Z, radius:R of mesh:FILE, in mm</translation>
    </message>
    <message>
        <source>write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm</source>
        <translation>schrijf paren zoals -20,2.5 0,2.5 0,3.5 20,3.5 in mm</translation>
    </message>
    <message>
        <source>write refused programs</source>
        <translation>geweigerde programma&apos;s schrijven</translation>
    </message>
    <message>
        <source>write rows of 0 and 1, and - for the platform</source>
        <translation>schrijf rijen van 0 en 1, en - voor het platform</translation>
    </message>
    <message>
        <source>write the program again; to keep this change, make it in the plan</source>
        <translation>schrijf het programma opnieuw; maak deze wijziging in het plan om ze te behouden</translation>
    </message>
    <message>
        <source>write intermediate results</source>
        <translation>tussenresultaten schrijven</translation>
    </message>
    <message>
        <source>write x,y,z in mm</source>
        <translation>schrijf x,y,z in mm</translation>
    </message>
    <message>
        <source>write x,y,z in mm, such as 10,0,5</source>
        <translation>schrijf x,y,z in mm, zoals 10,0,5</translation>
    </message>
    <message>
        <source>writing {format}</source>
        <translation>{format} schrijven</translation>
    </message>
    <message>
        <source>write {form}</source>
        <translation>schrijf {form}</translation>
    </message>
    <message>
        <source>write {form}, in mm</source>
        <translation>schrijf {form}, in mm</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x decreases at point {i}</source>
        <translation>x neemt af bij punt {i}</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>zigzag</source>
        <translation>zigzag</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle}</source>
        <translation>{area:.3g} hangt meer dan {angle} over</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at x = {x:.4g}, radius {radius:.4g}</source>
        <translation>{area:.3g} hangt meer dan {angle:.3g} over lagere lagen heen, het meest bij x = {x:.4g}, straal {radius:.4g}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at {at:.4g}</source>
        <translation>{area:.3g} hangt meer dan {angle:.3g} over lagere lagen heen, het meest bij {at:.4g}</translation>
    </message>
    <message numerus="yes">
        <source>{bad} of {facets} facets have NaN or out-of-range coordinates, first at facet {first}</source>
        <translation>
            <numerusform>{bad} van {facets} facetten heeft NaN of coördinaten buiten het bereik: facet {first}</numerusform>
            <numerusform>{bad} van {facets} facetten hebben NaN of coördinaten buiten het bereik, het eerste is facet {first}</numerusform>
        </translation>
    </message>
    <message>
        <source>blocked pieces: {blocked} of {pieces}; earlier pieces are in the print head&apos;s way</source>
        <translation>geblokkeerde delen: {blocked} van {pieces}; eerdere delen staan de printkop in de weg</translation>
    </message>
    <message numerus="yes">
        <source>{columns} more support columns under voxels that would be missed</source>
        <translation>
            <numerusform>nog één steunkolom onder voxels die gemist zouden worden</numerusform>
            <numerusform>nog {columns} steunkolommen onder voxels die gemist zouden worden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} inside-out components, the first at {first:.2f}</source>
        <translation>
            <numerusform>één binnenstebuiten gekeerde component, bij {first:.2f}</numerusform>
            <numerusform>{count} binnenstebuiten gekeerde componenten, de eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} duplicate triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>één dubbele driehoek, bij {first:.2f}</numerusform>
            <numerusform>{count} dubbele driehoeken, de eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with inconsistently oriented triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>één rand met inconsistent georiënteerde driehoeken, bij {first:.2f}</numerusform>
            <numerusform>{count} randen met inconsistent georiënteerde driehoeken, de eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with more than two triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>één rand met meer dan twee driehoeken, bij {first:.2f}</numerusform>
            <numerusform>{count} randen met meer dan twee driehoeken, de eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} open edges in {loops} loops, the first at {first:.2f}</source>
        <translation>
            <numerusform>één open rand in {loops} lus, bij {first:.2f}</numerusform>
            <numerusform>{count} open randen in {loops} lussen, de eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} pairs of intersecting triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>één paar snijdende driehoeken, bij {first:.2f}</numerusform>
            <numerusform>{count} paren snijdende driehoeken, het eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} triangles without area, the first at {first:.2f}</source>
        <translation>
            <numerusform>één driehoek zonder oppervlakte, bij {first:.2f}</numerusform>
            <numerusform>{count} driehoeken zonder oppervlakte, de eerste bij {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} voxels</source>
        <translation>
            <numerusform>{count} voxel</numerusform>
            <numerusform>{count} voxels</numerusform>
        </translation>
    </message>
    <message>
        <source>{file}, byte {byte}</source>
        <translation>{file}, byte {byte}</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, regel {line}</translation>
    </message>
    <message>
        <source>{file}, line {line}, column {column}</source>
        <translation>{file}, regel {line}, kolom {column}</translation>
    </message>
    <message>
        <source>{first} and {second} collide</source>
        <translation>{first} en {second} botsen</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the finished motion</source>
        <translation>{first} botst met {second} in de voltooide beweging</translation>
    </message>
    <message>
        <source>{found} is none of 0, 1 and -</source>
        <translation>{found} is geen 0, 1 of -</translation>
    </message>
    <message>
        <source>{joint} at {angle:.1f}, beyond its limit of {limit:.1f#}</source>
        <translation>{joint} op {angle:.1f}, voorbij de grens van {limit:.1f#}</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}, above its limit of {limit:.1f#}</source>
        <translation>{joint} met {speed:.1f}, boven de grens van {limit:.1f#}</translation>
    </message>
    <message>
        <source>not covered by layers: {left:.3g#} of {whole:.4g} of the part</source>
        <translation>niet door lagen bedekt: {left:.3g#} van {whole:.4g} van het onderdeel</translation>
    </message>
    <message numerus="yes">
        <source>{motions} motions from here on are not in the plan</source>
        <translation>
            <numerusform>één beweging vanaf hier staat niet in het plan</numerusform>
            <numerusform>{motions} bewegingen vanaf hier staan niet in het plan</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing before this one</source>
        <translation>
            <numerusform>vóór deze beweging ontbreekt één geplande beweging</numerusform>
            <numerusform>vóór deze beweging ontbreken {motions} geplande bewegingen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing between {before} and this one</source>
        <translation>
            <numerusform>tussen {before} en deze ontbreekt één geplande beweging</numerusform>
            <numerusform>tussen {before} en deze ontbreken {motions} geplande bewegingen</numerusform>
        </translation>
    </message>
    <message>
        <source>{option}: a value is not finite</source>
        <translation>{option}: een waarde is niet eindig</translation>
    </message>
    <message>
        <source>{option}: {wanted} numbers expected, {given} given</source>
        <translation>{option}: {wanted} getallen verwacht, {given} opgegeven</translation>
    </message>
    <message>
        <source>{outside:.2f} of the part&apos;s volume is deposited outside it, {noRoom:.2f} does not fit</source>
        <translation>{outside:.2f} van het volume van het onderdeel wordt erbuiten gelegd, {noRoom:.2f} past niet</translation>
    </message>
    <message numerus="yes">
        <source>{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is below them</source>
        <translation>
            <numerusform>één vlek ({area:.1f}) begint in de lucht: noch de plaat, noch een eerdere laag ligt eronder</numerusform>
            <numerusform>{patches} vlekken ({area:.1f}) beginnen in de lucht: noch de plaat, noch een eerdere laag ligt eronder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out: too small for a bead, or they would begin in the air ({volume:.1f} in all, the largest {largest:.1f})</source>
        <translation>
            <numerusform>één laagdeel wordt weggelaten: te klein voor een streng, of het zou in de lucht beginnen ({volume:.1f} in totaal, het grootste {largest:.1f})</numerusform>
            <numerusform>{pieces} laagdelen worden weggelaten: te klein voor een streng, of ze zouden in de lucht beginnen ({volume:.1f} in totaal, het grootste {largest:.1f})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or they would begin in the air</source>
        <translation>
            <numerusform>één laagdeel wordt weggelaten, {volume:.3g} van {whole:.3g#}: te klein voor een streng, of het zou in de lucht beginnen</numerusform>
            <numerusform>{pieces} laagdelen worden weggelaten, {volume:.3g} van {whole:.3g#}: te klein voor een streng, of ze zouden in de lucht beginnen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the rod nor an earlier layer</source>
        <translation>
            <numerusform>één laagdeel begint in de lucht, niet boven de staaf of een eerdere laag</numerusform>
            <numerusform>{pieces} laagdelen beginnen in de lucht, niet boven de staaf of een eerdere laag</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the surface nor an earlier layer</source>
        <translation>
            <numerusform>één laagdeel begint in de lucht, niet boven het oppervlak of een eerdere laag</numerusform>
            <numerusform>{pieces} laagdelen beginnen in de lucht, niet boven het oppervlak of een eerdere laag</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air</source>
        <translation>
            <numerusform>één laagdeel begint in de lucht</numerusform>
            <numerusform>{pieces} laagdelen beginnen in de lucht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} places where the program differs from the plan</source>
        <translation>
            <numerusform>één plaats waar het programma van het plan afwijkt</numerusform>
            <numerusform>{places} plaatsen waar het programma van het plan afwijkt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the thinnest is {thinnest:.2f} thick</source>
        <translation>
            <numerusform>nog één kleinere plaats is dunner dan een voxel van {voxel}; dit is de grootste, de dunste is {thinnest:.2f} dik</numerusform>
            <numerusform>nog {places} kleinere plaatsen zijn dunner dan een voxel van {voxel}; dit is de grootste, de dunste is {thinnest:.2f} dik</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places overhang too far, {area:.3g} in all; this is the largest</source>
        <translation>
            <numerusform>nog één kleinere plaats hangt te ver over, {area:.3g} in totaal; dit is de grootste</numerusform>
            <numerusform>nog {places} kleinere plaatsen hangen te ver over, {area:.3g} in totaal; dit is de grootste</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer to {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}: geen botsingsvrije verplaatsing naar één baandeel</numerusform>
            <numerusform>{place}: geen botsingsvrije verplaatsing naar {pieces} baandelen</numerusform>
        </translation>
    </message>
    <message>
        <source>{place}: too far from the rod: the cell prints up to {radius} from its axis and {along} from its middle</source>
        <translation>{place}: te ver van de staaf: de cel print tot {radius} vanaf de as en {along} vanaf het midden</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into the platform</source>
        <translation>{place}: de printkop zou in het platform snijden</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into printed material</source>
        <translation>{place}: de printkop zou in geprint materiaal snijden</translation>
    </message>
    <message>
        <source>{place}: reachable, but the robot cannot move from or to a neighbouring point without lifting</source>
        <translation>{place}: bereikbaar, maar de robot kan niet zonder optillen van of naar een naburig punt bewegen</translation>
    </message>
    <message>
        <source>{place}: out of the robot&apos;s reach, or beyond a joint limit, at every rotation tried about the nozzle</source>
        <translation>{place}: buiten het bereik van de robot, of voorbij een gewrichtsgrens, bij elke geprobeerde rotatie om de nozzle</translation>
    </message>
    <message>
        <source>{place}: {first} would collide with {second} at every rotation tried about the nozzle</source>
        <translation>{place}: {first} zou met {second} botsen bij elke geprobeerde rotatie om de nozzle</translation>
    </message>
    <message>
        <source>{points} points do not define a circle: at least three are needed</source>
        <translation>{points} punten bepalen geen cirkel: er zijn er ten minste drie nodig</translation>
    </message>
    <message>
        <source>{share:.0f} of the layers&apos; area is thinner than {least} or thicker than {most}</source>
        <translation>{share:.0f} van de oppervlakte van de lagen is dunner dan {least} of dikker dan {most}</translation>
    </message>
    <message>
        <source>{share:.2f} of the part is not covered by beads, mostly around this point</source>
        <translation>{share:.2f} van het onderdeel wordt niet door strengen bedekt, vooral rond dit punt</translation>
    </message>
    <message>
        <source>{sizes} mm</source>
        <translation>{sizes} mm</translation>
    </message>
    <message>
        <source>{there} of the {promised} facets stated in the header are present</source>
        <translation>{there} van de {promised} in de kop vermelde facetten zijn aanwezig</translation>
    </message>
    <message>
        <source>{threshold} {value:.4g} (limit {limit:.4g})</source>
        <translation>{threshold} {value:.4g} (grens {limit:.4g})</translation>
    </message>
    <message>
        <source>{value} is outside the limits of process {process}</source>
        <translation>{value} valt buiten de grenzen van proces {process}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} more voxels are missed in smaller groups ({groups}); this is the largest</source>
        <translation>
            <numerusform>nog {voxels} voxel gemist in kleinere groepen ({groups}); dit is de grootste</numerusform>
            <numerusform>nog {voxels} voxels gemist in kleinere groepen ({groups}); dit is de grootste</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm</source>
        <translation>
            <numerusform>één voxel is afgeschaduwd: vanaf stap {step} bedekt door het convexe front, onder het facet tussen {a:.0f}, {b:.0f} en {c:.0f} mm</numerusform>
            <numerusform>{voxels} voxels zijn afgeschaduwd: vanaf stap {step} bedekt door het convexe front, onder het facet tussen {a:.0f}, {b:.0f} en {c:.0f} mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front before growth reached them</source>
        <translation>
            <numerusform>één voxel is afgeschaduwd: bedekt door het convexe front voordat de groei hem bereikte</numerusform>
            <numerusform>{voxels} voxels zijn afgeschaduwd: bedekt door het convexe front voordat de groei ze bereikte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are unreached: no path through the part from the platform</source>
        <translation>
            <numerusform>één voxel is niet bereikt: geen pad door het onderdeel vanaf het platform</numerusform>
            <numerusform>{voxels} voxels zijn niet bereikt: geen pad door het onderdeel vanaf het platform</numerusform>
        </translation>
    </message>
    <message>
        <source>{voxels} voxels in a grid of {cells} cells need about {needed} of memory; {available} are free</source>
        <translation>{voxels} voxels in een raster van {cells} cellen vereisen ongeveer {needed} geheugen; {available} is vrij</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are below the plate</source>
        <translation>
            <numerusform>één voxel ligt onder de plaat</numerusform>
            <numerusform>{voxels} voxels liggen onder de plaat</numerusform>
        </translation>
    </message>
    <message>
        <source>{where}, entry {number}</source>
        <translation>{where}, element {number}</translation>
    </message>
    <message>
        <source>Contact area, margin</source>
        <translation>Contactoppervlak, marge</translation>
    </message>
    <message>
        <source>Rod of the cell</source>
        <translation>Staaf van de cel</translation>
    </message>
    <message>
        <source>Disc, diameter</source>
        <translation>Schijf, diameter</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>Rod, diameter × length</source>
        <translation>Staaf, diameter × lengte</translation>
    </message>
    <message>
        <source>Body from a file</source>
        <translation>Lichaam uit een bestand</translation>
    </message>
    <message>
        <source>Margin around the contact area</source>
        <translation>Marge rondom het contactoppervlak</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>Breedte (X)</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>Diepte (Y)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Curved layers</source>
        <translation>Gebogen lagen</translation>
    </message>
    <message>
        <source>Extended G-code (nozzle direction as nX nY nZ)</source>
        <translation>Uitgebreide G-code (richting van de nozzle als nX nY nZ)</translation>
    </message>
    <message>
        <source>Joint table (CSV)</source>
        <translation>Gewrichtentabel (CSV)</translation>
    </message>
    <message>
        <source>contact area</source>
        <translation>contactoppervlak</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Peels the part and keeps the best of several passes</source>
        <translation>Pelt het onderdeel en behoudt de beste van meerdere doorgangen</translation>
    </message>
    <message>
        <source>Reverse peeling</source>
        <translation>Omgekeerd pellen</translation>
    </message>
    <message>
        <source>Removes voxels from outside while the rest stays supported; printed in the opposite order</source>
        <translation>Verwijdert voxels van buitenaf terwijl de rest ondersteund blijft; geprint in omgekeerde volgorde</translation>
    </message>
    <message>
        <source>Guided by peeling</source>
        <translation>Geleid door pellen</translation>
    </message>
    <message>
        <source>Grows from the platform, held back by the peeling field</source>
        <translation>Groeit vanaf het platform, afgeremd door het pelveld</translation>
    </message>
    <message>
        <source>Halved layers</source>
        <translation>Gehalveerde lagen</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer that would shadow voxels is halved until it does not</source>
        <translation>Groeit vanaf het platform; een laag die voxels zou afschaduwen wordt gehalveerd totdat ze dat niet meer doet</translation>
    </message>
    <message>
        <source>Voxel by voxel</source>
        <translation>Voxel voor voxel</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer takes each voxel that shadows no other</source>
        <translation>Groeit vanaf het platform; een laag neemt elke voxel die geen andere afschaduwt</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Greedy</translation>
    </message>
    <message>
        <source>Grows from the platform by whole layers, whatever they shadow</source>
        <translation>Groeit vanaf het platform met hele lagen, wat ze ook afschaduwen</translation>
    </message>
    <message>
        <source>Drop to plate</source>
        <translation>Op plaat laten zakken</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>Laat het onderdeel op de plaat zakken</translation>
    </message>
    <message>
        <source>Shrink platform</source>
        <translation>Platform verkleinen</translation>
    </message>
    <message>
        <source>To the part&apos;s contact area, which narrows the front</source>
        <translation>Tot het contactoppervlak van het onderdeel, waardoor het front smaller wordt</translation>
    </message>
    <message>
        <source>Add supports</source>
        <translation>Ondersteuning toevoegen</translation>
    </message>
    <message>
        <source>As few thin break-away columns as possible</source>
        <translation>Zo weinig mogelijk dunne afbreekbare kolommen</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Onderdeel draaien</translation>
    </message>
    <message>
        <source>Searches the orientation with the fewest missed voxels</source>
        <translation>Zoekt de oriëntatie met de minste gemiste voxels</translation>
    </message>
    <message>
        <source>Narrow enough for this wall; narrower voxels take longer</source>
        <translation>Smal genoeg voor deze wand; smallere voxels kosten meer tijd</translation>
    </message>
    <message>
        <source>Planar pieces</source>
        <translation>Vlakke delen</translation>
    </message>
    <message>
        <source>Flat layers</source>
        <translation>Vlakke lagen</translation>
    </message>
    <message>
        <source>Widen the platform</source>
        <translation>Platform verbreden</translation>
    </message>
    <message>
        <source>By 20 mm on all sides, to give supports a base</source>
        <translation>20 mm aan alle zijden, zodat ondersteuning een basis heeft</translation>
    </message>
    <message>
        <source>Adapt the layers</source>
        <translation>Lagen aanpassen</translation>
    </message>
    <message>
        <source>Thinner layers on sloping surfaces, to reduce the gaps at steps</source>
        <translation>Dunnere lagen op hellende vlakken, om de spleten bij traptreden te verkleinen</translation>
    </message>
    <message>
        <source>Searches the orientation with the smallest area to support</source>
        <translation>Zoekt de oriëntatie met het kleinste te ondersteunen oppervlak</translation>
    </message>
    <message>
        <source>Around a rod</source>
        <translation>Rondom een staaf</translation>
    </message>
    <message>
        <source>On a given surface</source>
        <translation>Op een gegeven oppervlak</translation>
    </message>
    <message>
        <source>repair the mesh, or use curved mode, which takes any mesh</source>
        <translation>repareer de mesh, of gebruik modus curved, die elke mesh accepteert</translation>
    </message>
    <message>
        <source>a planar section of the mesh crosses itself</source>
        <translation>een vlakke doorsnede van de mesh kruist zichzelf</translation>
    </message>
    <message>
        <source>EGL cannot be initialized</source>
        <translation>EGL kan niet worden geïnitialiseerd</translation>
    </message>
    <message>
        <source>EGL does not support platform displays</source>
        <translation>EGL ondersteunt geen platformdisplays</translation>
    </message>
    <message>
        <source>its functions were not found</source>
        <translation>de functies ervan zijn niet gevonden</translation>
    </message>
    <message>
        <source>no context can be made</source>
        <translation>er kan geen context worden gemaakt</translation>
    </message>
    <message>
        <source>the context cannot be used</source>
        <translation>de context kan niet worden gebruikt</translation>
    </message>
    <message>
        <source>Plate of the cell</source>
        <translation>Plaat van de cel</translation>
    </message>
    <message>
        <source>cell {cell} has no plates</source>
        <translation>cel {cell} heeft geen platen</translation>
    </message>
    <message>
        <source>choose another platform, or another cell</source>
        <translation>kies een ander platform, of een andere cel</translation>
    </message>
    <message>
        <source>copy it to a file first</source>
        <translation>kopieer het eerst naar een bestand</translation>
    </message>
    <message>
        <source>give `--platform disc:DIAMETER`, or another platform</source>
        <translation>geef `--platform disc:DIAMETER` op, of een ander platform</translation>
    </message>
    <message>
        <source>is not a regular file, but a device or a pipe</source>
        <translation>is geen gewoon bestand, maar een apparaat of een pipe</translation>
    </message>
    <message>
        <source>check these places in the view; turn the part if they matter</source>
        <translation>controleer deze plaatsen in de weergave; draai het onderdeel als ze van belang zijn</translation>
    </message>
    <message>
        <source>no way of building supports platform {platform} in cell {cell}</source>
        <translation>geen enkele bouwwijze ondersteunt platform {platform} in cel {cell}</translation>
    </message>
    <message>
        <source>plate of the cell</source>
        <translation>plaat van de cel</translation>
    </message>
    <message>
        <source>transfers</source>
        <translation>verplaatsingen</translation>
    </message>
    <message>
        <source>{place}: skipped, because of a collision on the way to it</source>
        <translation>{place}: overgeslagen, wegens een botsing op weg ernaartoe</translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer away from the ends of {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}: geen botsingsvrije verplaatsing vanaf het einde van één baandeel</numerusform>
            <numerusform>{place}: geen botsingsvrije verplaatsing vanaf de uiteinden van {pieces} baandelen</numerusform>
        </translation>
    </message>
    <message>
        <source>a mesh with defects cannot be cut into pieces</source>
        <translation>een mesh met gebreken kan niet in delen worden gesneden</translation>
    </message>
    <message>
        <source>&apos;{units}&apos; is not a unit of length</source>
        <translation>&apos;{units}&apos; is geen lengte-eenheid</translation>
    </message>
    <message>
        <source>Scales it by 25.4</source>
        <translation>Schaalt het met 25,4</translation>
    </message>
    <message>
        <source>Scales it by 1000</source>
        <translation>Schaalt het met 1000</translation>
    </message>
    <message>
        <source>Scales it by 0.001</source>
        <translation>Schaalt het met 0,001</translation>
    </message>
    <message>
        <source>Large enough for the narrowest bead</source>
        <translation>Groot genoeg voor de smalste streng</translation>
    </message>
    <message>
        <source>The largest scale within the robot&apos;s reach</source>
        <translation>De grootste schaal binnen het bereik van de robot</translation>
    </message>
    <message>
        <source>Centre the part</source>
        <translation>Onderdeel centreren</translation>
    </message>
    <message>
        <source>The file is in inches</source>
        <translation>Het bestand is in inches</translation>
    </message>
    <message>
        <source>The file is in metres</source>
        <translation>Het bestand is in meters</translation>
    </message>
    <message>
        <source>The file is in micrometres</source>
        <translation>Het bestand is in micrometers</translation>
    </message>
    <message>
        <source>On the platform&apos;s position</source>
        <translation>Op de positie van het platform</translation>
    </message>
    <message>
        <source>Print at scale {scale}</source>
        <translation>Printen op schaal {scale}</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Passend schalen</translation>
    </message>
    <message>
        <source>Use a finer process</source>
        <translation>Fijner proces gebruiken</translation>
    </message>
    <message>
        <source>With the widest bead that fits these walls</source>
        <translation>Met de breedste streng die in deze wanden past</translation>
    </message>
    <message>
        <source>give one of {known}</source>
        <translation>geef een van {known} op</translation>
    </message>
    <message>
        <source>give the units it was drawn in (`--units`)</source>
        <translation>geef de eenheid op waarin het is getekend (`--units`)</translation>
    </message>
    <message>
        <source>centre the part, or use a platform that reaches its support</source>
        <translation>centreer het onderdeel, of gebruik een platform dat tot zijn drager reikt</translation>
    </message>
    <message>
        <source>print it at scale {scale}, or use a process with narrower beads</source>
        <translation>print het op schaal {scale}, of gebruik een proces met smallere strengen</translation>
    </message>
    <message>
        <source>print it smaller (`--scale fit`), or give the units it was drawn in (`--units`)</source>
        <translation>print het kleiner (`--scale fit`), of geef de eenheid op waarin het is getekend (`--units`)</translation>
    </message>
    <message>
        <source>the part is very small: {size:.3g} long if its file is in millimetres</source>
        <translation>het onderdeel is erg klein: {size:.3g} lang als het bestand in millimeters is</translation>
    </message>
    <message>
        <source>the part is very large: {size:.4g} long if its file is in millimetres</source>
        <translation>het onderdeel is erg groot: {size:.4g} lang als het bestand in millimeters is</translation>
    </message>
    <message>
        <source>platform {distance:.0f} beside its support: it would float</source>
        <translation>platform {distance:.0f} naast zijn drager: het zou zweven</translation>
    </message>
    <message>
        <source>use a process with narrower beads; scaled up enough, the part is out of the robot&apos;s reach</source>
        <translation>gebruik een proces met smallere strengen; voldoende vergroot valt het onderdeel buiten het bereik van de robot</translation>
    </message>
    <message>
        <source>{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick</source>
        <translation>{share:.3g} van het onderdeel is dunner dan de smalste streng ({least}); het meeste is {usual:.2f} dik</translation>
    </message>
    <message>
        <source>Use best orientation</source>
        <translation>Beste oriëntatie gebruiken</translation>
    </message>
    <message>
        <source>Most contact relative to the overhang, and fewest missed voxels</source>
        <translation>Meeste contact in verhouding tot de overhang, en minste gemiste voxels</translation>
    </message>
    <message>
        <source>give degrees about x, y and z: 90,0,0</source>
        <translation>geef graden om x, y en z op: 90,0,0</translation>
    </message>
    <message>
        <source>use that orientation, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another one</source>
        <translation>gebruik die oriëntatie, {x:.3g} om x, {y:.3g} om y en {z:.3g} om z gedraaid, of kies een andere</translation>
    </message>
    <message>
        <source>poor orientation: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} of the voxels missed; another orientation has contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} missed</source>
        <translation>ongunstige oriëntatie: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} van de voxels gemist; een andere oriëntatie heeft contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} gemist</translation>
    </message>
    <message>
        <source>turn &apos;{turn}&apos; is not three angles</source>
        <translation>draaiing &apos;{turn}&apos; bestaat niet uit drie hoeken</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>oriëntaties</translation>
    </message>
    <message>
        <source>{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}</source>
        <translation>{length:.1f} van een streng is niet ondersteund; dit materiaal overbrugt {bridge:.1f}</translation>
    </message>
    <message>
        <source>use a pedestal made for the part: it leaves room for the print head; a drawing of it is written</source>
        <translation>gebruik een voor het onderdeel gemaakte sokkel: die laat ruimte voor de printkop; er wordt een tekening van geschreven</translation>
    </message>
    <message numerus="yes">
        <source>without columns, {here} voxels would be missed on this plate, {there} on a pedestal as wide as the part&apos;s footprint</source>
        <translation>
            <numerusform>zonder kolommen zou op deze plaat {here} voxel gemist worden, en {there} op een sokkel zo breed als het grondvlak van het onderdeel</numerusform>
            <numerusform>zonder kolommen zouden op deze plaat {here} voxels gemist worden, en {there} op een sokkel zo breed als het grondvlak van het onderdeel</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;unitfactor&apos; is not above 0</source>
        <translation>&apos;unitfactor&apos; is niet groter dan 0</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not above 0, or too large</source>
        <translation>&apos;{attribute}&apos; is niet groter dan 0, of te groot</translation>
    </message>
    <message>
        <source>&apos;{element}&apos; outside tool-paths</source>
        <translation>&apos;{element}&apos; buiten gereedschapsbanen</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; calls itself</source>
        <translation>&apos;{name}&apos; roept zichzelf aan</translation>
    </message>
    <message>
        <source>invalid call of &apos;{name}&apos;</source>
        <translation>ongeldige aanroep van &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; needs a mass</source>
        <translation>&apos;{name}&apos; vereist een massa</translation>
    </message>
    <message>
        <source>&apos;{path}&apos; is not the name of a part in the package</source>
        <translation>&apos;{path}&apos; is niet de naam van een onderdeel in het pakket</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not allowed here: it changes the machine during the print</source>
        <translation>&apos;{word}&apos; is hier niet toegestaan: het verandert de machine tijdens het printen</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; slows the arm: the flow would not follow</source>
        <translation>&apos;{word}&apos; vertraagt de arm: de doorvoer zou niet volgen</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; sets a different load</source>
        <translation>&apos;{word}&apos; stelt een andere last in</translation>
    </message>
    <message>
        <source>Prints a file along its own tool-paths (.build.3mf, .gcode). Off: plans new ones for its object.</source>
        <translation>Print een bestand langs zijn eigen gereedschapsbanen (.build.3mf, .gcode). Uit: plant nieuwe voor het object ervan.</translation>
    </message>
    <message>
        <source>Adds NAME.build.3mf: the plan&apos;s 6-axis tool-paths for other programs (3MF Toolpath Extension).</source>
        <translation>Voegt NAME.build.3mf toe: de 6-assige gereedschapsbanen van het plan voor andere programma&apos;s (3MF Toolpath Extension).</translation>
    </message>
    <message>
        <source>IRC5: .mod</source>
        <translation>IRC5: .mod</translation>
    </message>
    <message>
        <source>OmniCore: .modx</source>
        <translation>OmniCore: .modx</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programma&apos;s</translation>
    </message>
    <message>
        <source>RAPID modules</source>
        <translation>RAPID-modules</translation>
    </message>
    <message>
        <source>URScript for</source>
        <translation>URScript voor</translation>
    </message>
    <message>
        <source>a TriggL before its TriggEquip</source>
        <translation>een TriggL vóór zijn TriggEquip</translation>
    </message>
    <message>
        <source>a bead is printed by a joint motion instead of a straight one</source>
        <translation>een streng wordt geprint met een gewrichtsbeweging in plaats van een rechte</translation>
    </message>
    <message>
        <source>unexpected control character: is this a binary file?</source>
        <translation>onverwacht stuurteken: is dit een binair bestand?</translation>
    </message>
    <message>
        <source>use a larger nozzle, or slower tool-paths</source>
        <translation>gebruik een grotere nozzle, of langzamere gereedschapsbanen</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos; without a range above 0 or without a factor of e, f, g and h</source>
        <translation>een modificator van &apos;{attribute}&apos; zonder bereik boven 0 of zonder factor e, f, g en h</translation>
    </message>
    <message>
        <source>an unsupported modifier of &apos;{attribute}&apos;</source>
        <translation>een niet-ondersteunde modificator van &apos;{attribute}&apos;</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos;, which its profile lacks</source>
        <translation>een modificator van &apos;{attribute}&apos;, dat in het profiel ontbreekt</translation>
    </message>
    <message>
        <source>a modifier of unknown type &apos;{type}&apos;</source>
        <translation>een modificator van onbekend type &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>a modifier outside a profile</source>
        <translation>een modificator buiten een profiel</translation>
    </message>
    <message>
        <source>a point more than a kilometre away</source>
        <translation>een punt meer dan een kilometer weg</translation>
    </message>
    <message>
        <source>a point&apos;s frame has no direction</source>
        <translation>het assenstelsel van een punt heeft geen richting</translation>
    </message>
    <message>
        <source>a second call outside the functions</source>
        <translation>een tweede aanroep buiten de functies</translation>
    </message>
    <message>
        <source>a segment of fewer than two points</source>
        <translation>een segment van minder dan twee punten</translation>
    </message>
    <message>
        <source>a segment of type &apos;{type}&apos; among tool-paths of {axes} axes</source>
        <translation>een segment van type &apos;{type}&apos; tussen gereedschapsbanen van {axes} assen</translation>
    </message>
    <message>
        <source>a modifier&apos;s support point outside a point</source>
        <translation>een steunpunt van een modificator buiten een punt</translation>
    </message>
    <message>
        <source>threads are not supported</source>
        <translation>threads worden niet ondersteund</translation>
    </message>
    <message>
        <source>a tool-path is beyond the range of a build file</source>
        <translation>een gereedschapsbaan valt buiten het bereik van een bouwbestand</translation>
    </message>
    <message>
        <source>a work object moved by both robot and external axis is not supported</source>
        <translation>een werkobject dat door zowel robot als externe as wordt bewogen, wordt niet ondersteund</translation>
    </message>
    <message>
        <source>an unexpected {point}</source>
        <translation>een onverwachte {point}</translation>
    </message>
    <message>
        <source>a tool other than the printing one</source>
        <translation>een ander gereedschap dan het printende</translation>
    </message>
    <message>
        <source>requires the unknown extension &apos;{name}&apos;</source>
        <translation>vereist de onbekende extensie &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>at the controller&apos;s speeds, {share:.2f} of the bead length gets over 5 % too much or too little material</source>
        <translation>bij de snelheden van de besturing krijgt {share:.2f} van de strenglengte meer dan 5 % te veel of te weinig materiaal</translation>
    </message>
    <message>
        <source>bead {bead}</source>
        <translation>streng {bead}</translation>
    </message>
    <message>
        <source>choose an earlier or a later bead</source>
        <translation>kies een eerdere of een latere streng</translation>
    </message>
    <message>
        <source>choose an earlier place</source>
        <translation>kies een eerdere plaats</translation>
    </message>
    <message>
        <source>factors of &apos;{attribute}&apos; are finer than its modifier&apos;s type allows</source>
        <translation>factoren van &apos;{attribute}&apos; zijn fijner dan het type modificator toelaat</translation>
    </message>
    <message>
        <source>from the front (x to the right, z up)</source>
        <translation>vanaf de voorkant (x naar rechts, z omhoog)</translation>
    </message>
    <message>
        <source>from the side (y to the right, z up)</source>
        <translation>vanaf de zijkant (y naar rechts, z omhoog)</translation>
    </message>
    <message>
        <source>give --program</source>
        <translation>geef --program op</translation>
    </message>
    <message>
        <source>give --program, a file from {first} to {last}</source>
        <translation>geef --program op, een bestand van {first} tot {last}</translation>
    </message>
    <message>
        <source>choose the process that the tool-paths were made for</source>
        <translation>kies het proces waarvoor de gereedschapsbanen zijn gemaakt</translation>
    </message>
    <message>
        <source>gravity of an arm that is not upright</source>
        <translation>zwaartekracht van een arm die niet rechtop staat</translation>
    </message>
    <message>
        <source>has a document type, which is not accepted</source>
        <translation>heeft een documenttype, wat niet wordt geaccepteerd</translation>
    </message>
    <message>
        <source>contains neither an object nor beads with width and height</source>
        <translation>bevat geen object en ook geen strengen met breedte en hoogte</translation>
    </message>
    <message>
        <source>contains no tool-paths</source>
        <translation>bevat geen gereedschapsbanen</translation>
    </message>
    <message>
        <source>exceeds the limit of a joint of the robot</source>
        <translation>overschrijdt de grens van een gewricht van de robot</translation>
    </message>
    <message>
        <source>is not a layer of tool-paths</source>
        <translation>is geen laag met gereedschapsbanen</translation>
    </message>
    <message>
        <source>leave scale and units as they are, or give `givenToolPaths=false`</source>
        <translation>laat schaal en eenheden zoals ze zijn, of geef `givenToolPaths=false` op</translation>
    </message>
    <message>
        <source>line {line} is ambiguous: the program has {count} files</source>
        <translation>regel {line} is dubbelzinnig: het programma heeft {count} bestanden</translation>
    </message>
    <message>
        <source>mixed line ends: they differ from here on</source>
        <translation>gemengde regeleinden: vanaf hier zijn ze anders</translation>
    </message>
    <message>
        <source>too much for a zip file</source>
        <translation>te veel voor een zipbestand</translation>
    </message>
    <message>
        <source>more tool-path points than can be planned</source>
        <translation>meer baanpunten dan gepland kunnen worden</translation>
    </message>
    <message>
        <source>motions per file</source>
        <translation>bewegingen per bestand</translation>
    </message>
    <message>
        <source>near singular poses the arm would deviate from the planned orientation</source>
        <translation>bij singuliere poses zou de arm van de geplande oriëntatie afwijken</translation>
    </message>
    <message>
        <source>no motion at or after line {line}</source>
        <translation>geen beweging op of na regel {line}</translation>
    </message>
    <message>
        <source>no object in the file: the part is made from its beads</source>
        <translation>geen object in het bestand: het onderdeel wordt uit de strengen gemaakt</translation>
    </message>
    <message>
        <source>not a program of this job</source>
        <translation>geen programma van deze opdracht</translation>
    </message>
    <message>
        <source>not the definition of a function without arguments</source>
        <translation>niet de definitie van een functie zonder argumenten</translation>
    </message>
    <message>
        <source>nothing is printed after that place</source>
        <translation>na die plaats wordt niets geprint</translation>
    </message>
    <message>
        <source>the first of {count} sets of tool-paths was taken</source>
        <translation>de eerste van {count} sets gereedschapsbanen is genomen</translation>
    </message>
    <message>
        <source>flow changes are only supported at the start of a motion</source>
        <translation>wijzigingen van de doorvoer worden alleen aan het begin van een beweging ondersteund</translation>
    </message>
    <message>
        <source>use the program for the cell&apos;s own controller</source>
        <translation>gebruik het programma voor de besturing van de cel zelf</translation>
    </message>
    <message>
        <source>stated payload {mass:.2f} kg, planned about {planned:.2f} kg</source>
        <translation>opgegeven last {mass:.2f} kg, gepland ongeveer {planned:.2f} kg</translation>
    </message>
    <message>
        <source>the beads are too thin to be filled with cells</source>
        <translation>de strengen zijn te dun om met cellen te vullen</translation>
    </message>
    <message>
        <source>the beads extend too far to be filled with cells</source>
        <translation>de strengen strekken zich te ver uit om met cellen te vullen</translation>
    </message>
    <message>
        <source>the build&apos;s tool-paths {id} are missing</source>
        <translation>de gereedschapsbanen {id} van de build ontbreken</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is given twice</source>
        <translation>de factor &apos;{factor}&apos; is twee keer opgegeven</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is not within 0 and 1</source>
        <translation>de factor &apos;{factor}&apos; ligt niet tussen 0 en 1</translation>
    </message>
    <message>
        <source>the file begins with a byte-order mark: save it as plain text</source>
        <translation>het bestand begint met een byte-order mark: sla het op als platte tekst</translation>
    </message>
    <message numerus="yes">
        <source>the file gives no width, height or speed for {points} points of its tool-paths: taken from process {process}</source>
        <translation>
            <numerusform>het bestand geeft voor één punt van de gereedschapsbanen geen breedte, hoogte of snelheid: overgenomen van proces {process}</numerusform>
            <numerusform>het bestand geeft voor {points} punten van de gereedschapsbanen geen breedte, hoogte of snelheid: overgenomen van proces {process}</numerusform>
        </translation>
    </message>
    <message>
        <source>the first motion is too fast: it begins at an unknown pose of the arm</source>
        <translation>de eerste beweging is te snel: ze begint bij een onbekende pose van de arm</translation>
    </message>
    <message>
        <source>the frames of tool-paths point into the part; they were reversed</source>
        <translation>de assenstelsels van gereedschapsbanen wijzen het onderdeel in; ze zijn omgekeerd</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is defined twice</source>
        <translation>de functie &apos;{defined}&apos; is twee keer gedefinieerd</translation>
    </message>
    <message>
        <source>the job has no program to take the line from</source>
        <translation>de opdracht heeft geen programma om de regel uit te nemen</translation>
    </message>
    <message>
        <source>the job has no motion to resume</source>
        <translation>de opdracht heeft geen beweging om te hervatten</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; is not related to the model</source>
        <translation>laag &apos;{path}&apos; is niet aan het model gekoppeld</translation>
    </message>
    <message>
        <source>duplicate layer &apos;{path}&apos;</source>
        <translation>dubbele laag &apos;{path}&apos;</translation>
    </message>
    <message>
        <source>computing the part printed so far</source>
        <translation>het tot nu toe geprinte onderdeel berekenen</translation>
    </message>
    <message>
        <source>the part {id} of a segment is not in its layer</source>
        <translation>het onderdeel {id} van een segment zit niet in zijn laag</translation>
    </message>
    <message>
        <source>the profile &apos;{uuid}&apos; is not in the model</source>
        <translation>het profiel &apos;{uuid}&apos; zit niet in het model</translation>
    </message>
    <message>
        <source>duplicate profile &apos;{uuid}&apos;</source>
        <translation>dubbel profiel &apos;{uuid}&apos;</translation>
    </message>
    <message>
        <source>the profile {id} of a segment is not in its layer</source>
        <translation>het profiel {id} van een segment zit niet in zijn laag</translation>
    </message>
    <message>
        <source>the robot must hold either the tool or the work object</source>
        <translation>de robot moet het gereedschap of het werkobject vasthouden</translation>
    </message>
    <message>
        <source>a modifier&apos;s support points do not increase between 0 and 1</source>
        <translation>de steunpunten van een modificator lopen niet op tussen 0 en 1</translation>
    </message>
    <message>
        <source>the tool-paths of the part&apos;s file are damaged</source>
        <translation>de gereedschapsbanen van het bestand van het onderdeel zijn beschadigd</translation>
    </message>
    <message>
        <source>unknown unit &apos;{unit}&apos;</source>
        <translation>onbekende eenheid &apos;{unit}&apos;</translation>
    </message>
    <message>
        <source>the {format} program, for another controller, is not released: {failed}</source>
        <translation>het {format}-programma, voor een andere besturing, is niet vrijgegeven: {failed}</translation>
    </message>
    <message>
        <source>no bead {bead}: the plan has {beads} beads</source>
        <translation>geen streng {bead}: het plan heeft {beads} strengen</translation>
    </message>
    <message>
        <source>commanded acceleration is {times:.1f} times the planned one</source>
        <translation>opgedragen versnelling is {times:.1f} keer de geplande</translation>
    </message>
    <message>
        <source>the tool-paths of a file cannot be scaled</source>
        <translation>de gereedschapsbanen van een bestand kunnen niet worden geschaald</translation>
    </message>
    <message>
        <source>tool-paths of the file</source>
        <translation>gereedschapsbanen van het bestand</translation>
    </message>
    <message>
        <source>two modifiers of &apos;{attribute}&apos; or with the same factor</source>
        <translation>twee modificators van &apos;{attribute}&apos; of met dezelfde factor</translation>
    </message>
    <message>
        <source>unpacks to an implausible size</source>
        <translation>wordt uitgepakt tot een onwaarschijnlijke grootte</translation>
    </message>
    <message>
        <source>unparsed text in a layer&apos;s data</source>
        <translation>niet-verwerkte tekst in de gegevens van een laag</translation>
    </message>
    <message>
        <source>unparsed text in a tool-path&apos;s data</source>
        <translation>niet-verwerkte tekst in de gegevens van een gereedschapsbaan</translation>
    </message>
    <message>
        <source>waits before and after tool-paths are left out</source>
        <translation>wachttijden vóór en na gereedschapsbanen worden weggelaten</translation>
    </message>
    <message>
        <source>write a build file</source>
        <translation>bouwbestand schrijven</translation>
    </message>
    <message>
        <source>write verification reports</source>
        <translation>controlerapporten schrijven</translation>
    </message>
    <message>
        <source>write the program again, with times instead of speeds where the format supports them</source>
        <translation>schrijf het programma opnieuw, met tijden in plaats van snelheden waar het formaat die ondersteunt</translation>
    </message>
    <message>
        <source>{celsius} °C is outside the printing range of {material}</source>
        <translation>{celsius} °C ligt buiten het printbereik van {material}</translation>
    </message>
    <message>
        <source>{length:.0f} of filament retracted: out of the hot end</source>
        <translation>{length:.0f} filament ingetrokken: uit de hot-end</translation>
    </message>
    <message>
        <source>{part}: verification report of the {format} program</source>
        <translation>{part}: controlerapport van het {format}-programma</translation>
    </message>
    <message>
        <source>{place}: no collision-free transfer from home to the place where the print resumes</source>
        <translation>{place}: geen botsingsvrije verplaatsing van de uitgangspose naar de plaats waar het printen wordt hervat</translation>
    </message>
    <message numerus="yes">
        <source>{points} points of the file&apos;s tool-paths need more flow than the extruder&apos;s limit of {limit}: printed slower</source>
        <translation>
            <numerusform>één punt van de gereedschapsbanen van het bestand vereist meer doorvoer dan de grens van de extruder van {limit}: langzamer geprint</numerusform>
            <numerusform>{points} punten van de gereedschapsbanen van het bestand vereisen meer doorvoer dan de grens van de extruder van {limit}: langzamer geprint</numerusform>
        </translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded before the first bead instead of {planned:.3f}</source>
        <translation>vóór de eerste streng wordt {volume:.3f} geëxtrudeerd in plaats van {planned:.3f}</translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded here while the nozzle does not move for {time:.3f}</source>
        <translation>hier wordt {volume:.3f} geëxtrudeerd terwijl de nozzle {time:.3f} niet beweegt</translation>
    </message>
    <message>
        <source>$APO.CDIS is not set before this motion</source>
        <translation>$APO.CDIS is niet vóór deze beweging ingesteld</translation>
    </message>
    <message>
        <source>$IPO_MODE must be #BASE or #TCP</source>
        <translation>$IPO_MODE moet #BASE of #TCP zijn</translation>
    </message>
    <message>
        <source>$VEL.CP is not set before this motion</source>
        <translation>$VEL.CP is niet vóór deze beweging ingesteld</translation>
    </message>
    <message>
        <source>&apos;ChangeTCP&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;ChangeTCP&apos; tussen PVTEnter en PVTExit</translation>
    </message>
    <message>
        <source>&apos;Cnt&apos; is 0, or 1 with two distances</source>
        <translation>&apos;Cnt&apos; is 0, of 1 met twee afstanden</translation>
    </message>
    <message>
        <source>&apos;Dly&apos; without a time in seconds</source>
        <translation>&apos;Dly&apos; zonder tijd in seconden</translation>
    </message>
    <message>
        <source>&apos;EMvs&apos; without work coordinates 1 to 8</source>
        <translation>&apos;EMvs&apos; zonder werkcoördinaten 1 tot 8</translation>
    </message>
    <message>
        <source>&apos;Mvs&apos; and &apos;EMvs&apos; in one program: only one of them can move the nozzle</source>
        <translation>&apos;Mvs&apos; en &apos;EMvs&apos; in één programma: slechts een van beide kan de nozzle bewegen</translation>
    </message>
    <message>
        <source>&apos;PTP&apos; in millimetres per second</source>
        <translation>&apos;PTP&apos; in millimeter per seconde</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; needs 0 (joints) or 1 (poses)</source>
        <translation>&apos;PVTEnter&apos; vereist 0 (gewrichten) of 1 (poses)</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; without PVTExit before it</source>
        <translation>&apos;PVTEnter&apos; zonder PVTExit ervoor</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; is missing before the end</source>
        <translation>&apos;PVTExit&apos; ontbreekt vóór het einde</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; without PVTEnter before it</source>
        <translation>&apos;PVTExit&apos; zonder PVTEnter ervoor</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; needs six positions, six velocities and a time in seconds</source>
        <translation>&apos;PVTPoint&apos; vereist zes posities, zes snelheden en een tijd in seconden</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; with an invalid time or velocity</source>
        <translation>&apos;PVTPoint&apos; met een ongeldige tijd of snelheid</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; without PVTEnter before it</source>
        <translation>&apos;PVTPoint&apos; zonder PVTEnter ervoor</translation>
    </message>
    <message>
        <source>&apos;Wth&apos; without an output</source>
        <translation>&apos;Wth&apos; zonder uitgang</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; without a sensible value</source>
        <translation>&apos;{name}&apos; zonder zinvolle waarde</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is a frame that only the controller knows</source>
        <translation>&apos;{word}&apos; is een assenstelsel dat alleen de besturing kent</translation>
    </message>
    <message>
        <source>Motions shorter than {time} ms are stretched to that time and their flow is reduced to match.</source>
        <translation>Bewegingen korter dan {time} ms worden tot die tijd opgerekt en hun doorvoer wordt navenant verlaagd.</translation>
    </message>
    <message>
        <source>Corners are passed without a stop, as if rounded by an arc with a deviation of {distance:.3g}.</source>
        <translation>Hoeken worden zonder stop doorlopen, alsof ze met een boog met een afwijking van {distance:.3g} zijn afgerond.</translation>
    </message>
    <message>
        <source>E1 is missing: an external axis moves the base</source>
        <translation>E1 ontbreekt: een externe as beweegt de basis</translation>
    </message>
    <message>
        <source>ENDDAT is missing: the file was cut short</source>
        <translation>ENDDAT ontbreekt: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>G-code with B and C (a table that tilts and turns)</source>
        <translation>G-code met B en C (een tafel die kantelt en draait)</translation>
    </message>
    <message>
        <source>G-code with B and C: X distance of the plate&apos;s centre from the tilt axis.</source>
        <translation>G-code met B en C: X-afstand van het midden van de plaat tot de kantelas.</translation>
    </message>
    <message>
        <source>G-code with B and C: height of the plate&apos;s top above the tilt axis.</source>
        <translation>G-code met B en C: hoogte van de bovenkant van de plaat boven de kantelas.</translation>
    </message>
    <message>
        <source>G-code with B and C: whether B and C are the right-handed rotation of the part, or that of the tool around a fixed part.</source>
        <translation>G-code met B en C: of B en C de rechtshandige rotatie van het onderdeel zijn, of die van het gereedschap rond een vast onderdeel.</translation>
    </message>
    <message>
        <source>Joint speeds are in percent: 100 % is assumed to be 180 degrees/s, so the times of these travels are estimates.</source>
        <translation>Gewrichtssnelheden zijn in procenten: 100 % wordt als 180 graden/s opgevat, dus de tijden van deze verplaatsingen zijn schattingen.</translation>
    </message>
    <message>
        <source>Joints accelerate at {acceleration:.0f}/s2 unless the program states otherwise.</source>
        <translation>Gewrichten versnellen met {acceleration:.0f}/s2 tenzij het programma anders aangeeft.</translation>
    </message>
    <message>
        <source>KRL (KUKA)</source>
        <translation>KRL (KUKA)</translation>
    </message>
    <message>
        <source>KRL memory</source>
        <translation>KRL-geheugen</translation>
    </message>
    <message>
        <source>MELFA-BASIC V (Mitsubishi)</source>
        <translation>MELFA-BASIC V (Mitsubishi)</translation>
    </message>
    <message>
        <source>Programmed accelerations are used; where none is given, motion starts instantly.</source>
        <translation>Geprogrammeerde versnellingen worden gebruikt; waar er geen is opgegeven, start de beweging onmiddellijk.</translation>
    </message>
    <message>
        <source>No motion is shorter than the controller&apos;s cycle of {cycle} ms.</source>
        <translation>Geen beweging is korter dan de cyclus van de besturing van {cycle} ms.</translation>
    </message>
    <message>
        <source>Not tested on a machine: start slowly, with a cold extruder.</source>
        <translation>Niet op een machine getest: begin langzaam, met koude extruder.</translation>
    </message>
    <message>
        <source>Plain G-code (three axes, flat jobs)</source>
        <translation>Gewone G-code (drie assen, vlakke opdrachten)</translation>
    </message>
    <message>
        <source>Points of a bead closer than {time} ms or {way} are merged if the bead stays the same.</source>
        <translation>Punten van een streng die dichter dan {time} ms of {way} bij elkaar liggen worden samengevoegd als de streng gelijk blijft.</translation>
    </message>
    <message>
        <source>Power Low limits the speed: Power High is missing</source>
        <translation>Power Low begrenst de snelheid: Power High ontbreekt</translation>
    </message>
    <message>
        <source>ROT, but the tool does not turn</source>
        <translation>ROT, maar het gereedschap draait niet</translation>
    </message>
    <message>
        <source>Program memory of the controller. Longer programs contain a note in their header.</source>
        <translation>Programmageheugen van de besturing. Langere programma&apos;s bevatten een opmerking in de kop.</translation>
    </message>
    <message>
        <source>SPEL+ (Epson)</source>
        <translation>SPEL+ (Epson)</translation>
    </message>
    <message>
        <source>ScriptExit() is missing at the end</source>
        <translation>ScriptExit() ontbreekt aan het einde</translation>
    </message>
    <message>
        <source>Straight motions accelerate at {acceleration} mm/s2 unless the program states otherwise.</source>
        <translation>Rechte bewegingen versnellen met {acceleration} mm/s2 tenzij het programma anders aangeeft.</translation>
    </message>
    <message>
        <source>TMscript (Techman)</source>
        <translation>TMscript (Techman)</translation>
    </message>
    <message>
        <source>The arm stops at points without a blend.</source>
        <translation>De arm stopt bij punten zonder afronding.</translation>
    </message>
    <message>
        <source>Unlimited look-ahead.</source>
        <translation>Onbeperkte look-ahead.</translation>
    </message>
    <message>
        <source>Look-ahead of {motions} motions.</source>
        <translation>Look-ahead van {motions} bewegingen.</translation>
    </message>
    <message>
        <source>Output delays and following error are not modelled.</source>
        <translation>Vertragingen van uitgangen en volgfouten worden niet gemodelleerd.</translation>
    </message>
    <message>
        <source>Tool rotation may be limited separately (1 rad = {way:.0f} of path); the slower of the two sets the flow.</source>
        <translation>Gereedschapsrotatie kan apart worden begrensd (1 rad = {way:.0f} van de baan); de langzaamste van de twee bepaalt de doorvoer.</translation>
    </message>
    <message>
        <source>WAIT SEC needs a number of seconds</source>
        <translation>WAIT SEC vereist een aantal seconden</translation>
    </message>
    <message>
        <source>Wait needs a number of seconds</source>
        <translation>Wait vereist een aantal seconden</translation>
    </message>
    <message>
        <source>a G0 under G93 has no defined time</source>
        <translation>een G0 onder G93 heeft geen gedefinieerde tijd</translation>
    </message>
    <message>
        <source>unsupported base: positions must be in the robot&apos;s own base</source>
        <translation>niet-ondersteunde basis: posities moeten in de eigen basis van de robot staan</translation>
    </message>
    <message>
        <source>a base known only to the robot: give its numbers</source>
        <translation>een basis die alleen de robot kent: geef de getallen ervan op</translation>
    </message>
    <message>
        <source>a blend is no sensible number</source>
        <translation>een afronding is geen zinvol getal</translation>
    </message>
    <message>
        <source>unsupported call of another program</source>
        <translation>niet-ondersteunde aanroep van een ander programma</translation>
    </message>
    <message>
        <source>a coordinate is missing, and the arm&apos;s position is not known</source>
        <translation>een coördinaat ontbreekt, en de positie van de arm is niet bekend</translation>
    </message>
    <message>
        <source>the flow is not an integer from 0 to {most}</source>
        <translation>de doorvoer is geen geheel getal van 0 tot {most}</translation>
    </message>
    <message>
        <source>the frame&apos;s length differs from the stated one</source>
        <translation>de lengte van het frame verschilt van de opgegeven lengte</translation>
    </message>
    <message>
        <source>the frame is not a script for a listen node</source>
        <translation>het frame is geen script voor een listen-node</translation>
    </message>
    <message>
        <source>wrong checksum: the frame was modified or truncated</source>
        <translation>verkeerde controlesom: het frame is gewijzigd of afgekapt</translation>
    </message>
    <message>
        <source>frame without a length</source>
        <translation>frame zonder lengte</translation>
    </message>
    <message>
        <source>frame without a name</source>
        <translation>frame zonder naam</translation>
    </message>
    <message>
        <source>load without a mass</source>
        <translation>last zonder massa</translation>
    </message>
    <message>
        <source>a mass is no sensible number</source>
        <translation>een massa is geen zinvol getal</translation>
    </message>
    <message>
        <source>another motion between PVTEnter and PVTExit</source>
        <translation>een andere beweging tussen PVTEnter en PVTExit</translation>
    </message>
    <message>
        <source>a pure rotation needs ROT</source>
        <translation>een zuivere rotatie vereist ROT</translation>
    </message>
    <message>
        <source>a motion without F: under G93 each motion needs its own</source>
        <translation>een beweging zonder F: onder G93 heeft elke beweging een eigen F nodig</translation>
    </message>
    <message>
        <source>a motion without G93: its F is not a time</source>
        <translation>een beweging zonder G93: de F ervan is geen tijd</translation>
    </message>
    <message>
        <source>the numbers of the motion do not match its letters</source>
        <translation>de getallen van de beweging passen niet bij de letters</translation>
    </message>
    <message>
        <source>a pose before ChangeTCP: its TCP is unknown</source>
        <translation>een pose vóór ChangeTCP: de TCP is onbekend</translation>
    </message>
    <message>
        <source>a position before Tool: its TCP is unknown</source>
        <translation>een positie vóór Tool: de TCP is onbekend</translation>
    </message>
    <message>
        <source>step longer than 127 characters</source>
        <translation>stap langer dan 127 tekens</translation>
    </message>
    <message>
        <source>a straight motion before any Spd</source>
        <translation>een rechte beweging vóór een Spd</translation>
    </message>
    <message>
        <source>a straight motion in percent of an unknown speed</source>
        <translation>een rechte beweging in procenten van een onbekende snelheid</translation>
    </message>
    <message>
        <source>a straight motion to joints</source>
        <translation>een rechte beweging naar gewrichtswaarden</translation>
    </message>
    <message>
        <source>the target is not a position within a robot&apos;s reach</source>
        <translation>het doel is geen positie binnen het bereik van een robot</translation>
    </message>
    <message>
        <source>a text has {characters} characters; the controller accepts at most {most}</source>
        <translation>een tekst heeft {characters} tekens; de besturing accepteert er hoogstens {most}</translation>
    </message>
    <message>
        <source>a tool is a position</source>
        <translation>een gereedschap is een positie</translation>
    </message>
    <message>
        <source>a tool known only to the robot: give its numbers</source>
        <translation>een gereedschap dat alleen de robot kent: geef de getallen ervan op</translation>
    </message>
    <message>
        <source>a tool, local or control point that only the controller knows</source>
        <translation>een tool, local of control point dat alleen de besturing kent</translation>
    </message>
    <message>
        <source>accelerations other than the arm&apos;s own</source>
        <translation>andere versnellingen dan die van de arm zelf</translation>
    </message>
    <message>
        <source>an acceleration is no sensible number</source>
        <translation>een versnelling is geen zinvol getal</translation>
    </message>
    <message>
        <source>an analogue output outside 0 to 10 V</source>
        <translation>een analoge uitgang buiten 0 tot 10 V</translation>
    </message>
    <message>
        <source>an angle rotates the long way around</source>
        <translation>een hoek draait de lange weg om</translation>
    </message>
    <message>
        <source>an immediate output, not synchronized with the motions</source>
        <translation>een directe uitgang, niet gesynchroniseerd met de bewegingen</translation>
    </message>
    <message>
        <source>an output after CONTINUE runs ahead of the arm</source>
        <translation>een uitgang na CONTINUE loopt vóór op de arm</translation>
    </message>
    <message>
        <source>an output is 0 or 1</source>
        <translation>een uitgang is 0 of 1</translation>
    </message>
    <message>
        <source>an output of the extruder is set together with other outputs</source>
        <translation>een uitgang van de extruder wordt samen met andere uitgangen ingesteld</translation>
    </message>
    <message>
        <source>axes cannot be the target of a straight motion</source>
        <translation>assen kunnen niet het doel van een rechte beweging zijn</translation>
    </message>
    <message>
        <source>format {format} cannot tilt the nozzle, but this job tilts it by {angle}</source>
        <translation>formaat {format} kan de nozzle niet kantelen, maar deze opdracht kantelt hem {angle}</translation>
    </message>
    <message>
        <source>how &apos;{word}&apos; rounds a corner is not known to the reader</source>
        <translation>hoe &apos;{word}&apos; een hoek afrondt is onbekend voor de lezer</translation>
    </message>
    <message>
        <source>joints of a straight motion may be reached in another posture</source>
        <translation>gewrichten van een rechte beweging kunnen in een andere houding worden bereikt</translation>
    </message>
    <message>
        <source>omit it, or give --format {format}</source>
        <translation>laat het weg, of geef --format {format} op</translation>
    </message>
    <message>
        <source>lines end with LF only: a listen node needs CR LF</source>
        <translation>regels eindigen alleen met LF: een listen-node vereist CR LF</translation>
    </message>
    <message>
        <source>material before X, Y and Z are all known</source>
        <translation>materiaal voordat X, Y en Z allemaal bekend zijn</translation>
    </message>
    <message>
        <source>material before X, Y, Z, B and C are all known</source>
        <translation>materiaal voordat X, Y, Z, B en C allemaal bekend zijn</translation>
    </message>
    <message>
        <source>must be 1 or -1</source>
        <translation>moet 1 of -1 zijn</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>moet true of false zijn</translation>
    </message>
    <message>
        <source>no {format} motion found: line {line}: {what}</source>
        <translation>geen {format}-beweging gevonden: regel {line}: {what}</translation>
    </message>
    <message>
        <source>no procedure is defined</source>
        <translation>er is geen procedure gedefinieerd</translation>
    </message>
    <message>
        <source>no program calls this file</source>
        <translation>geen programma roept dit bestand aan</translation>
    </message>
    <message>
        <source>not all axes are given</source>
        <translation>niet alle assen zijn opgegeven</translation>
    </message>
    <message>
        <source>invalid plate position relative to the tilt axis</source>
        <translation>ongeldige plaatpositie ten opzichte van de kantelas</translation>
    </message>
    <message>
        <source>end without a matching beginning</source>
        <translation>einde zonder bijbehorend begin</translation>
    </message>
    <message>
        <source>no procedure of this file is called</source>
        <translation>geen procedure van dit bestand wordt aangeroepen</translation>
    </message>
    <message>
        <source>only triggers at the start of a motion are supported</source>
        <translation>alleen triggers aan het begin van een beweging worden ondersteund</translation>
    </message>
    <message>
        <source>only the persistent forms of output commands are supported</source>
        <translation>alleen de blijvende vormen van uitgangscommando&apos;s worden ondersteund</translation>
    </message>
    <message>
        <source>the work coordinates change: only one nozzle is supported</source>
        <translation>de werkcoördinaten veranderen: er wordt slechts één nozzle ondersteund</translation>
    </message>
    <message>
        <source>part {part}, job {job}, cell {cell} with robot {robot}</source>
        <translation>onderdeel {part}, opdracht {job}, cel {cell} met robot {robot}</translation>
    </message>
    <message>
        <source>plate height above the tilt axis</source>
        <translation>plaathoogte boven de kantelas</translation>
    </message>
    <message>
        <source>plate offset from the tilt axis</source>
        <translation>plaatafstand tot de kantelas</translation>
    </message>
    <message>
        <source>speed, acceleration time and blend must be integers</source>
        <translation>snelheid, versnellingstijd en afronding moeten gehele getallen zijn</translation>
    </message>
    <message>
        <source>step numbers must ascend, up to 32767</source>
        <translation>stapnummers moeten oplopen, tot 32767</translation>
    </message>
    <message>
        <source>either the tool&apos;s path or that of the external control point is straight, not both</source>
        <translation>de baan van het gereedschap of die van het externe control point is recht, niet beide</translation>
    </message>
    <message>
        <source>table angles describe</source>
        <translation>tafelhoeken beschrijven</translation>
    </message>
    <message>
        <source>use {formats}, or a mode with flat layers</source>
        <translation>gebruik {formats}, of een modus met vlakke lagen</translation>
    </message>
    <message>
        <source>text after a frame</source>
        <translation>tekst na een frame</translation>
    </message>
    <message>
        <source>the velocity at the last PVT point is not 0</source>
        <translation>de snelheid bij het laatste PVT-punt is niet 0</translation>
    </message>
    <message>
        <source>the line has {characters} characters; the controller accepts at most {most}</source>
        <translation>de regel heeft {characters} tekens; de besturing accepteert er hoogstens {most}</translation>
    </message>
    <message>
        <source>&apos;Type&apos; other than 0,0: the long way around, or independent rotation of the angles</source>
        <translation>&apos;Type&apos; anders dan 0,0: de lange weg om, of onafhankelijke rotatie van de hoeken</translation>
    </message>
    <message>
        <source>X or Y motion before B and C are known</source>
        <translation>X- of Y-beweging voordat B en C bekend zijn</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>het onderdeel</translation>
    </message>
    <message>
        <source>the procedure has no end</source>
        <translation>de procedure heeft geen einde</translation>
    </message>
    <message>
        <source>the program has no End</source>
        <translation>het programma heeft geen End</translation>
    </message>
    <message>
        <source>the program is for another cell: {program}; this job is {job}</source>
        <translation>het programma is voor een andere cel: {program}; deze opdracht is {job}</translation>
    </message>
    <message>
        <source>the program is from another job: {program}; this job is {job}</source>
        <translation>het programma is van een andere opdracht: {program}; deze opdracht is {job}</translation>
    </message>
    <message>
        <source>the called program {name} is missing</source>
        <translation>het aangeroepen programma {name} ontbreekt</translation>
    </message>
    <message>
        <source>table motion before Z is known: the nozzle may be down</source>
        <translation>tafelbeweging voordat Z bekend is: de nozzle kan laag staan</translation>
    </message>
    <message>
        <source>the tool (ISO 841)</source>
        <translation>het gereedschap (ISO 841)</translation>
    </message>
    <message>
        <source>the tool does not turn evenly along its way</source>
        <translation>het gereedschap draait niet gelijkmatig langs zijn weg</translation>
    </message>
    <message>
        <source>the velocities lead off the path to this point</source>
        <translation>de snelheden leiden van de baan naar dit punt af</translation>
    </message>
    <message>
        <source>work coordinates that P_WkCord does not set</source>
        <translation>werkcoördinaten die P_WkCord niet instelt</translation>
    </message>
    <message>
        <source>{frame} is not set before this motion</source>
        <translation>{frame} is niet vóór deze beweging ingesteld</translation>
    </message>
    <message>
        <source>{option} applies to {having}, but the chosen formats are {formats}</source>
        <translation>{option} geldt voor {having}, maar de gekozen formaten zijn {formats}</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is missing</source>
        <translation>&apos;{attribute}&apos; ontbreekt</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; must be three numbers: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; moet uit drie getallen bestaan: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>expand it first: xacro FILE &gt; arm.urdf</source>
        <translation>expandeer het eerst: xacro FILE &gt; arm.urdf</translation>
    </message>
    <message>
        <source>the chain from &apos;{base}&apos; to &apos;{tip}&apos; has {count} turning axes; six are needed</source>
        <translation>de keten van &apos;{base}&apos; naar &apos;{tip}&apos; heeft {count} draaiende assen; er zijn er zes nodig</translation>
    </message>
    <message>
        <source>choose another home pose for the cell; if only the enclosing shapes of two links overlap, list the pair under neverMeet in the robot&apos;s file</source>
        <translation>kies een andere uitgangspose voor de cel; als alleen de omhullende vormen van twee schakels overlappen, vermeld het paar dan onder neverMeet in het bestand van de robot</translation>
    </message>
    <message>
        <source>has no links</source>
        <translation>heeft geen schakels</translation>
    </message>
    <message>
        <source>has no tip: no joint moves</source>
        <translation>heeft geen uiteinde: geen enkel gewricht beweegt</translation>
    </message>
    <message>
        <source>has several tips: {names}</source>
        <translation>heeft meerdere uiteinden: {names}</translation>
    </message>
    <message>
        <source>has two bases, &apos;{first}&apos; and &apos;{second}&apos;: no joint leads from one to the other</source>
        <translation>heeft twee bases, &apos;{first}&apos; en &apos;{second}&apos;: geen gewricht leidt van de ene naar de andere</translation>
    </message>
    <message>
        <source>is a xacro file</source>
        <translation>is een xacro-bestand</translation>
    </message>
    <message>
        <source>is not a URDF: it begins with &lt;{element}&gt;</source>
        <translation>is geen URDF: het begint met &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; mimics &apos;{other}&apos;: mimic joints are not supported</source>
        <translation>gewricht &apos;{joint}&apos; volgt &apos;{other}&apos; via mimic: mimic-gewrichten worden niet ondersteund</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an axis of zero length</source>
        <translation>gewricht &apos;{joint}&apos; heeft een as met lengte nul</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the lower limit is not below the upper one</source>
        <translation>gewricht &apos;{joint}&apos;: de ondergrens ligt niet onder de bovengrens</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an unknown type: &apos;{type}&apos;</source>
        <translation>gewricht &apos;{joint}&apos; heeft een onbekend type: &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; is {type}; only turning joints are supported</source>
        <translation>gewricht &apos;{joint}&apos; is {type}; alleen draaiende gewrichten worden ondersteund</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; names an unknown link: &apos;{link}&apos;</source>
        <translation>gewricht &apos;{joint}&apos; noemt een onbekende schakel: &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; has two parent joints, &apos;{first}&apos; and &apos;{second}&apos;: loops are not supported</source>
        <translation>schakel &apos;{link}&apos; heeft twee bovenliggende gewrichten, &apos;{first}&apos; en &apos;{second}&apos;: lussen worden niet ondersteund</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; is part of a loop: loops are not supported</source>
        <translation>schakel &apos;{link}&apos; is deel van een lus: lussen worden niet ondersteund</translation>
    </message>
    <message>
        <source>name one: --tip</source>
        <translation>noem er een: --tip</translation>
    </message>
    <message>
        <source>name the first and last link of the chain: --base, --tip</source>
        <translation>noem de eerste en laatste schakel van de keten: --base, --tip</translation>
    </message>
    <message>
        <source>the base &apos;{base}&apos; is on a moving branch off the chain to &apos;{tip}&apos;</source>
        <translation>de basis &apos;{base}&apos; ligt op een bewegende tak buiten de keten naar &apos;{tip}&apos;</translation>
    </message>
    <message>
        <source>two links are named &apos;{link}&apos;</source>
        <translation>twee schakels heten &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the home pose: no motion is possible</source>
        <translation>{first} botst met {second} in de uitgangspose: er is geen beweging mogelijk</translation>
    </message>
    <message>
        <source>{option}: no link is named &apos;{name}&apos;</source>
        <translation>{option}: geen schakel heet &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>In a PolyScope file node the function must be called after its end. Text sent to port 30001 or 30002 runs by itself and must not call it.</source>
        <translation>In een File-node van PolyScope moet de functie na haar einde worden aangeroepen. Tekst die naar poort 30001 of 30002 wordt gestuurd start vanzelf en mag haar niet aanroepen.</translation>
    </message>
    <message>
        <source>a file node</source>
        <translation>een File-node</translation>
    </message>
    <message>
        <source>a port</source>
        <translation>een poort</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an extruder command</source>
        <translation>&apos;{text}&apos; is geen extrudercommando</translation>
    </message>
    <message>
        <source>Like an ordinary printer, with the nozzle upright</source>
        <translation>Als een gewone printer, met de nozzle rechtop</translation>
    </message>
    <message>
        <source>Filament retracted for each travel, if the extruder can; 0: none.</source>
        <translation>Filament dat bij elke verplaatsing wordt ingetrokken, als de extruder dat kan; 0: niets.</translation>
    </message>
    <message>
        <source>Fills the nozzle before the part begins: on the plate, or in the air beside it if there is no room. The material is waste.</source>
        <translation>Vult de nozzle voordat het onderdeel begint: op de plaat, of ernaast in de lucht als er geen ruimte is. Het materiaal is afval.</translation>
    </message>
    <message>
        <source>Length of the line beside the part.</source>
        <translation>Lengte van de lijn naast het onderdeel.</translation>
    </message>
    <message>
        <source>Print in flat layers</source>
        <translation>In vlakke lagen printen</translation>
    </message>
    <message>
        <source>the filament diameter is out of range</source>
        <translation>de filamentdiameter ligt buiten het bereik</translation>
    </message>
    <message>
        <source>a line beside the part</source>
        <translation>een lijn naast het onderdeel</translation>
    </message>
    <message>
        <source>a motion is missing or repeated in the filament stream</source>
        <translation>in de filamentstroom ontbreekt een beweging of is er een herhaald</translation>
    </message>
    <message>
        <source>a ring around the part</source>
        <translation>een ring rondom het onderdeel</translation>
    </message>
    <message>
        <source>a text to be sent is needed</source>
        <translation>er is een te verzenden tekst nodig</translation>
    </message>
    <message>
        <source>an external axis after an unused one is not supported</source>
        <translation>een externe as na een ongebruikte wordt niet ondersteund</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>extruder</translation>
    </message>
    <message>
        <source>retraction</source>
        <translation>intrekken</translation>
    </message>
    <message>
        <source>the filament position decreases</source>
        <translation>de filamentpositie neemt af</translation>
    </message>
    <message>
        <source>format {format} cannot control extruder {extruder} in step with the motion</source>
        <translation>formaat {format} kan extruder {extruder} niet synchroon met de beweging aansturen</translation>
    </message>
    <message>
        <source>has a name that is already used: &apos;{name}&apos;</source>
        <translation>heeft een naam die al wordt gebruikt: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>must have minMm below maxMm</source>
        <translation>minMm moet kleiner zijn dan maxMm</translation>
    </message>
    <message>
        <source>first-layer bead width</source>
        <translation>strengbreedte van de eerste laag</translation>
    </message>
    <message>
        <source>Nominal bead width of the first layer and the brim; limited by the process. 0: that of the process.</source>
        <translation>Nominale strengbreedte van de eerste laag en de brim; begrensd door het proces. 0: die van het proces.</translation>
    </message>
    <message>
        <source>outer-wall speed</source>
        <translation>snelheid buitenwand</translation>
    </message>
    <message>
        <source>Speed of the outermost walls. 0: that of the process.</source>
        <translation>Snelheid van de buitenste wanden. 0: die van het proces.</translation>
    </message>
    <message>
        <source>inner-wall speed</source>
        <translation>snelheid binnenwand</translation>
    </message>
    <message>
        <source>Speed of all other walls. 0: that of the process.</source>
        <translation>Snelheid van alle andere wanden. 0: die van het proces.</translation>
    </message>
    <message>
        <source>infill speed</source>
        <translation>snelheid vulling</translation>
    </message>
    <message>
        <source>Speed of solid infill and gap fill, limited by the extruder&apos;s flow. 0: that of the process.</source>
        <translation>Snelheid van dichte vulling en spleetvulling, begrensd door de doorvoer van de extruder. 0: die van het proces.</translation>
    </message>
    <message>
        <source>support speed</source>
        <translation>snelheid ondersteuning</translation>
    </message>
    <message>
        <source>Speed of supports. 0: that of the process.</source>
        <translation>Snelheid van ondersteuning. 0: die van het proces.</translation>
    </message>
    <message>
        <source>first-layer speed</source>
        <translation>snelheid eerste laag</translation>
    </message>
    <message>
        <source>Speed of all beads of the first layer and of the brim. 0: that of the process.</source>
        <translation>Snelheid van alle strengen van de eerste laag en van de brim. 0: die van het proces.</translation>
    </message>
    <message>
        <source>brim width</source>
        <translation>brimbreedte</translation>
    </message>
    <message>
        <source>Width of the loops on the plate around the first layer, which keep it from lifting; break them off after printing. 0: no brim.</source>
        <translation>Breedte van de lussen op de plaat rond de eerste laag, die voorkomen dat ze loskomt; breek ze na het printen af. 0: geen brim.</translation>
    </message>
    <message>
        <source>no room on the plate for the whole brim, {width} wide: {share:.0f} of its length is left out</source>
        <translation>geen ruimte op de plaat voor de hele brim van {width} breed: {share:.0f} van de lengte wordt weggelaten</translation>
    </message>
    <message>
        <source>use a larger plate (`--platform`), move the part to the middle, or set a smaller `brimWidthMm`</source>
        <translation>gebruik een grotere plaat (`--platform`), verplaats het onderdeel naar het midden, of stel een kleinere `brimWidthMm` in</translation>
    </message>
    <message>
        <source>must be between {least} and {most}</source>
        <translation>moet tussen {least} en {most} liggen</translation>
    </message>
    <message>
        <source>where the travel is shortest</source>
        <translation>waar de verplaatsing het kortst is</translation>
    </message>
    <message>
        <source>aligned from layer to layer</source>
        <translation>van laag tot laag uitgelijnd</translation>
    </message>
    <message>
        <source>in a corner</source>
        <translation>in een hoek</translation>
    </message>
    <message>
        <source>spread over the part</source>
        <translation>over het onderdeel verspreid</translation>
    </message>
    <message>
        <source>unknown seam &apos;{id}&apos;</source>
        <translation>onbekende naad &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>naad</translation>
    </message>
    <message>
        <source>Where closed walls begin and end. A seam aligned or in a corner is less visible; spread seams weaken the part least.</source>
        <translation>Waar gesloten wanden beginnen en eindigen. Een uitgelijnde naad of een naad in een hoek is minder zichtbaar; verspreide naden verzwakken het onderdeel het minst.</translation>
    </message>
    <message>
        <source>shortest travel</source>
        <translation>kortste verplaatsing</translation>
    </message>
    <message>
        <source>as sliced</source>
        <translation>zoals geslicet</translation>
    </message>
    <message>
        <source>order of islands</source>
        <translation>volgorde van eilanden</translation>
    </message>
    <message>
        <source>Order in which separate islands of a flat layer are printed.</source>
        <translation>Volgorde waarin losse eilanden van een vlakke laag worden geprint.</translation>
    </message>
    <message>
        <source>Prints the part as one continuous bead of rising height on its bottom layers: one wall, without infill, top layers and supports under low overhangs.</source>
        <translation>Print het onderdeel als één doorlopende streng van toenemende hoogte op de bodemlagen: één wand, zonder vulling, toplagen en ondersteuning onder lage overhangen.</translation>
    </message>
    <message>
        <source>spiral vase</source>
        <translation>spiraalvaas</translation>
    </message>
    <message>
        <source>prime length</source>
        <translation>primelengte</translation>
    </message>
    <message>
        <source>must be empty: the plate is on the flange</source>
        <translation>moet leeg zijn: de plaat zit op de flens</translation>
    </message>
    <message>
        <source>too many: robot and external axes together may have {most} axes</source>
        <translation>te veel: robot en externe assen samen mogen {most} assen hebben</translation>
    </message>
    <message>
        <source>must be turning or sliding, is &apos;{kind}&apos;</source>
        <translation>moet turning of sliding zijn, is &apos;{kind}&apos;</translation>
    </message>
    <message>
        <source>must not be zero</source>
        <translation>mag niet nul zijn</translation>
    </message>
    <message>
        <source>must turn the rod about its own axis, the work frame&apos;s x</source>
        <translation>moet de staaf om zijn eigen as draaien, de x van het werkassenstelsel</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>primen</translation>
    </message>
    <message>
        <source>use extruder {extruders}</source>
        <translation>gebruik extruder {extruders}</translation>
    </message>
    <message>
        <source>the extruder is switched on or off where that is not possible</source>
        <translation>de extruder wordt in- of uitgeschakeld waar dat niet mogelijk is</translation>
    </message>
    <message>
        <source>the extruder reverses while the nozzle moves</source>
        <translation>de extruder keert om terwijl de nozzle beweegt</translation>
    </message>
    <message>
        <source>the extruder runs where the program does not pause</source>
        <translation>de extruder loopt waar het programma niet pauzeert</translation>
    </message>
    <message>
        <source>the extruder runs where the program has switched it off</source>
        <translation>de extruder loopt waar het programma hem heeft uitgeschakeld</translation>
    </message>
    <message>
        <source>the retracted filament is not returned before the bead</source>
        <translation>het ingetrokken filament is vóór de streng niet teruggevoerd</translation>
    </message>
    <message>
        <source>the file {file} begins with {procedure}: a module must have the name of its first procedure</source>
        <translation>het bestand {file} begint met {procedure}: een module moet de naam van zijn eerste procedure hebben</translation>
    </message>
    <message>
        <source>the filament stream has no end: the file is truncated</source>
        <translation>de filamentstroom heeft geen einde: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>the filament stream has no entry for this motion</source>
        <translation>de filamentstroom heeft geen regel voor deze beweging</translation>
    </message>
    <message>
        <source>this arm keeps the nozzle upright, but the layers need it tilted, first at {place}</source>
        <translation>deze arm houdt de nozzle rechtop, maar voor de lagen moet hij kantelen, voor het eerst bij {place}</translation>
    </message>
    <message>
        <source>time decreases in the filament stream</source>
        <translation>de tijd loopt terug in de filamentstroom</translation>
    </message>
    <message>
        <source>unknown extruder &apos;{id}&apos;</source>
        <translation>onbekende extruder &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>use mode flat, or planar with upright layers</source>
        <translation>gebruik bouwwijze vlakke lagen, of vlakke delen met rechtopstaande lagen</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}/s, above its limit of {limit:.1f#}</source>
        <translation>{joint} met {speed:.1f}/s, boven zijn grens van {limit:.1f#}</translation>
    </message>
    <message>
        <source>Castelli serial</source>
        <translation>Castelli serieel</translation>
    </message>
    <message>
        <source>E stream</source>
        <translation>E-stroom</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>uitgangen</translation>
    </message>
    <message>
        <source>the cell&apos;s</source>
        <translation>van de cel</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is NaN or out of range: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; is NaN of buiten bereik: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is a built-in cell</source>
        <translation>&apos;{id}&apos; is een ingebouwde cel</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is not a valid cell name</source>
        <translation>&apos;{id}&apos; is geen geldige celnaam</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a number</source>
        <translation>&apos;{word}&apos; is geen getal</translation>
    </message>
    <message>
        <source>How rotations about the nozzle are smoothed: quickly, or by a search for minimum joint jerk, which doubles the planning time of the motion.</source>
        <translation>Hoe draaiingen om de nozzle worden afgevlakt: snel, of door te zoeken naar de kleinste gewrichtsruk, wat de plantijd van de beweging verdubbelt.</translation>
    </message>
    <message>
        <source>Reached poses</source>
        <translation>Bereikte poses</translation>
    </message>
    <message>
        <source>a frame needs at least three points</source>
        <translation>een assenstelsel heeft minstens drie punten nodig</translation>
    </message>
    <message>
        <source>a measured number is not finite</source>
        <translation>een gemeten getal is niet eindig</translation>
    </message>
    <message>
        <source>a quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>de lengte van een quaternion is {length:.4g}, niet 1</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is the name of a built-in robot</source>
        <translation>&apos;{id}&apos; is de naam van een ingebouwde robot</translation>
    </message>
    <message>
        <source>a row contains the robot&apos;s joints</source>
        <translation>een rij bevat de gewrichten van de robot</translation>
    </message>
    <message>
        <source>a row contains x,y,z,qw,qx,qy,qz; for joints name the robot</source>
        <translation>een rij bevat x,y,z,qw,qx,qy,qz; noem voor gewrichten de robot</translation>
    </message>
    <message>
        <source>a tool tip needs at least four poses</source>
        <translation>een gereedschapspunt heeft minstens vier poses nodig</translation>
    </message>
    <message>
        <source>in the home pose {first} collides with {second}</source>
        <translation>in de uitgangspose botst {first} met {second}</translation>
    </message>
    <message>
        <source>bring plate and nozzle nearer to the arm</source>
        <translation>breng plaat en nozzle dichter bij de arm</translation>
    </message>
    <message>
        <source>cannot be read: not a mesh, or damaged</source>
        <translation>kan niet worden gelezen: geen mesh, of beschadigd</translation>
    </message>
    <message>
        <source>cannot be read: voluta-mesh-reader is missing beside this program</source>
        <translation>kan niet worden gelezen: voluta-mesh-reader ontbreekt naast dit programma</translation>
    </message>
    <message>
        <source>cell {cell} has no plate to map</source>
        <translation>cel {cell} heeft geen plaat om in kaart te brengen</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>afgevlakt</translation>
    </message>
    <message>
        <source>give the arm another name: --id</source>
        <translation>geef de arm een andere naam: --id</translation>
    </message>
    <message>
        <source>give three rows x,y,z (origin, point on x, point in the xy plane), or at least three rows of six: nominal point in the frame, touched point</source>
        <translation>geef drie rijen x,y,z (oorsprong, punt op x, punt in het xy-vlak), of minstens drie rijen van zes: nominaal punt in het assenstelsel, aangeraakt punt</translation>
    </message>
    <message>
        <source>is damaged: the reader failed</source>
        <translation>is beschadigd: de lezer is mislukt</translation>
    </message>
    <message>
        <source>minimum jerk of whole paths</source>
        <translation>kleinste ruk van hele banen</translation>
    </message>
    <message>
        <source>jerk of joint {joint} at its greatest here: {jerk:.3g} rad/s³, limit {limit:.3g} rad/s³</source>
        <translation>de ruk van gewricht {joint} is hier het grootst: {jerk:.3g} rad/s³, grens {limit:.3g} rad/s³</translation>
    </message>
    <message>
        <source>smooth whole paths (`rotationSmoothing=wholePath`), print slower, or allow more jerk (`maxJerk`)</source>
        <translation>vlak hele banen af (`rotationSmoothing=wholePath`), print langzamer, of sta meer ruk toe (`maxJerk`)</translation>
    </message>
    <message>
        <source>maximum jerk</source>
        <translation>maximale ruk</translation>
    </message>
    <message>
        <source>Maximum jerk of every joint; for a sliding joint 100 mm count as 1 rad. The robot moves more slowly where a joint would exceed it, and speeds up and slows down more gently. 0: no limit.</source>
        <translation>Maximale ruk van elk gewricht; bij een schuifgewricht tellen 100 mm als 1 rad. De robot beweegt langzamer waar een gewricht erboven zou komen, en versnelt en remt geleidelijker. 0: geen grens.</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>vormen</translation>
    </message>
    <message>
        <source>shapes, and a learned indicator</source>
        <translation>vormen, en een geleerde indicator</translation>
    </message>
    <message>
        <source>collision model</source>
        <translation>botsingsmodel</translation>
    </message>
    <message>
        <source>How a search for minimum joint jerk of whole paths avoids collisions: by checks of the shapes afterwards, or also by the gradient of an indicator that is learned for each layer (for research; slow). The shapes decide in both cases.</source>
        <translation>Hoe het zoeken naar de kleinste gewrichtsruk van hele banen botsingen vermijdt: door de vormen achteraf te controleren, of ook via de gradiënt van een indicator die per laag wordt geleerd (voor onderzoek; traag). In beide gevallen beslissen de vormen.</translation>
    </message>
    <message>
        <source>with the nozzle lifted</source>
        <translation>met opgeheven nozzle</translation>
    </message>
    <message>
        <source>while printing, if possible</source>
        <translation>tijdens het printen, indien mogelijk</translation>
    </message>
    <message>
        <source>change of the arm&apos;s branch</source>
        <translation>wissel van de tak van de arm</translation>
    </message>
    <message>
        <source>Where the arm cannot print a whole path in one branch: whether the path is interrupted there, or the wrist changes over several points while printing, with the nozzle tilted within the tilt tolerance.</source>
        <translation>Waar de arm een hele baan niet in één tak kan printen: of de baan daar wordt onderbroken, of dat de pols tijdens het printen over meerdere punten wisselt, met de nozzle gekanteld binnen de kanteltolerantie.</translation>
    </message>
    <message>
        <source>remove the row, or measure it again</source>
        <translation>verwijder de rij, of meet haar opnieuw</translation>
    </message>
    <message>
        <source>lengths in a URDF are metres</source>
        <translation>lengtes in een URDF zijn meters</translation>
    </message>
    <message>
        <source>check the limits and solids in the description, or name its links: --base, --tip</source>
        <translation>controleer de grenzen en lichamen in de beschrijving, of noem de schakels ervan: --base, --tip</translation>
    </message>
    <message>
        <source>reduce the payload, or use a stronger robot</source>
        <translation>verklein de last, of gebruik een sterkere robot</translation>
    </message>
    <message>
        <source>measure another point</source>
        <translation>meet een ander punt</translation>
    </message>
    <message>
        <source>measure another pose</source>
        <translation>meet een andere pose</translation>
    </message>
    <message>
        <source>measure three points</source>
        <translation>meet drie punten</translation>
    </message>
    <message>
        <source>move one of them, or choose another home pose</source>
        <translation>verplaats een van beide, of kies een andere uitgangspose</translation>
    </message>
    <message>
        <source>move one of them, or make the stem or the nozzle longer</source>
        <translation>verplaats een van beide, of maak de steel of de nozzle langer</translation>
    </message>
    <message>
        <source>move the nozzle&apos;s frame</source>
        <translation>verplaats het assenstelsel van de nozzle</translation>
    </message>
    <message>
        <source>no folder for user-defined cells</source>
        <translation>geen map voor eigen cellen</translation>
    </message>
    <message>
        <source>not a table of points</source>
        <translation>geen tabel met punten</translation>
    </message>
    <message>
        <source>searching a place for the plate</source>
        <translation>een plaats voor de plaat wordt gezocht</translation>
    </message>
    <message>
        <source>poses {first} and {second} are identical</source>
        <translation>poses {first} en {second} zijn identiek</translation>
    </message>
    <message>
        <source>set HOME, or VOLUTA_DATA to a folder</source>
        <translation>stel HOME in, of VOLUTA_DATA op een map</translation>
    </message>
    <message>
        <source>smoothing of rotations</source>
        <translation>afvlakking van draaiingen</translation>
    </message>
    <message>
        <source>use a cell with a plate</source>
        <translation>gebruik een cel met een plaat</translation>
    </message>
    <message>
        <source>measure a point well off the line through the others</source>
        <translation>meet een punt ruim naast de lijn door de andere</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>kies een andere naam</translation>
    </message>
    <message>
        <source>takes too long to read</source>
        <translation>het lezen duurt te lang</translation>
    </message>
    <message>
        <source>no place found where the arm reaches above a plate without collision (reach {reach} mm)</source>
        <translation>geen plaats gevonden waar de arm zonder botsing boven een plaat komt (bereik {reach} mm)</translation>
    </message>
    <message>
        <source>implausible reach of the arm: {reach} mm</source>
        <translation>ongeloofwaardig bereik van de arm: {reach} mm</translation>
    </message>
    <message>
        <source>the arm&apos;s description</source>
        <translation>de beschrijving van de arm</translation>
    </message>
    <message>
        <source>payload {carried:.3g} kg exceeds the robot&apos;s rating of {most:.3g} kg</source>
        <translation>de last van {carried:.3g} kg is groter dan de {most:.3g} kg waarvoor de robot is bedoeld</translation>
    </message>
    <message>
        <source>must be larger than that of the point before</source>
        <translation>moet groter zijn dan die van het punt ervoor</translation>
    </message>
    <message>
        <source>must not be larger than that of the point before</source>
        <translation>mag niet groter zijn dan die van het punt ervoor</translation>
    </message>
    <message>
        <source>must have at least one point</source>
        <translation>moet minstens één punt hebben</translation>
    </message>
    <message>
        <source>fixed nozzle</source>
        <translation>vaste nozzle</translation>
    </message>
    <message>
        <source>tilting table</source>
        <translation>kanteltafel</translation>
    </message>
    <message>
        <source>raised plate</source>
        <translation>verhoogde plaat</translation>
    </message>
    <message>
        <source>table on the floor</source>
        <translation>tafel op de vloer</translation>
    </message>
    <message>
        <source>it prints around a rod</source>
        <translation>deze print rond een staaf</translation>
    </message>
    <message>
        <source>its largest plate is too small for the foot, which fits at scale {scale}</source>
        <translation>de grootste plaat ervan is te klein voor de voet, die past op schaal {scale}</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg at {lever:.0f}, the robot carries {most:.3g} kg there</source>
        <translation>de flens zou {kg:.3g} kg dragen op {lever:.0f}, de robot draagt daar {most:.3g} kg</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg, the robot&apos;s rating is {most:.3g} kg</source>
        <translation>de flens zou {kg:.3g} kg dragen, de robot is bedoeld voor {most:.3g} kg</translation>
    </message>
    <message>
        <source>its nozzle cannot tilt</source>
        <translation>de nozzle ervan kan niet kantelen</translation>
    </message>
    <message>
        <source>its head is too bulky to lean</source>
        <translation>de kop ervan is te breed om te kantelen</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the part upright</source>
        <translation>de nozzle bereikt rechtop {share:.0f} van het onderdeel</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the poses up to a tilt of {tilt:.0f}</source>
        <translation>de nozzle bereikt {share:.0f} van de poses tot een kanteling van {tilt:.0f}</translation>
    </message>
    <message>
        <source>no cell with a fixed nozzle is among them</source>
        <translation>er is geen cel met een vaste nozzle bij</translation>
    </message>
    <message>
        <source>{cell} is out: {reason}</source>
        <translation>{cell} valt af: {reason}</translation>
    </message>
    <message>
        <source>{cell}: its fixed nozzle stays upright, so gravity helps; the platform may be small, and the arm carries plate and part ({kg:.3g} kg)</source>
        <translation>{cell}: de vaste nozzle blijft rechtop, dus de zwaartekracht helpt; het platform mag klein zijn, en de arm draagt plaat en onderdeel ({kg:.3g} kg)</translation>
    </message>
    <message>
        <source>{cell}: its table tilts the part, so gravity helps; {fixed}</source>
        <translation>{cell}: de tafel kantelt het onderdeel, dus de zwaartekracht helpt; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves and takes large parts, and the raised plate stays small for a leaning head, but gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}: de nozzle beweegt en kan grote onderdelen aan, en de verhoogde plaat blijft klein voor een gekantelde kop, maar tot {lean:.0f} uit de verticaal helpt de zwaartekracht niet; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, and takes large parts; {fixed}</source>
        <translation>{cell}: de nozzle beweegt, altijd rechtop, en kan grote onderdelen aan; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves over a table on the floor and takes large parts, but the platform is not small and gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}: de nozzle beweegt boven een tafel op de vloer en kan grote onderdelen aan, maar het platform is niet klein en tot {lean:.0f} uit de verticaal helpt de zwaartekracht niet; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, over a table on the floor and takes large parts; {fixed}</source>
        <translation>{cell}: de nozzle beweegt, altijd rechtop, boven een tafel op de vloer en kan grote onderdelen aan; {fixed}</translation>
    </message>
    <message>
        <source>none of these cells: {reasons}</source>
        <translation>geen van deze cellen: {reasons}</translation>
    </message>
    <message>
        <source>the nozzle is inside {body}</source>
        <translation>de nozzle zit in {body}</translation>
    </message>
    <message>
        <source>the plate is out of the arm&apos;s reach</source>
        <translation>de plaat ligt buiten het bereik van de arm</translation>
    </message>
    <message>
        <source>the points are on a line: the frame&apos;s rotation about it is undefined</source>
        <translation>de punten liggen op een lijn: de draaiing van het assenstelsel eromheen is onbepaald</translation>
    </message>
    <message>
        <source>the poses rotate the flange about one axis only, or hardly at all</source>
        <translation>de poses draaien de flens om slechts één as, of nauwelijks</translation>
    </message>
    <message>
        <source>tilt it by at least 30 degrees about two axes</source>
        <translation>kantel hem minstens 30 graden om twee assen</translation>
    </message>
    <message>
        <source>rotate the flange between poses</source>
        <translation>draai de flens tussen de poses</translation>
    </message>
    <message>
        <source>two of the three points are identical</source>
        <translation>twee van de drie punten zijn identiek</translation>
    </message>
    <message>
        <source>use letters, digits, dashes and dots</source>
        <translation>gebruik letters, cijfers, koppeltekens en punten</translation>
    </message>
    <message>
        <source>reach of the head</source>
        <translation>bereik van de kop</translation>
    </message>
    <message>
        <source>wherever the nozzle reaches the plate, {first} collides with {second}</source>
        <translation>overal waar de nozzle de plaat bereikt, botst {first} met {second}</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted}</source>
        <translation>{found} getallen in een rij in plaats van {wanted}</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted} as in the first</source>
        <translation>{found} getallen in een rij in plaats van {wanted} zoals in de eerste</translation>
    </message>
    <message>
        <source>CR750 (7.11 ms)</source>
        <translation>CR750 (7,11 ms)</translation>
    </message>
    <message>
        <source>CR800 (3.5 ms)</source>
        <translation>CR800 (3,5 ms)</translation>
    </message>
    <message>
        <source>Events set the analogue output where a motion begins (TriggEquip); by TCP speed, it follows the TCP&apos;s actual speed, so that slow corners get no excess (TriggSpeed).</source>
        <translation>Gebeurtenissen stellen de analoge uitgang in waar een beweging begint (TriggEquip); volgens TCP-snelheid volgt hij de werkelijke snelheid van het TCP, zodat langzame hoeken niet te veel krijgen (TriggSpeed).</translation>
    </message>
    <message>
        <source>How far the nozzle may tilt from its planned direction where that makes the joints&apos; motion smoother. Only with minimum jerk of whole paths.</source>
        <translation>Hoe ver de nozzle van zijn geplande richting mag kantelen waar dat de beweging van de gewrichten vloeiender maakt. Alleen bij kleinste ruk van hele banen.</translation>
    </message>
    <message>
        <source>Rotation of the nozzle about its own axis: best for the arm, or by a rule if the nozzle&apos;s attachments have a front. With a rule, fewer points can be reached.</source>
        <translation>Draaiing van de nozzle om zijn eigen as: zoals het best is voor de arm, of volgens een regel als de aanbouw van de nozzle een voorkant heeft. Met een regel zijn minder punten bereikbaar.</translation>
    </message>
    <message>
        <source>Joint stream (MELFA Mxt, with packets and sender)</source>
        <translation>Gewrichtsstroom (MELFA Mxt, met pakketten en zender)</translation>
    </message>
    <message>
        <source>Joint stream (Universal Robots, with receiver and sender)</source>
        <translation>Gewrichtsstroom (Universal Robots, met ontvanger en zender)</translation>
    </message>
    <message>
        <source>MELFA stream: one packet is sent per controller cycle.</source>
        <translation>MELFA-stroom: per cyclus van de besturing wordt één pakket verzonden.</translation>
    </message>
    <message>
        <source>RAPID: flow controlled by</source>
        <translation>RAPID: doorvoer gestuurd door</translation>
    </message>
    <message>
        <source>an invalid flow per speed</source>
        <translation>een ongeldige doorvoer per snelheid</translation>
    </message>
    <message>
        <source>a second stream</source>
        <translation>een tweede stroom</translation>
    </message>
    <message>
        <source>a stream has exactly one motion to the start, as its first row</source>
        <translation>een stroom heeft precies één beweging naar het begin, als eerste rij</translation>
    </message>
    <message>
        <source>a stream of {count} packets is too large for a file</source>
        <translation>een stroom van {count} pakketten is te groot voor een bestand</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>langs de baan</translation>
    </message>
    <message>
        <source>along the plate</source>
        <translation>langs de plaat</translation>
    </message>
    <message>
        <source>best for the arm</source>
        <translation>zoals best voor de arm</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>besturing</translation>
    </message>
    <message>
        <source>tilt tolerance</source>
        <translation>kanteltolerantie</translation>
    </message>
    <message>
        <source>events at points</source>
        <translation>gebeurtenissen bij punten</translation>
    </message>
    <message>
        <source>format {format} states joint values for another maker&apos;s arm, not for the {robot} of cell {cell}</source>
        <translation>formaat {format} geeft gewrichtswaarden voor de arm van een andere fabrikant, niet voor de {robot} van cel {cell}</translation>
    </message>
    <message>
        <source>smallest rotation from upright</source>
        <translation>kleinste draaiing vanuit rechtop</translation>
    </message>
    <message>
        <source>not the header of a joint stream</source>
        <translation>niet de kop van een gewrichtsstroom</translation>
    </message>
    <message>
        <source>not the program that receives this stream: &apos;{code}&apos;</source>
        <translation>niet het programma dat deze stroom ontvangt: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>packet {number} does not match the rows</source>
        <translation>pakket {number} komt niet overeen met de rijen</translation>
    </message>
    <message>
        <source>use melfa</source>
        <translation>gebruik melfa</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP-snelheid</translation>
    </message>
    <message>
        <source>the arm waits at another target than the previous one</source>
        <translation>de arm wacht op een ander doel dan het vorige</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not off at the end</source>
        <translation>de uitgangen van de extruder zijn aan het einde niet uit</translation>
    </message>
    <message>
        <source>a flow proportional to the speed in a motion of unknown length</source>
        <translation>een doorvoer evenredig met de snelheid in een beweging van onbekende lengte</translation>
    </message>
    <message>
        <source>the program that receives the stream is truncated</source>
        <translation>het programma dat de stroom ontvangt, is afgekapt</translation>
    </message>
    <message>
        <source>the row that ends the stream is missing: the file is truncated</source>
        <translation>de rij die de stroom afsluit, ontbreekt: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>this is not the program that receives a stream</source>
        <translation>dit is geen programma dat een stroom ontvangt</translation>
    </message>
    <message>
        <source>this line differs from the one Voluta writes; it is the same for every job</source>
        <translation>deze regel wijkt af van die van Voluta; hij is voor elke opdracht gelijk</translation>
    </message>
    <message>
        <source>nozzle rotation</source>
        <translation>draaiing van de nozzle</translation>
    </message>
    <message>
        <source>Maximum filament length that the external axis feeds before it is reset to 0.</source>
        <translation>Maximale filamentlengte die de externe as toevoert voordat hij op 0 wordt teruggezet.</translation>
    </message>
    <message>
        <source>How far the nozzle moves back over its bead, or on along a closed one, with the extruder off before it lifts. 0: it lifts at the end of the bead.</source>
        <translation>Hoe ver de nozzle met uitgeschakelde extruder over zijn streng teruggaat, of bij een gesloten streng doorgaat, voordat hij opheft. 0: hij heft op aan het einde van de streng.</translation>
    </message>
    <message>
        <source>How the program controls the extruder. Outputs: one for on/off, one for the flow. Castelli serial: texts over a socket. E stream: a file of amounts over time. External axis: mm of filament in each motion.</source>
        <translation>Hoe het programma de extruder stuurt. Uitgangen: één voor aan/uit, één voor de doorvoer. Castelli serieel: teksten via een socket. E-stroom: een bestand met hoeveelheden in de tijd. Externe as: mm filament in elke beweging.</translation>
    </message>
    <message>
        <source>the whole mesh is a single point</source>
        <translation>de hele mesh is één enkel punt</translation>
    </message>
    <message>
        <source>at {x:.3f#}, {y:.3f#}, {z:.3f}, rotated by {rx:.3f#}, {ry:.3f#}, {rz:.3f}</source>
        <translation>op {x:.3f#}, {y:.3f#}, {z:.3f}, gedraaid met {rx:.3f#}, {ry:.3f#}, {rz:.3f}</translation>
    </message>
    <message>
        <source>more than {length:.0f} of filament is needed between two lifts: beyond the extruder axis&apos; range</source>
        <translation>tussen twee keer opheffen is meer dan {length:.0f} filament nodig: buiten het bereik van de extruderas</translation>
    </message>
    <message>
        <source>external axes that move alone are only supported for the extruder, with a time</source>
        <translation>externe assen die alleen bewegen, worden alleen ondersteund voor de extruder, met een tijd</translation>
    </message>
    <message>
        <source>external axis</source>
        <translation>externe as</translation>
    </message>
    <message>
        <source>extruder axis: range</source>
        <translation>extruderas: bereik</translation>
    </message>
    <message>
        <source>no redundant measurements: the error cannot be estimated</source>
        <translation>geen overtollige metingen: de fout kan niet worden geschat</translation>
    </message>
    <message>
        <source>increase {option}</source>
        <translation>verhoog {option}</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is missing</source>
        <translation>de as van de extruder ontbreekt</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is not set to 0 before this motion</source>
        <translation>de as van de extruder is vóór deze beweging niet op 0 gezet</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is slowed: the arm would wait for it</source>
        <translation>de as van de extruder is vertraagd: de arm zou erop wachten</translation>
    </message>
    <message>
        <source>wipe</source>
        <translation>afvegen</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f}</source>
        <translation>{rows} rijen, restfout gemiddeld {rms:.3f} en hoogstens {worst:.3f}: nauwkeurig tot {place:.3f}</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f} and {turn:.3f}</source>
        <translation>{rows} rijen, restfout gemiddeld {rms:.3f} en hoogstens {worst:.3f}: nauwkeurig tot {place:.3f} en {turn:.3f}</translation>
    </message>
    <message>
        <source>Extended G-code: also writes a RAPID module that reads the file on an ABB controller and runs arm and extruder.</source>
        <translation>Uitgebreide G-code: schrijft ook een RAPID-module die het bestand op een ABB-besturing leest en arm en extruder laat lopen.</translation>
    </message>
    <message>
        <source>Lines by data link (MELFA-BASIC V, with receiver and sender)</source>
        <translation>Regels via datalink (MELFA-BASIC V, met ontvanger en zender)</translation>
    </message>
    <message>
        <source>a RAPID module (ABB)</source>
        <translation>een RAPID-module (ABB)</translation>
    </message>
    <message>
        <source>a module that reads G-code cannot move the {axis} of cell {cell}: G-code does not state its position</source>
        <translation>een module die G-code leest, kan de {axis} van cel {cell} niet bewegen: G-code geeft de positie ervan niet</translation>
    </message>
    <message>
        <source>a position before the tool is defined</source>
        <translation>een positie voordat het gereedschap is bepaald</translation>
    </message>
    <message>
        <source>the full flow is not the process&apos;s</source>
        <translation>de volle doorvoer is niet die van het proces</translation>
    </message>
    <message>
        <source>companion reader for extended G-code</source>
        <translation>bijbehorende lezer voor uitgebreide G-code</translation>
    </message>
    <message>
        <source>its count (G92 C)</source>
        <translation>zijn telling (G92 C)</translation>
    </message>
    <message>
        <source>joint motions with joint targets and with pose targets in one stream</source>
        <translation>gewrichtsbewegingen met gewrichtsdoelen en met posedoelen in één stroom</translation>
    </message>
    <message>
        <source>not the header of lines for a data link</source>
        <translation>niet de kop van regels voor een datalink</translation>
    </message>
    <message>
        <source>unexpected in the program that receives these lines: &apos;{code}&apos;</source>
        <translation>onverwacht in het programma dat deze regels ontvangt: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niets</translation>
    </message>
    <message>
        <source>set `tableTurns` to {turns} or more</source>
        <translation>stel `tableTurns` in op {turns} of meer</translation>
    </message>
    <message>
        <source>choose rapid</source>
        <translation>kies rapid</translation>
    </message>
    <message>
        <source>the arm does not stop before this line</source>
        <translation>de arm stopt niet vóór deze regel</translation>
    </message>
    <message>
        <source>the extruder is on in a joint motion</source>
        <translation>de extruder is aan in een gewrichtsbeweging</translation>
    </message>
    <message>
        <source>the job&apos;s file, start or full flow is missing or given twice</source>
        <translation>bestand, begin of volle doorvoer van de opdracht ontbreekt of is twee keer gegeven</translation>
    </message>
    <message>
        <source>the first line is not a joint motion to the start</source>
        <translation>de eerste regel is geen gewrichtsbeweging naar het begin</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; has no height above the previous one</source>
        <translation>laag &apos;{path}&apos; heeft geen hoogte boven de vorige</translation>
    </message>
    <message>
        <source>the line that ends the stream is missing: the file is truncated</source>
        <translation>de regel die de stroom afsluit, ontbreekt: het bestand is afgekapt</translation>
    </message>
    <message>
        <source>the program that receives the lines is truncated</source>
        <translation>het programma dat de regels ontvangt, is afgekapt</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>de tafel</translation>
    </message>
    <message>
        <source>within a bead the table would turn by more than {turns} turns to one side</source>
        <translation>binnen een streng zou de tafel meer dan {turns} omwentelingen naar één kant draaien</translation>
    </message>
    <message>
        <source>this is not the module that reads G-code</source>
        <translation>dit is niet de module die G-code leest</translation>
    </message>
    <message>
        <source>tool-paths of type &apos;{type}&apos; without beads; only beads from a nozzle are supported</source>
        <translation>gereedschapsbanen van type &apos;{type}&apos; zonder strengen; alleen strengen uit een nozzle worden ondersteund</translation>
    </message>
    <message>
        <source>turns until C is reset</source>
        <translation>omwentelingen tot C wordt teruggezet</translation>
    </message>
    <message>
        <source>reset of C</source>
        <translation>terugzetten van C</translation>
    </message>
    <message>
        <source>Adds break-away beads under low overhangs; thickens the overhanging bead instead where that is enough.</source>
        <translation>Voegt afbreekbare strengen toe onder lage overhangen; maakt in plaats daarvan de overhangende streng dikker waar dat genoeg is.</translation>
    </message>
    <message>
        <source>Lines by EthernetKRL (KUKA, with receiver and sender)</source>
        <translation>Regels via EthernetKRL (KUKA, met ontvanger en zender)</translation>
    </message>
    <message>
        <source>an axis that carries the robot is missing</source>
        <translation>een as die de robot draagt, ontbreekt</translation>
    </message>
    <message numerus="yes">
        <source>support beads ({volume:.3g}) under {paths} beads that would overhang just above the plate or the printed part</source>
        <translation>
            <numerusform>steunstrengen ({volume:.3g}) onder {paths} streng die vlak boven de plaat of het geprinte onderdeel zou overhangen</numerusform>
            <numerusform>steunstrengen ({volume:.3g}) onder {paths} strengen die vlak boven de plaat of het geprinte onderdeel zouden overhangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{paths} unsupported beads are printed after their inner neighbours, with the nozzle tilted by up to {lean:.0f} more</source>
        <translation>
            <numerusform>{paths} niet ondersteunde streng wordt na zijn binnenste buur geprint, met de nozzle tot {lean:.0f} verder gekanteld</numerusform>
            <numerusform>{paths} niet ondersteunde strengen worden na hun binnenste buren geprint, met de nozzle tot {lean:.0f} verder gekanteld</numerusform>
        </translation>
    </message>
    <message>
        <source>if you do not want this, turn the part or print it in flat layers with supports</source>
        <translation>als je dit niet wilt, draai dan het onderdeel of print het in vlakke lagen met ondersteuning</translation>
    </message>
    <message>
        <source>format {format} does not support external axes: it cannot move the {axis} of cell {cell}</source>
        <translation>formaat {format} ondersteunt geen externe assen: het kan de {axis} van cel {cell} niet bewegen</translation>
    </message>
    <message>
        <source>must be platform after an axis that carries the platform</source>
        <translation>moet platform zijn na een as die het platform draagt</translation>
    </message>
    <message>
        <source>must be platform or robot, is &apos;{carries}&apos;</source>
        <translation>moet platform of robot zijn, is &apos;{carries}&apos;</translation>
    </message>
    <message>
        <source>either a base or a fixed nozzle has to be defined</source>
        <translation>er moet een basis of een vaste nozzle worden bepaald</translation>
    </message>
    <message>
        <source>support low overhangs</source>
        <translation>lage overhangen ondersteunen</translation>
    </message>
    <message>
        <source>the program&apos;s nozzle is {distance:.2f} and {angle:.2f} off the cell&apos;s nozzle</source>
        <translation>de nozzle van het programma wijkt {distance:.2f} en {angle:.2f} af van die van de cel</translation>
    </message>
    <message numerus="yes">
        <source>{waypoints} waypoints ({share:.2g} of the material) are skipped; see the findings above</source>
        <translation>
            <numerusform>{waypoints} baanpunt ({share:.2g} van het materiaal) wordt overgeslagen; zie de bevindingen hierboven</numerusform>
            <numerusform>{waypoints} baanpunten ({share:.2g} van het materiaal) worden overgeslagen; zie de bevindingen hierboven</numerusform>
        </translation>
    </message>
    <message>
        <source>The largest scale that the robot reaches entirely</source>
        <translation>De grootste schaal die de robot volledig bereikt</translation>
    </message>
    <message>
        <source>print it at scale {scale:.3g}, turn it, or use a larger robot</source>
        <translation>print het op schaal {scale:.3g}, draai het, of gebruik een grotere robot</translation>
    </message>
    <message>
        <source>use flat layers, which need no tilt of the nozzle, turn the part, or use a larger robot</source>
        <translation>gebruik vlakke lagen, waarvoor de nozzle niet hoeft te kantelen, draai het onderdeel, of gebruik een grotere robot</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach</source>
        <translation>{share:.2g} van de punten van de gereedschapsbaan ligt buiten het bereik van de robot</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach; at {size:.2g} of this size all would be reachable</source>
        <translation>{share:.2g} van de punten van de gereedschapsbaan ligt buiten het bereik van de robot; op {size:.2g} van deze grootte zouden alle bereikbaar zijn</translation>
    </message>
    <message>
        <source>Let Voluta choose</source>
        <translation>Voluta laten kiezen</translation>
    </message>
    <message>
        <source>Tries the ways of building in turn until nothing is unsupported or missed</source>
        <translation>Probeert de bouwwijzen een voor een tot niets meer niet ondersteund of gemist is</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is a reserved word and cannot name a function</source>
        <translation>&apos;{name}&apos; is een gereserveerd woord en kan geen functienaam zijn</translation>
    </message>
    <message>
        <source>ambiguous number &apos;{number}&apos;: decimal comma or thousands separator</source>
        <translation>dubbelzinnig getal &apos;{number}&apos;: decimaalkomma of scheidingsteken voor duizendtallen</translation>
    </message>
    <message>
        <source>20 % smaller</source>
        <translation>20 % kleiner</translation>
    </message>
    <message>
        <source>Adds a verification report to each program, NAME.proof.html and NAME.proof.pdf: the verdict, the checks and the margins to the limits; its figures as NAME.proof.json; and NAME.printed.stl, the part as printed, as a solid.</source>
        <translation>Voegt aan elk programma een verificatierapport toe, NAME.proof.html en NAME.proof.pdf: het oordeel, de controles en de marges tot de grenzen; de cijfers als NAME.proof.json; en NAME.printed.stl, het onderdeel zoals geprint, als lichaam.</translation>
    </message>
    <message>
        <source>Allow less clearance</source>
        <translation>Minder vrije afstand toestaan</translation>
    </message>
    <message>
        <source>Amount: {share:.1f} of the part&apos;s volume is deposited; {least:.4g#} to {most:.4g} allowed.</source>
        <translation>Hoeveelheid: {share:.1f} van het volume van het onderdeel wordt afgezet; {least:.4g#} tot {most:.4g} toegestaan.</translation>
    </message>
    <message>
        <source>Arm, joints and their limits: not checked, as the program contains nozzle positions but no joint values.</source>
        <translation>Arm, gewrichten en hun grenzen: niet gecontroleerd, omdat het programma nozzleposities bevat maar geen gewrichtswaarden.</translation>
    </message>
    <message>
        <source>The largest scale that the cell&apos;s plates carry</source>
        <translation>De grootste schaal die de platen van de cel dragen</translation>
    </message>
    <message>
        <source>The part&apos;s footprint plus 20 mm, on its own stem</source>
        <translation>Het grondvlak van het onderdeel plus 20 mm, op een eigen steel</translation>
    </message>
    <message>
        <source>Bead section: off by more than 5 % over {share:.2f} of the printed length; at most {limit:.0f} allowed.</source>
        <translation>Strengdoorsnede: meer dan 5 % afwijking over {share:.2f} van de geprinte lengte; hoogstens {limit:.0f} toegestaan.</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Ingebouwd in</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cel</translation>
    </message>
    <message>
        <source>Chosen: {way} ({values})</source>
        <translation>Gekozen: {way} ({values})</translation>
    </message>
    <message>
        <source>Close the openings</source>
        <translation>Openingen sluiten</translation>
    </message>
    <message>
        <source>Minimum clearance between arm, plate and part: {way:.1f}.</source>
        <translation>Kleinste vrije afstand tussen arm, plaat en onderdeel: {way:.1f}.</translation>
    </message>
    <message>
        <source>Collisions of head, plate and part: {collisions}; none allowed.</source>
        <translation>Botsingen van kop, plaat en onderdeel: {collisions}; geen toegestaan.</translation>
    </message>
    <message>
        <source>Collisions: {collisions}; none allowed.</source>
        <translation>Botsingen: {collisions}; geen toegestaan.</translation>
    </message>
    <message>
        <source>Fill: {share:.1f} of the part is filled; at least {limit:.4g} required.</source>
        <translation>Vulling: {share:.1f} van het onderdeel is gevuld; minstens {limit:.4g} vereist.</translation>
    </message>
    <message>
        <source>Flat patches over the openings: the part becomes solid</source>
        <translation>Vlakke stukken over de openingen: het onderdeel wordt massief</translation>
    </message>
    <message>
        <source>G-code with B and C: beyond this number of turns to one side C is reset by whole turns during a travel. 0: the minimum the beads allow if the table is wound back, one turn if only its count is reset.</source>
        <translation>G-code met B en C: voorbij dit aantal omwentelingen naar één kant wordt C tijdens een verplaatsing met hele omwentelingen teruggezet. 0: het minimum dat de strengen toelaten als de tafel wordt teruggedraaid, één omwenteling als alleen de telling wordt teruggezet.</translation>
    </message>
    <message>
        <source>G-code with B and C: winds the table back during a travel, with the nozzle raised clear of it. For a table that turns endlessly only the count can be reset, without a motion.</source>
        <translation>G-code met B en C: draait de tafel tijdens een verplaatsing terug, met de nozzle erboven vrij opgeheven. Bij een tafel die eindeloos draait, kan volstaan worden met het terugzetten van de telling, zonder beweging.</translation>
    </message>
    <message>
        <source>G94 is missing after the last motion: the next program would read F as times</source>
        <translation>G94 ontbreekt na de laatste beweging: het volgende programma zou F als tijden lezen</translation>
    </message>
    <message>
        <source>Half the layer height, within the process&apos;s range</source>
        <translation>De halve laaghoogte, binnen het bereik van het proces</translation>
    </message>
    <message>
        <source>50 % larger</source>
        <translation>50 % groter</translation>
    </message>
    <message>
        <source>Half the distance of the arm from itself and from the part</source>
        <translation>De helft van de afstand van de arm tot zichzelf en tot het onderdeel</translation>
    </message>
    <message>
        <source>Partly supported: {share:.1f} of the bead length is supported over less than half its width.</source>
        <translation>Deels ondersteund: {share:.1f} van de strenglengte is over minder dan de halve breedte ondersteund.</translation>
    </message>
    <message>
        <source>In a usual cell; Voluta chooses the way of building</source>
        <translation>In een gebruikelijke cel; Voluta kiest de bouwwijze</translation>
    </message>
    <message>
        <source>It is for another controller than the cell&apos;s.</source>
        <translation>Het is voor een andere besturing dan die van de cel.</translation>
    </message>
    <message>
        <source>It prints the rest of a stopped print.</source>
        <translation>Het print de rest van een gestopte print.</translation>
    </message>
    <message>
        <source>Joint range: joint {name} has the smallest margin to its limit, {angle:.1f}.</source>
        <translation>Gewrichtsbereik: gewricht {name} heeft de kleinste marge tot zijn grens, {angle:.1f}.</translation>
    </message>
    <message>
        <source>Joint speed: joint {name} is closest to its limit, at {share:.0f} of it.</source>
        <translation>Gewrichtssnelheid: gewricht {name} zit het dichtst bij zijn grens, op {share:.0f} ervan.</translation>
    </message>
    <message>
        <source>Keep more clearance</source>
        <translation>Meer vrije afstand houden</translation>
    </message>
    <message>
        <source>Limits of flow and blends: {violations} violations; none allowed.</source>
        <translation>Grenzen van doorvoer en afrondingen: {violations} overschrijdingen; geen toegestaan.</translation>
    </message>
    <message>
        <source>Limits of joints, speeds and flow: {violations} violations; none allowed.</source>
        <translation>Grenzen van gewrichten, snelheden en doorvoer: {violations} overschrijdingen; geen toegestaan.</translation>
    </message>
    <message>
        <source>Longer programs are split into files to run one after the other. 0: the format&apos;s default (URScript and RAPID 5000, KRL 2500, MELFA 6500, SPEL+ one file).</source>
        <translation>Langere programma&apos;s worden gesplitst in bestanden die na elkaar worden uitgevoerd. 0: de standaard van het formaat (URScript en RAPID 5000, KRL 2500, MELFA 6500, SPEL+ één bestand).</translation>
    </message>
    <message>
        <source>Longest unsupported run: {length:.1f}; this material bridges {bridge:.1f}.</source>
        <translation>Langste niet ondersteunde stuk: {length:.1f}; dit materiaal overbrugt {bridge:.1f}.</translation>
    </message>
    <message>
        <source>Make a platform for the part</source>
        <translation>Een platform voor het onderdeel maken</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>No way of building passes; the best one is shown: {way} ({values})</source>
        <translation>Geen bouwwijze voldoet; de beste wordt getoond: {way} ({values})</translation>
    </message>
    <message>
        <source>The default nozzle, head and material of this way of building</source>
        <translation>De standaardnozzle, -kop en het standaardmateriaal van deze bouwwijze</translation>
    </message>
    <message>
        <source>G{number} is not understood</source>
        <translation>G{number} wordt niet begrepen</translation>
    </message>
    <message>
        <source>Height after which the layers turn in the other direction, again and again; 0: never.</source>
        <translation>Hoogte waarna de lagen in de andere richting draaien, telkens opnieuw; 0: nooit.</translation>
    </message>
    <message>
        <source>Material of the file&apos;s tool-paths, in percent of its amounts. For a file that was read with another filament diameter: 100 times the square of their ratio (2.85 mm instead of 1.75 mm: 265).</source>
        <translation>Materiaal van de gereedschapsbanen van het bestand, in procent van zijn hoeveelheden. Voor een bestand dat met een andere filamentdiameter is gelezen: 100 keer het kwadraat van hun verhouding (2,85 mm in plaats van 1,75 mm: 265).</translation>
    </message>
    <message>
        <source>Moves the file&apos;s tool-paths to x,y,z,a,b,c: mm, and degrees about the fixed axes x, y and z in this order; e.g. onto a side of the platform&apos;s body. Empty: no motion.</source>
        <translation>Verplaatst de gereedschapsbanen van het bestand naar x,y,z,a,b,c: mm, en graden om de vaste assen x, y en z in deze volgorde; bijv. op een zijkant van het lichaam van het platform. Leeg: geen verplaatsing.</translation>
    </message>
    <message>
        <source>On a cylinder or sphere: each layer keeps the lengths of the file, or the angle of the layer below, so that it grows with the radius and its beads with it.</source>
        <translation>Op een cilinder of bol: elke laag houdt de lengtes van het bestand, of de hoek van de laag eronder, zodat hij meegroeit met de straal en zijn strengen ook.</translation>
    </message>
    <message>
        <source>Paths of the file</source>
        <translation>Banen van het bestand</translation>
    </message>
    <message>
        <source>Radius of that cylinder or sphere; negative: its inside.</source>
        <translation>Straal van die cilinder of bol; negatief: de binnenkant ervan.</translation>
    </message>
    <message>
        <source>Turns each layer of the file&apos;s tool-paths about z against the one below; positive: counterclockwise.</source>
        <translation>Draait elke laag van de gereedschapsbanen van het bestand om z ten opzichte van die eronder; positief: tegen de klok in.</translation>
    </message>
    <message>
        <source>Where the file&apos;s tool-paths are printed: on the plate; on a block with a plane top, which is turned together with them; or bent onto a cylinder along x or a sphere. The block is made for the part, unless the platform is a body.</source>
        <translation>Waar de gereedschapsbanen van het bestand worden geprint: op de plaat; op een blok met een vlakke bovenkant, dat samen ermee wordt gedraaid; of gebogen op een cilinder langs x of een bol. Het blok wordt voor het onderdeel gemaakt, tenzij het platform een lichaam is.</translation>
    </message>
    <message>
        <source>a bead from an unknown position</source>
        <translation>een streng vanuit een onbekende positie</translation>
    </message>
    <message>
        <source>a direction of length 0</source>
        <translation>een richting met lengte 0</translation>
    </message>
    <message>
        <source>a length of filament of more than a kilometre</source>
        <translation>een filamentlengte van meer dan een kilometer</translation>
    </message>
    <message>
        <source>a motion with a word A, U, V or W is not understood</source>
        <translation>een beweging met een woord A, U, V of W wordt niet begrepen</translation>
    </message>
    <message>
        <source>a position more than a kilometre away</source>
        <translation>een positie op meer dan een kilometer afstand</translation>
    </message>
    <message>
        <source>a position without G0 or G1</source>
        <translation>een positie zonder G0 of G1</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>hoeveelheid</translation>
    </message>
    <message>
        <source>an arc that does not pass through its ends</source>
        <translation>een boog die niet door zijn eindpunten gaat</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>hoeken</translation>
    </message>
    <message>
        <source>bent layers keep</source>
        <translation>gebogen lagen behouden</translation>
    </message>
    <message>
        <source>contains no beads of a part</source>
        <translation>bevat geen strengen van een onderdeel</translation>
    </message>
    <message>
        <source>contains no beads: no motion extrudes</source>
        <translation>bevat geen strengen: geen beweging extrudeert</translation>
    </message>
    <message>
        <source>export G-code as text from the slicer</source>
        <translation>exporteer G-code als tekst uit de slicer</translation>
    </message>
    <message>
        <source>export straight lines, or arcs in the plane of X and Y (G2, G3)</source>
        <translation>exporteer rechte lijnen, of bogen in het vlak van X en Y (G2, G3)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E)</source>
        <translation>exporteer de G-code met extrusie (E)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E) from a slicer</source>
        <translation>exporteer de G-code met extrusie (E) uit een slicer</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>assenstelsel</translation>
    </message>
    <message>
        <source>give F in mm per minute</source>
        <translation>geef F in mm per minuut</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`</source>
        <translation>geef een grotere `pathsRadiusMm`</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`, or turn the part by 90 degrees</source>
        <translation>geef een grotere `pathsRadiusMm`, of draai het onderdeel 90 graden</translation>
    </message>
    <message>
        <source>give at least 1 mm, or at most -1 mm for the inside</source>
        <translation>geef minstens 1 mm, of hoogstens -1 mm voor de binnenkant</translation>
    </message>
    <message>
        <source>give its centre (I, J) or its radius (R)</source>
        <translation>geef het middelpunt (I, J) of de straal (R)</translation>
    </message>
    <message>
        <source>give nX nY nZ as a unit vector</source>
        <translation>geef nX nY nZ als eenheidsvector</translation>
    </message>
    <message>
        <source>give the nozzle&apos;s direction as nX nY nZ, or the table&apos;s angles as B and C</source>
        <translation>geef de richting van de nozzle als nX nY nZ, of de hoeken van de tafel als B en C</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>ondergrond</translation>
    </message>
    <message>
        <source>home the axes (G28) or travel to its start first</source>
        <translation>zet de assen eerst in hun referentiestand (G28) of ga eerst naar het begin</translation>
    </message>
    <message>
        <source>is binary G-code</source>
        <translation>is binaire G-code</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>lengtes</translation>
    </message>
    <message>
        <source>`pathsFrame` &apos;{text}&apos; is not a frame</source>
        <translation>`pathsFrame` &apos;{text}&apos; is geen assenstelsel</translation>
    </message>
    <message>
        <source>`pathsRadiusMm={radius}` is no radius of a ground</source>
        <translation>`pathsRadiusMm={radius}` is geen straal van een ondergrond</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>vlak</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>plaat</translation>
    </message>
    <message>
        <source>slice with comments, or with layers of one height</source>
        <translation>slice met commentaar, of met lagen van één hoogte</translation>
    </message>
    <message>
        <source>the file may be damaged; export it again</source>
        <translation>het bestand is mogelijk beschadigd; exporteer het opnieuw</translation>
    </message>
    <message>
        <source>the file states no filament diameter: {diameter} assumed; for another one set `pathsFlow`</source>
        <translation>het bestand geeft geen filamentdiameter: {diameter} aangenomen; stel voor een andere `pathsFlow` in</translation>
    </message>
    <message>
        <source>a bead at X{x:.1f} Y{y:.1f} Z{z:.1f} is {width:.0f} wide</source>
        <translation>een streng bij X{x:.1f} Y{y:.1f} Z{z:.1f} is {width:.0f} breed</translation>
    </message>
    <message>
        <source>correct the amount (E) of that line, or the filament&apos;s diameter</source>
        <translation>verbeter de hoeveelheid (E) van die regel, of de filamentdiameter</translation>
    </message>
    <message>
        <source>the height of the beads is not known</source>
        <translation>de hoogte van de strengen is niet bekend</translation>
    </message>
    <message>
        <source>the part is {height:.1f} high, too high for the inside of a radius of {radius:.1f}</source>
        <translation>het onderdeel is {height:.1f} hoog, te hoog voor de binnenkant van een straal van {radius:.1f}</translation>
    </message>
    <message>
        <source>the part reaches {angle:.0f} round the ground, more than 90</source>
        <translation>het onderdeel loopt {angle:.0f} rond de ondergrond, meer dan 90</translation>
    </message>
    <message>
        <source>turn back after</source>
        <translation>terugdraaien na</translation>
    </message>
    <message>
        <source>turn per layer</source>
        <translation>draaiing per laag</translation>
    </message>
    <message>
        <source>write the command in each line</source>
        <translation>schrijf het commando in elke regel</translation>
    </message>
    <message>
        <source>write x,y,z,a,b,c in mm and degrees</source>
        <translation>schrijf x,y,z,a,b,c in mm en graden</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded before the first layer are left out</source>
        <translation>{volume:.0f} dat vóór de eerste laag is geëxtrudeerd, is weggelaten</translation>
    </message>
    <message>
        <source>Open surfaces</source>
        <translation>Open oppervlakken</translation>
    </message>
    <message>
        <source>Overfill: {share:.1f} of the part&apos;s volume lies outside it or in places already full; at most {limit:.4g} allowed.</source>
        <translation>Overvulling: {share:.1f} van het volume van het onderdeel ligt erbuiten of op al volle plaatsen; hoogstens {limit:.4g} toegestaan.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Passed: this program prints the part as planned.</source>
        <translation>Geslaagd: dit programma print het onderdeel zoals gepland.</translation>
    </message>
    <message>
        <source>Path: the nozzle deviates from the planned path by up to {way:.3f}; at most {limit:.2f} allowed.</source>
        <translation>Baan: de nozzle wijkt tot {way:.3f} af van de geplande baan; hoogstens {limit:.2f} toegestaan.</translation>
    </message>
    <message>
        <source>Planned
time</source>
        <translation>Geplande
tijd</translation>
    </message>
    <message>
        <source>Positions are in mm in the work frame: origin at the centre of the platform&apos;s top, z pointing out of it. The printed part as a solid: {file}</source>
        <translation>Posities zijn in mm in het werkstelsel: oorsprong in het midden van de bovenkant van het platform, z wijst eruit. Het geprinte onderdeel als lichaam: {file}</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Primen</translation>
    </message>
    <message>
        <source>Print it larger</source>
        <translation>Groter printen</translation>
    </message>
    <message>
        <source>Print it smaller</source>
        <translation>Kleiner printen</translation>
    </message>
    <message>
        <source>Print thinner layers</source>
        <translation>Dunnere lagen printen</translation>
    </message>
    <message>
        <source>Print on a plate</source>
        <translation>Op een plaat printen</translation>
    </message>
    <message>
        <source>Print time</source>
        <translation>Printtijd</translation>
    </message>
    <message>
        <source>Program files with their SHA-256</source>
        <translation>Programmabestanden met hun SHA-256</translation>
    </message>
    <message>
        <source>Refused: do not run this program.</source>
        <translation>Afgewezen: voer dit programma niet uit.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>The default robot and plate of this way of building</source>
        <translation>De standaardrobot en -plaat van deze bouwwijze</translation>
    </message>
    <message>
        <source>Singularities: isotropy is at least {ratio:.3f} (0 is singular, 1 is isotropic).</source>
        <translation>Singulariteiten: de isotropie is minstens {ratio:.3f} (0 is singulier, 1 is isotroop).</translation>
    </message>
    <message>
        <source>The next cell with a larger plate</source>
        <translation>De volgende cel met een grotere plaat</translation>
    </message>
    <message>
        <source>The cell&apos;s smallest plate that carries the part</source>
        <translation>De kleinste plaat van de cel die het onderdeel draagt</translation>
    </message>
    <message>
        <source>Thicken to a wall</source>
        <translation>Tot wand verdikken</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>Try more rotations</source>
        <translation>Meer draaiingen proberen</translation>
    </message>
    <message>
        <source>Trying {way} ({number} of {count})</source>
        <translation>{way} wordt geprobeerd ({number} van {count})</translation>
    </message>
    <message>
        <source>Twice as many rotations about the nozzle per point; planning takes longer</source>
        <translation>Twee keer zoveel draaiingen om de nozzle per punt; het plannen duurt langer</translation>
    </message>
    <message>
        <source>Twice the distance of the arm from itself and from the part</source>
        <translation>Twee keer de afstand van de arm tot zichzelf en tot het onderdeel</translation>
    </message>
    <message>
        <source>Two beads wide, centred on the surface</source>
        <translation>Twee strengen breed, gecentreerd op het oppervlak</translation>
    </message>
    <message>
        <source>Unsupported: {share:.2f} of the bead length; at most {limit:.4g} allowed.</source>
        <translation>Niet ondersteund: {share:.2f} van de strenglengte; hoogstens {limit:.4g} toegestaan.</translation>
    </message>
    <message>
        <source>Use a larger cell</source>
        <translation>Een grotere cel gebruiken</translation>
    </message>
    <message>
        <source>Use longer motions</source>
        <translation>Langere bewegingen gebruiken</translation>
    </message>
    <message>
        <source>Use shorter motions</source>
        <translation>Kortere bewegingen gebruiken</translation>
    </message>
    <message>
        <source>Use the cell&apos;s plate</source>
        <translation>De plaat van de cel gebruiken</translation>
    </message>
    <message>
        <source>Use the usual cell</source>
        <translation>De gebruikelijke cel gebruiken</translation>
    </message>
    <message>
        <source>Use the usual process</source>
        <translation>Het gebruikelijke proces gebruiken</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, moved the nozzle along it without an arm, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta las het programma terug, bewoog de nozzle er zonder arm langs, en vond {checks} mislukte controle.</numerusform>
            <numerusform>Voluta las het programma terug, bewoog de nozzle er zonder arm langs, en vond {checks} mislukte controles.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, moved the nozzle along it without an arm, and measured what it prints.</source>
        <translation>Voluta las het programma terug, bewoog de nozzle er zonder arm langs, en mat wat het print.</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta las het programma terug, voerde het uit op een model van de robot en zijn besturing, en vond {checks} mislukte controle.</numerusform>
            <numerusform>Voluta las het programma terug, voerde het uit op een model van de robot en zijn besturing, en vond {checks} mislukte controles.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and measured what it prints.</source>
        <translation>Voluta las het programma terug, voerde het uit op een model van de robot en zijn besturing, en mat wat het print.</translation>
    </message>
    <message>
        <source>Voluta {version}, {date}</source>
        <translation>Voluta {version}, {date}</translation>
    </message>
    <message>
        <source>Half the waypoint spacing; the program gets longer</source>
        <translation>De halve afstand tussen baanpunten; het programma wordt langer</translation>
    </message>
    <message>
        <source>Twice the waypoint spacing</source>
        <translation>Twee keer de afstand tussen baanpunten</translation>
    </message>
    <message>
        <source>Checks, with the closest approach to each limit</source>
        <translation>Controles, met de dichtste nadering tot elke grens</translation>
    </message>
    <message>
        <source>Modules and signal list for this controller: IRC5 (RobotWare 6) or OmniCore (RobotWare 7).</source>
        <translation>Modules en signaallijst voor deze besturing: IRC5 (RobotWare 6) of OmniCore (RobotWare 7).</translation>
    </message>
    <message>
        <source>a ball refers to the missing vertex {vertex}</source>
        <translation>een bol verwijst naar het ontbrekende hoekpunt {vertex}</translation>
    </message>
    <message>
        <source>a beam refers to the missing vertex {vertex}</source>
        <translation>een balk verwijst naar het ontbrekende hoekpunt {vertex}</translation>
    </message>
    <message>
        <source>a beam without a radius</source>
        <translation>een balk zonder straal</translation>
    </message>
    <message>
        <source>a picture of the sheet is not a PNG</source>
        <translation>een afbeelding van het blad is geen PNG</translation>
    </message>
    <message>
        <source>a stop until the operator continues</source>
        <translation>een stop tot de operator verdergaat</translation>
    </message>
    <message>
        <source>a trigger for the output</source>
        <translation>een trigger voor de uitgang</translation>
    </message>
    <message>
        <source>a wait until the nozzle is hot</source>
        <translation>wachten tot de nozzle heet is</translation>
    </message>
    <message>
        <source>a wall of {wall:.2f} is too thin for a surface of this size: it would need {facets:.2g} triangles</source>
        <translation>een wand van {wall:.2f} is te dun voor een oppervlak van deze grootte: er zouden {facets:.2g} driehoeken nodig zijn</translation>
    </message>
    <message>
        <source>absolute positions</source>
        <translation>absolute posities</translation>
    </message>
    <message>
        <source>after {time}</source>
        <translation>na {time}</translation>
    </message>
    <message>
        <source>an object of the unknown type &apos;{type}&apos;</source>
        <translation>een object van het onbekende type &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>an extruder output is set while the arm is moving: it switches at the wrong place, or stops the arm on the bead</source>
        <translation>een extruderuitgang wordt geschakeld terwijl de arm beweegt: hij schakelt op de verkeerde plaats, of stopt de arm op de streng</translation>
    </message>
    <message>
        <source>according to the robot&apos;s controller</source>
        <translation>volgens de besturing van de robot</translation>
    </message>
    <message>
        <source>at {place:.1f}</source>
        <translation>op {place:.1f}</translation>
    </message>
    <message>
        <source>clear this place, or use a larger plate (`--platform`)</source>
        <translation>maak deze plaats vrij, of gebruik een grotere plaat (`--platform`)</translation>
    </message>
    <message>
        <source>close</source>
        <translation>sluiten</translation>
    </message>
    <message>
        <source>open edges were closed: {share:.3g} of the surface is patches</source>
        <translation>open randen zijn gesloten: {share:.3g} van het oppervlak is opgevuld</translation>
    </message>
    <message>
        <source>curved layers</source>
        <translation>gebogen lagen</translation>
    </message>
    <message>
        <source>curved layers on a pedestal</source>
        <translation>gebogen lagen op een sokkel</translation>
    </message>
    <message>
        <source>curved layers with supports</source>
        <translation>gebogen lagen met ondersteuning</translation>
    </message>
    <message>
        <source>decimal commas read as decimal points</source>
        <translation>decimaalkomma&apos;s gelezen als decimale punten</translation>
    </message>
    <message>
        <source>export it as a triangle mesh</source>
        <translation>exporteer het als driehoeksmesh</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>exporteer het met decimale punten</translation>
    </message>
    <message>
        <source>flat layers</source>
        <translation>vlakke lagen</translation>
    </message>
    <message>
        <source>flat layers with supports</source>
        <translation>vlakke lagen met ondersteuning</translation>
    </message>
    <message>
        <source>footprint of the part: {length:.0f} by {width:.0f}, larger than the cell&apos;s largest plate ({plate})</source>
        <translation>grondvlak van het onderdeel: {length:.0f} bij {width:.0f}, groter dan de grootste plaat van de cel ({plate})</translation>
    </message>
    <message>
        <source>has a disc inside another</source>
        <translation>heeft een schijf binnen een andere</translation>
    </message>
    <message>
        <source>contains nothing to print: {what}</source>
        <translation>bevat niets om te printen: {what}</translation>
    </message>
    <message>
        <source>contains sliced G-code (&apos;{member}&apos;) and no model</source>
        <translation>bevat geslicete G-code (&apos;{member}&apos;) en geen model</translation>
    </message>
    <message>
        <source>the counting mode of the filament</source>
        <translation>de telwijze van het filament</translation>
    </message>
    <message>
        <source>parameter {key} no longer exists: its value has no effect</source>
        <translation>parameter {key} bestaat niet meer: de waarde heeft geen effect</translation>
    </message>
    <message>
        <source>parameter {oldKey} was renamed to {key}</source>
        <translation>parameter {oldKey} heet nu {key}</translation>
    </message>
    <message>
        <source>is damaged or truncated UTF-16</source>
        <translation>is beschadigde of afgekapte UTF-16</translation>
    </message>
    <message>
        <source>is UTF-32, which cannot be read</source>
        <translation>is UTF-32, dat niet kan worden gelezen</translation>
    </message>
    <message>
        <source>is not one of the colours: &apos;{name}&apos;</source>
        <translation>is niet een van de kleuren: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>stored as text in an older project: plan again to see remedies</source>
        <translation>in een ouder project als tekst opgeslagen: plan opnieuw om oplossingen te zien</translation>
    </message>
    <message>
        <source>layer height {height}, platform: {platform}</source>
        <translation>laaghoogte {height}, platform: {platform}</translation>
    </message>
    <message>
        <source>layer height {height}, supports: {supports}, platform: {platform}</source>
        <translation>laaghoogte {height}, ondersteuning: {supports}, platform: {platform}</translation>
    </message>
    <message>
        <source>layer {layer}</source>
        <translation>laag {layer}</translation>
    </message>
    <message>
        <source>sheets without thickness were left out: {share:.3g} of the surface, {triangles} triangles</source>
        <translation>bladen zonder dikte zijn weggelaten: {share:.3g} van het oppervlak, {triangles} driehoeken</translation>
    </message>
    <message>
        <source>less than {share:.0f}</source>
        <translation>minder dan {share:.0f}</translation>
    </message>
    <message>
        <source>line {line} of {file}</source>
        <translation>regel {line} van {file}</translation>
    </message>
    <message>
        <source>millimetres as the unit of length</source>
        <translation>millimeter als lengte-eenheid</translation>
    </message>
    <message>
        <source>missing before this line: {statement}</source>
        <translation>ontbreekt vóór deze regel: {statement}</translation>
    </message>
    <message>
        <source>must be a colour like &quot;#d0d4d8&quot;</source>
        <translation>moet een kleur zijn zoals &quot;#d0d4d8&quot;</translation>
    </message>
    <message>
        <source>must be in 1..{most}</source>
        <translation>moet in 1..{most} liggen</translation>
    </message>
    <message>
        <source>must hold as many discs as the first, at least one</source>
        <translation>moet evenveel schijven bevatten als de eerste, minstens één</translation>
    </message>
    <message>
        <source>must hold at least one solid</source>
        <translation>moet minstens één lichaam bevatten</translation>
    </message>
    <message>
        <source>must hold {wanted} values, holds {found}</source>
        <translation>moet {wanted} waarden bevatten, bevat {found}</translation>
    </message>
    <message>
        <source>must not be along the axis</source>
        <translation>mag niet langs de as liggen</translation>
    </message>
    <message>
        <source>must not be before the previous one</source>
        <translation>mag niet vóór het vorige liggen</translation>
    </message>
    <message>
        <source>no available process has narrower beads</source>
        <translation>geen beschikbaar proces heeft smallere strengen</translation>
    </message>
    <message>
        <source>nothing is left: no triangle has area or encloses a volume</source>
        <translation>er blijft niets over: geen driehoek heeft oppervlak of omsluit een volume</translation>
    </message>
    <message>
        <source>nozzle {nozzle}, bead {width#} x {height}</source>
        <translation>nozzle {nozzle}, streng {width#} x {height}</translation>
    </message>
    <message>
        <source>numbers with decimal commas, such as &apos;{number}&apos;, mixed with numbers with decimal points</source>
        <translation>getallen met decimaalkomma&apos;s, zoals &apos;{number}&apos;, gemengd met getallen met decimale punten</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; has a beam lattice clipped by a mesh, which cannot be read</source>
        <translation>object &apos;{id}&apos; heeft een balkenrooster dat door een mesh is afgesneden, en kan niet worden gelezen</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is stored as slices (slicestack), which cannot be read</source>
        <translation>object &apos;{id}&apos; is opgeslagen als plakken (slicestack), en kan niet worden gelezen</translation>
    </message>
    <message>
        <source>change the cell&apos;s file: Edit, Edit cell</source>
        <translation>wijzig het bestand van de cel: Bewerken, Cel bewerken</translation>
    </message>
    <message numerus="yes">
        <source>open surface: {rims} open edge loops, the widest {width:.3g} wide</source>
        <translation>
            <numerusform>open oppervlak: {rims} open randlus, {width:.3g} breed</numerusform>
            <numerusform>open oppervlak: {rims} open randlussen, de breedste {width:.3g} breed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>open surface: it ends at {rims} rims, the widest {width:.3g} wide at {at:.1f}</source>
        <translation>
            <numerusform>open oppervlak: het eindigt bij {rims} rand, {width:.3g} breed bij {at:.1f}</numerusform>
            <numerusform>open oppervlak: het eindigt bij {rims} randen, de breedste {width:.3g} breed bij {at:.1f}</numerusform>
        </translation>
    </message>
    <message>
        <source>open the model that it was sliced from</source>
        <translation>open het model waaruit het is geslicet</translation>
    </message>
    <message>
        <source>to get a solid instead, use `openSurfaces=close`</source>
        <translation>gebruik `openSurfaces=close` om in plaats daarvan een lichaam te krijgen</translation>
    </message>
    <message>
        <source>to get a wall instead, use `openSurfaces=thicken`</source>
        <translation>gebruik `openSurfaces=thicken` om in plaats daarvan een wand te krijgen</translation>
    </message>
    <message>
        <source>to get walls instead, use `openSurfaces=thicken`</source>
        <translation>gebruik `openSurfaces=thicken` om in plaats daarvan wanden te krijgen</translation>
    </message>
    <message>
        <source>pieces with supports</source>
        <translation>vlakke delen met ondersteuning</translation>
    </message>
    <message>
        <source>planned time</source>
        <translation>geplande tijd</translation>
    </message>
    <message>
        <source>print the part at scale {scale}, or use a cell with a larger plate or a platform made for the part</source>
        <translation>print het onderdeel op schaal {scale}, of gebruik een cel met een grotere plaat of een voor het onderdeel gemaakt platform</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>weigeren</translation>
    </message>
    <message numerus="yes">
        <source>removed the self-intersections of {count} components</source>
        <translation>
            <numerusform>zelfdoorsnijdingen van {count} component verwijderd</numerusform>
            <numerusform>zelfdoorsnijdingen van {count} componenten verwijderd</numerusform>
        </translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>sla het op als UTF-8</translation>
    </message>
    <message>
        <source>set it by a trigger of the next motion, or write the program again</source>
        <translation>zet hem met een trigger van de volgende beweging, of schrijf het programma opnieuw</translation>
    </message>
    <message>
        <source>sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles</source>
        <translation>bladmodel: {share:.3g} van het oppervlak heeft geen dikte, {triangles} driehoeken</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} items marked as not printable</source>
        <translation>
            <numerusform>overgeslagen: {count} item gemarkeerd als niet printbaar</numerusform>
            <numerusform>overgeslagen: {count} items gemarkeerd als niet printbaar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;other&apos;, which are not printed</source>
        <translation>
            <numerusform>overgeslagen: {count} object van type &apos;other&apos;, dat niet wordt geprint</numerusform>
            <numerusform>overgeslagen: {count} objecten van type &apos;other&apos;, die niet worden geprint</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;surface&apos;, which are not solids</source>
        <translation>
            <numerusform>overgeslagen: {count} object van type &apos;surface&apos;, dat geen lichaam is</numerusform>
            <numerusform>overgeslagen: {count} objecten van type &apos;surface&apos;, die geen lichamen zijn</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects without a mesh</source>
        <translation>
            <numerusform>overgeslagen: {count} object zonder mesh</numerusform>
            <numerusform>overgeslagen: {count} objecten zonder mesh</numerusform>
        </translation>
    </message>
    <message>
        <source>contains {parts} parts, of which {limit} can be printed</source>
        <translation>bevat {parts} onderdelen, waarvan er {limit} kunnen worden geprint</translation>
    </message>
    <message>
        <source>open it as one part</source>
        <translation>open het als één onderdeel</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} support objects</source>
        <translation>
            <numerusform>overgeslagen: {count} steunobject</numerusform>
            <numerusform>overgeslagen: {count} steunobjecten</numerusform>
        </translation>
    </message>
    <message>
        <source>the PDF could not be created: {why}</source>
        <translation>de PDF kon niet worden gemaakt: {why}</translation>
    </message>
    <message>
        <source>the arm passes this point at {stated:.1f} mm/s with unchanged flow; the path requires {suits:.1f} mm/s</source>
        <translation>de arm passeert dit punt met {stated:.1f} mm/s bij onveranderde doorvoer; de baan vereist {suits:.1f} mm/s</translation>
    </message>
    <message>
        <source>the robot dwells here for {time:.2f} with the hot nozzle touching the part</source>
        <translation>de robot blijft hier {time:.2f} staan terwijl de hete nozzle het onderdeel raakt</translation>
    </message>
    <message>
        <source>the arm&apos;s posture at this target: {found} in the program, {planned} planned</source>
        <translation>de houding van de arm bij dit doel: {found} in het programma, {planned} gepland</translation>
    </message>
    <message>
        <source>choose the bead to resume from on the Simulate page</source>
        <translation>kies op de pagina Simuleren de streng vanaf waar wordt hervat</translation>
    </message>
    <message>
        <source>the rounding distances of corners</source>
        <translation>de afrondingsafstanden van hoeken</translation>
    </message>
    <message>
        <source>the reference run</source>
        <translation>de referentierun</translation>
    </message>
    <message>
        <source>see the remedies of the findings before this one</source>
        <translation>zie de oplossingen van de bevindingen vóór deze</translation>
    </message>
    <message>
        <source>the frame of the targets</source>
        <translation>het assenstelsel van de doelen</translation>
    </message>
    <message>
        <source>the full flow</source>
        <translation>de volle doorvoer</translation>
    </message>
    <message>
        <source>the mechanical unit</source>
        <translation>de mechanische eenheid</translation>
    </message>
    <message>
        <source>the message says how to fix it</source>
        <translation>de melding zegt hoe het te verhelpen is</translation>
    </message>
    <message>
        <source>the part as printed, every bead laid</source>
        <translation>het onderdeel zoals geprint, elke streng gelegd</translation>
    </message>
    <message>
        <source>no room on the plate for the prime: a bead {length:.0f} long is printed in the air beside the plate and falls down here</source>
        <translation>geen ruimte op de plaat om te primen: een streng van {length:.0f} lang wordt naast de plaat in de lucht geprint en valt hier naar beneden</translation>
    </message>
    <message>
        <source>the program does not match this plan: changing the plan does not help</source>
        <translation>het programma komt niet overeen met dit plan: het plan wijzigen helpt niet</translation>
    </message>
    <message>
        <source>the range of the flow output</source>
        <translation>het bereik van de doorvoeruitgang</translation>
    </message>
    <message>
        <source>self-intersecting surface: {share:.3g} of the enclosed volume is inside out and counts as outside</source>
        <translation>zichzelf doorsnijdend oppervlak: {share:.3g} van het omsloten volume is binnenstebuiten en telt als buiten</translation>
    </message>
    <message>
        <source>the nozzle temperature, °C</source>
        <translation>de nozzletemperatuur, °C</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>verdikken</translation>
    </message>
    <message>
        <source>one wall</source>
        <translation>één wand</translation>
    </message>
    <message>
        <source>Print as one wall</source>
        <translation>Als één wand printen</translation>
    </message>
    <message>
        <source>One bead wide, centred on the surface; its rims stay open</source>
        <translation>Eén streng breed, gecentreerd op het oppervlak; de randen blijven open</translation>
    </message>
    <message>
        <source>print it as one wall (`openSurfaces=wall`), thicken it to a wall of two beads (`openSurfaces=thicken`), close its rims to make it solid (`openSurfaces=close`), or close it in a modelling program</source>
        <translation>print het als één wand (`openSurfaces=wall`), verdik het tot een wand van twee strengen (`openSurfaces=thicken`), sluit de randen om het massief te maken (`openSurfaces=close`), of sluit het in een modelleerprogramma</translation>
    </message>
    <message>
        <source>print the sheets as walls of one bead (`openSurfaces=wall`) or two (`openSurfaces=thicken`), or give them a thickness in a modelling program</source>
        <translation>print de bladen als wanden van één streng (`openSurfaces=wall`) of twee (`openSurfaces=thicken`), of geef ze dikte in een modelleerprogramma</translation>
    </message>
    <message>
        <source>thicken the surface in a modelling program</source>
        <translation>verdik het oppervlak in een modelleerprogramma</translation>
    </message>
    <message>
        <source>the open surface was thickened to a wall of {wall:.2f}, half on each side</source>
        <translation>het open oppervlak is verdikt tot een wand van {wall:.2f}, de helft aan elke kant</translation>
    </message>
    <message>
        <source>thicken it to a wall of two beads (`openSurfaces=thicken`), or repair it in a modelling program</source>
        <translation>verdik het tot een wand van twee strengen (`openSurfaces=thicken`), of herstel het in een modelleerprogramma</translation>
    </message>
    <message>
        <source>the open surface crosses itself at {places} pairs of triangles, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>het open oppervlak kruist zichzelf bij {places} paren driehoeken, het eerste bij ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface has only one side: it is twisted along {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>het open oppervlak heeft maar één kant: het is gedraaid langs {edges} randen, de eerste bij ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface branches at {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>het open oppervlak vertakt zich bij {edges} randen, de eerste bij ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>to get a wall of two beads instead, use `openSurfaces=thicken`</source>
        <translation>gebruik `openSurfaces=thicken` om in plaats daarvan een wand van twee strengen te krijgen</translation>
    </message>
    <message>
        <source>the open surface is printed as one wall, one bead ({width:.2f}) wide</source>
        <translation>het open oppervlak wordt geprint als één wand, één streng ({width:.2f}) breed</translation>
    </message>
    <message numerus="yes">
        <source>converted {count} lattice beams into round bars</source>
        <translation>
            <numerusform>{count} roosterbalk omgezet in een ronde staaf</numerusform>
            <numerusform>{count} roosterbalken omgezet in ronde staven</numerusform>
        </translation>
    </message>
    <message>
        <source>{bytes} bytes</source>
        <translation>{bytes} bytes</translation>
    </message>
    <message>
        <source>{hours} h {minutes} min</source>
        <translation>{hours} h {minutes} min</translation>
    </message>
    <message numerus="yes">
        <source>{layers} layers, {way}</source>
        <translation>
            <numerusform>{layers} laag, {way}</numerusform>
            <numerusform>{layers} lagen, {way}</numerusform>
        </translation>
    </message>
    <message>
        <source>{least:.0f#} to {most:.0f}</source>
        <translation>{least:.0f#} tot {most:.0f}</translation>
    </message>
    <message>
        <source>{mass:.1f} g, supports and waste included</source>
        <translation>{mass:.1f} g, inclusief ondersteuning en afval</translation>
    </message>
    <message>
        <source>{material}, {volume:.1f} cm3 at {density:.2f} g/cm3</source>
        <translation>{material}, {volume:.1f} cm3 met {density:.2f} g/cm3</translation>
    </message>
    <message>
        <source>{minutes} min {seconds} s</source>
        <translation>{minutes} min {seconds} s</translation>
    </message>
    <message>
        <source>{part}, {x:.1f#} x {y:.1f#} x {z:.1f}</source>
        <translation>{part}, {x:.1f#} x {y:.1f#} x {z:.1f}</translation>
    </message>
    <message>
        <source>{seconds} s</source>
        <translation>{seconds} s</translation>
    </message>
    <message>
        <source>at least {share:.0f} filled</source>
        <translation>minstens {share:.0f} gevuld</translation>
    </message>
    <message>
        <source>{statement}: {found} in the program, {planned} planned</source>
        <translation>{statement}: {found} in het programma, {planned} gepland</translation>
    </message>
    <message>
        <source>{time} on its controller</source>
        <translation>{time} op zijn besturing</translation>
    </message>
    <message>
        <source>{way}, {height} each</source>
        <translation>{way}, elk {height}</translation>
    </message>
    <message>
        <source>a cut of the tape</source>
        <translation>een snede van de tape</translation>
    </message>
    <message>
        <source>a pause for the operator</source>
        <translation>een pauze voor de operator</translation>
    </message>
    <message>
        <source>a tool change</source>
        <translation>een gereedschapswissel</translation>
    </message>
    <message>
        <source>feeding in place</source>
        <translation>toevoer in stilstand</translation>
    </message>
    <message>
        <source>is above 1</source>
        <translation>is groter dan 1</translation>
    </message>
    <message>
        <source>mode {mode} needs a rod, but cell {cell} has none</source>
        <translation>bouwwijze {mode} heeft een staaf nodig, maar cel {cell} heeft er geen</translation>
    </message>
    <message>
        <source>must be #RRGGBB</source>
        <translation>moet #RRGGBB zijn</translation>
    </message>
    <message>
        <source>nothing in this file is executed</source>
        <translation>niets in dit bestand wordt uitgevoerd</translation>
    </message>
    <message>
        <source>one</source>
        <translation>één</translation>
    </message>
    <message>
        <source>the report has no item</source>
        <translation>het rapport bevat geen onderdeel</translation>
    </message>
    <message>
        <source>unknown material &apos;{id}&apos;</source>
        <translation>onbekend materiaal &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>events of unequal number</source>
        <translation>ongelijk aantal gebeurtenissen</translation>
    </message>
    <message>
        <source>Share of the interior that is filled: the whole is solid, none is hollow. Walls and skins are always solid.</source>
        <translation>Aandeel van het binnenste dat wordt gevuld: het geheel is massief, niets is hol. Wanden en huiden zijn altijd massief.</translation>
    </message>
    <message>
        <source>sparse pattern</source>
        <translation>patroon van open vulling</translation>
    </message>
    <message>
        <source>Pattern of the interior if it is not solid.</source>
        <translation>Patroon van het binnenste als dat niet massief is.</translation>
    </message>
    <message>
        <source>top layers</source>
        <translation>bovenlagen</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface above it.</source>
        <translation>Massieve lagen tussen het open binnenste en het oppervlak erboven.</translation>
    </message>
    <message>
        <source>bottom layers</source>
        <translation>onderlagen</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface below it.</source>
        <translation>Massieve lagen tussen het open binnenste en het oppervlak eronder.</translation>
    </message>
    <message>
        <source>skin thickness</source>
        <translation>huiddikte</translation>
    </message>
    <message>
        <source>Minimum thickness of the top and bottom layers together with their number.</source>
        <translation>Minimale dikte van de boven- en onderlagen, naast hun aantal.</translation>
    </message>
    <message>
        <source>gyroid</source>
        <translation>gyroïde</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>lijnen</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>raster</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>driehoeken</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>honeycomb</source>
        <translation>honingraat</translation>
    </message>
    <message>
        <source>unknown sparse infill &apos;{id}&apos;</source>
        <translation>onbekende open vulling &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>Open vulling</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Brug</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Tape</translation>
    </message>
    <message>
        <source>tapes after every n-th layer</source>
        <translation>tapes na elke n-de laag</translation>
    </message>
    <message>
        <source>Irons tapes of continuous fibre onto every n-th layer but the last; needs a tool for tape. 0: no tapes.</source>
        <translation>Strijkt tapes van continue vezel op elke n-de laag behalve de laatste; vereist een gereedschap voor tape. 0: geen tapes.</translation>
    </message>
    <message>
        <source>first layer with tapes</source>
        <translation>eerste laag met tapes</translation>
    </message>
    <message>
        <source>Layers are counted from 1, on the platform.</source>
        <translation>Lagen worden geteld vanaf 1, op het platform.</translation>
    </message>
    <message>
        <source>tapes on a layer</source>
        <translation>tapes op een laag</translation>
    </message>
    <message>
        <source>Only the longest tapes of each layer are laid. 0: as many as fit.</source>
        <translation>Alleen de langste tapes van elke laag worden gelegd. 0: zoveel als er passen.</translation>
    </message>
    <message>
        <source>paths of tapes</source>
        <translation>banen van tapes</translation>
    </message>
    <message>
        <source>Tapes lie beside each other, one width apart.</source>
        <translation>Tapes liggen naast elkaar, één breedte uit elkaar.</translation>
    </message>
    <message>
        <source>direction of tapes</source>
        <translation>richting van tapes</translation>
    </message>
    <message>
        <source>Direction of tapes on the first layer with tapes, measured from x to y.</source>
        <translation>Richting van tapes op de eerste laag met tapes, gemeten van x naar y.</translation>
    </message>
    <message>
        <source>rotation of tapes per layer</source>
        <translation>draaiing van tapes per laag</translation>
    </message>
    <message>
        <source>Rotation from one layer with tapes to the next.</source>
        <translation>Draaiing van een laag met tapes naar de volgende.</translation>
    </message>
    <message>
        <source>distance of tape ends</source>
        <translation>afstand van tape-uiteinden</translation>
    </message>
    <message>
        <source>Least distance of the ends of tapes from the outline, so that plastic encloses them. The sides are inside the outline.</source>
        <translation>Kleinste afstand van de uiteinden van tapes tot de omtrek, zodat kunststof ze omsluit. De zijkanten liggen binnen de omtrek.</translation>
    </message>
    <message>
        <source>curves for tapes</source>
        <translation>krommen voor tapes</translation>
    </message>
    <message>
        <source>For tapes along given curves: points x,y or x,y,z in mm on the plate, separated by spaces, and semicolons between curves; or a file of them.</source>
        <translation>Voor tapes langs gegeven krommen: punten x,y of x,y,z in mm op de plaat, gescheiden door spaties, met puntkomma&apos;s tussen krommen; of een bestand ermee.</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Vezel</translation>
    </message>
    <message>
        <source>along a field of directions</source>
        <translation>langs een richtingsveld</translation>
    </message>
    <message>
        <source>there is no field of directions for tapes</source>
        <translation>er is geen richtingsveld voor tapes</translation>
    </message>
    <message>
        <source>give place and direction as x,y,z,dx,dy,dz, separated by spaces or lines</source>
        <translation>geef plaats en richting als x,y,z,dx,dy,dz, gescheiden door spaties of regels</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no direction at a place</source>
        <translation>&apos;{part}&apos; is geen richting op een plaats</translation>
    </message>
    <message>
        <source>field of tape directions</source>
        <translation>veld van taperichtingen</translation>
    </message>
    <message>
        <source>For tapes along a field: x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them.</source>
        <translation>Voor tapes langs een veld: x,y,z,dx,dy,dz in mm op de plaat, gescheiden door spaties of regels, of een bestand ermee.</translation>
    </message>
    <message>
        <source>in one direction</source>
        <translation>in één richting</translation>
    </message>
    <message>
        <source>along the outline</source>
        <translation>langs de omtrek</translation>
    </message>
    <message>
        <source>along given curves</source>
        <translation>langs gegeven krommen</translation>
    </message>
    <message>
        <source>unknown paths of tapes &apos;{id}&apos;</source>
        <translation>onbekende banen van tapes &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>give points in mm: x,y or x,y,z, separated by spaces, at least two for each curve, and semicolons between curves</source>
        <translation>geef punten in mm: x,y of x,y,z, gescheiden door spaties, minstens twee per kromme, met puntkomma&apos;s tussen krommen</translation>
    </message>
    <message>
        <source>no tool of the job lays tape</source>
        <translation>geen gereedschap van de opdracht legt tape</translation>
    </message>
    <message>
        <source>add a tool with a process for tape, such as tape-5, or set `fibreLayers=0`</source>
        <translation>voeg een gereedschap met een proces voor tape toe, zoals tape-5, of stel `fibreLayers=0` in</translation>
    </message>
    <message>
        <source>process {process} lays tape and prints no beads</source>
        <translation>proces {process} legt tape en print geen strengen</translation>
    </message>
    <message>
        <source>choose it for a further tool, and another one for the part</source>
        <translation>kies het voor een extra gereedschap, en een ander voor het onderdeel</translation>
    </message>
    <message>
        <source>no tape fits into the layers chosen for tapes: {width} wide and at least {length:.0f} long</source>
        <translation>er past geen tape in de voor tapes gekozen lagen: {width} breed en minstens {length:.0f} lang</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`), other paths (`fibrePaths`), or a narrower tape</source>
        <translation>kies een andere richting (`fibreAngle`), andere banen (`fibrePaths`), of een smallere tape</translation>
    </message>
    <message>
        <source>{bent:.0f} of tape is left out because it bends more than a radius of {radius:.0f} allows, {short:.0f} because its pieces are shorter than {length:.0f}</source>
        <translation>{bent:.0f} tape is weggelaten omdat die sterker buigt dan een straal van {radius:.0f} toelaat, {short:.0f} omdat de stukken korter zijn dan {length:.0f}</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`) or other paths (`fibrePaths`)</source>
        <translation>kies een andere richting (`fibreAngle`) of andere banen (`fibrePaths`)</translation>
    </message>
    <message>
        <source>plastic does not cover the tape: {length:.0f} on layer {layer}, from this place on</source>
        <translation>kunststof bedekt de tape niet: {length:.0f} op laag {layer}, vanaf deze plaats</translation>
    </message>
    <message>
        <source>increase `fibreEndMm`, or choose layers that others cover (`fibreLayers`, `fibreFirstLayer`)</source>
        <translation>vergroot `fibreEndMm`, of kies lagen die door andere worden bedekt (`fibreLayers`, `fibreFirstLayer`)</translation>
    </message>
    <message>
        <source>is not less than &apos;widthMm&apos;</source>
        <translation>is niet kleiner dan &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is less than half of &apos;widthMm&apos;</source>
        <translation>is kleiner dan de helft van &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is not less than &apos;leastLengthMm&apos;</source>
        <translation>is niet kleiner dan &apos;leastLengthMm&apos;</translation>
    </message>
    <message numerus="yes">
        <source>the skins above a hollow interior have nothing to rest on: {paths} beads, from this place on</source>
        <translation>
            <numerusform>de huiden boven een hol binnenste rusten nergens op: {paths} streng, vanaf deze plaats</numerusform>
            <numerusform>de huiden boven een hol binnenste rusten nergens op: {paths} strengen, vanaf deze plaats</numerusform>
        </translation>
    </message>
    <message>
        <source>set `infillDensity` to 0.1 or more; for a part that is open at the top, set `topLayers` to 0</source>
        <translation>stel `infillDensity` in op 0.1 of meer; stel voor een onderdeel dat bovenaan open is `topLayers` in op 0</translation>
    </message>
    <message>
        <source>thin walls</source>
        <translation>dunne wanden</translation>
    </message>
    <message>
        <source>as the narrowest bead</source>
        <translation>als de smalste streng</translation>
    </message>
    <message>
        <source>leave out</source>
        <translation>weglaten</translation>
    </message>
    <message>
        <source>Walls narrower than the narrowest bead: printed as that bead, and so too wide, or left out. Below half its width they are always left out.</source>
        <translation>Wanden smaller dan de smalste streng: geprint als die streng, en dus te breed, of weggelaten. Onder de helft van die breedte worden ze altijd weggelaten.</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is printed too wide: with the narrowest bead, {bead:.3g}</source>
        <translation>{length:.0f} wand, tot {width:.2f} dun, wordt te breed geprint: met de smalste streng, {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or leave them out (`thinWalls=omit`)</source>
        <translation>gebruik een fijnere nozzle, of laat ze weg (`thinWalls=omit`)</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is left out: the narrowest bead is {bead:.3g}</source>
        <translation>{length:.0f} wand, tot {width:.2f} dun, is weggelaten: de smalste streng is {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print them with that bead (`thinWalls=bead`)</source>
        <translation>gebruik een fijnere nozzle, of print ze met die streng (`thinWalls=bead`)</translation>
    </message>
    <message>
        <source>use thinner layers, or a part with steeper walls; another spiral may begin there</source>
        <translation>gebruik dunnere lagen, of een onderdeel met steilere wanden; daar kan een andere spiraal beginnen</translation>
    </message>
    <message>
        <source>the spiral ends below layer {layer} of {layers}, which does not continue the layer before</source>
        <translation>de spiraal eindigt onder laag {layer} van {layers}, die de vorige laag niet voortzet</translation>
    </message>
    <message>
        <source>print towers as separate items, or cut off the part there; layers of several beads are printed as usual</source>
        <translation>print torens als aparte items, of snijd het onderdeel daar af; lagen met meerdere strengen worden zoals gewoonlijk geprint</translation>
    </message>
    <message numerus="yes">
        <source>the spiral ends below layer {layer} of {layers}: it has {beads} beads, not one closed loop</source>
        <translation>
            <numerusform>de spiraal eindigt onder laag {layer} van {layers}: die heeft {beads} streng, niet één gesloten lus</numerusform>
            <numerusform>de spiraal eindigt onder laag {layer} van {layers}: die heeft {beads} strengen, niet één gesloten lus</numerusform>
        </translation>
    </message>
    <message>
        <source>{first} and {second} overlap</source>
        <translation>{first} en {second} overlappen</translation>
    </message>
    <message>
        <source>arrange the parts</source>
        <translation>schik de onderdelen</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or arrange them</source>
        <translation>verplaats een van de onderdelen op de pagina Voorbereiden, of schik ze</translation>
    </message>
    <message>
        <source>the head may touch {first} or {second} beside the other one: they are {gap:.1f} apart, the head needs {needed:.1f}</source>
        <translation>de kop raakt mogelijk {first} of {second} naast het andere: ze staan {gap:.1f} uit elkaar, de kop heeft {needed:.1f} nodig</translation>
    </message>
    <message>
        <source>{share:.2g} of {first} cannot be printed layer by layer: its layers tilt the head into {second}</source>
        <translation>{share:.2g} van {first} kan niet laag voor laag worden geprint: de lagen ervan kantelen de kop in {second}</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or print one after another</source>
        <translation>verplaats een van de onderdelen op de pagina Voorbereiden, of print ze na elkaar</translation>
    </message>
    <message>
        <source>print one after another, or move {second} by {move:.0f}</source>
        <translation>print ze na elkaar, of verplaats {second} met {move:.0f}</translation>
    </message>
    <message>
        <source>print one after another</source>
        <translation>na elkaar printen</translation>
    </message>
    <message>
        <source>move {second} by {move:.0f}</source>
        <translation>verplaats {second} met {move:.0f}</translation>
    </message>
    <message>
        <source>print them as separate jobs</source>
        <translation>print ze als aparte opdrachten</translation>
    </message>
    <message>
        <source>the flange carries {carried:.3g} kg, {material:.3g} kg of it printed material; the robot is rated for {most:.3g} kg</source>
        <translation>de flens draagt {carried:.3g} kg, waarvan {material:.3g} kg geprint materiaal; de robot is bedoeld voor {most:.3g} kg</translation>
    </message>
    <message>
        <source>print a smaller part, or with less infill, or use a stronger robot</source>
        <translation>print een kleiner onderdeel, of met minder vulling, of gebruik een sterkere robot</translation>
    </message>
    <message>
        <source>choose a cell with a stronger robot on the Prepare page</source>
        <translation>kies op de pagina Voorbereiden een cel met een sterkere robot</translation>
    </message>
    <message>
        <source>is above {limit:.0f}</source>
        <translation>is meer dan {limit:.0f}</translation>
    </message>
    <message>
        <source>is longer than maxLayerTimeS</source>
        <translation>is langer dan maxLayerTimeS</translation>
    </message>
    <message>
        <source>`maxLayerTimeS={greatest:.0f}` is shorter than the {least:.0f} that {material} has to cool</source>
        <translation>`maxLayerTimeS={greatest:.0f}` is korter dan de {least:.0f} die {material} nodig heeft om af te koelen</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than the {greatest:.0f} in which {material} bonds</source>
        <translation>`minLayerTimeS={least:.0f}` is langer dan de {greatest:.0f} waarin {material} hecht</translation>
    </message>
    <message>
        <source>give a longer maximum, or another material</source>
        <translation>geef een langer maximum, of een ander materiaal</translation>
    </message>
    <message>
        <source>give a shorter minimum, or another material</source>
        <translation>geef een korter minimum, of een ander materiaal</translation>
    </message>
    <message>
        <source>arrange the parts, or print them layer by layer</source>
        <translation>schik de onderdelen, of print ze laag voor laag</translation>
    </message>
    <message>
        <source>Print layer by layer</source>
        <translation>Laag voor laag printen</translation>
    </message>
    <message>
        <source>All parts grow together, so that no finished part is in the way</source>
        <translation>Alle onderdelen groeien samen, zodat geen voltooid onderdeel in de weg staat</translation>
    </message>
    <message>
        <source>the plate has no room for {parts} parts</source>
        <translation>de plaat heeft geen ruimte voor {parts} onderdelen</translation>
    </message>
    <message>
        <source>print fewer or smaller parts, or use a cell with a larger plate</source>
        <translation>print minder of kleinere onderdelen, of gebruik een cel met een grotere plaat</translation>
    </message>
    <message>
        <source>a spiral is printed alone</source>
        <translation>een spiraal wordt alleen geprint</translation>
    </message>
    <message>
        <source>remove the other parts, or set spiral to false</source>
        <translation>verwijder de andere onderdelen, of zet spiral op false</translation>
    </message>
    <message>
        <source>a part around a rod or on a body is printed alone</source>
        <translation>een onderdeel rond een staaf of op een lichaam wordt alleen geprint</translation>
    </message>
    <message>
        <source>remove the other parts, or choose a way of building on a plate</source>
        <translation>verwijder de andere onderdelen, of kies een bouwwijze op een plaat</translation>
    </message>
    <message>
        <source>{parts} parts are too many for a job</source>
        <translation>{parts} onderdelen zijn te veel voor een opdracht</translation>
    </message>
    <message>
        <source>print up to {most} parts</source>
        <translation>print hoogstens {most} onderdelen</translation>
    </message>
    <message>
        <source>a part on a ground of its own is printed alone</source>
        <translation>een onderdeel op een eigen ondergrond wordt alleen geprint</translation>
    </message>
    <message>
        <source>remove the other parts, or give `pathsOn=plate`</source>
        <translation>verwijder de andere onderdelen, of geef `pathsOn=plate`</translation>
    </message>
    <message>
        <source>different for each part</source>
        <translation>verschillend per onderdeel</translation>
    </message>
    <message>
        <source>the bed temperature, °C</source>
        <translation>de bedtemperatuur, °C</translation>
    </message>
    <message>
        <source>a wait until the bed is hot</source>
        <translation>wachten tot het bed heet is</translation>
    </message>
    <message>
        <source>must be at most {most}</source>
        <translation>mag hoogstens {most} zijn</translation>
    </message>
    <message>
        <source>must be one line that is not empty</source>
        <translation>moet één regel zijn die niet leeg is</translation>
    </message>
    <message>
        <source>has no statements</source>
        <translation>heeft geen instructies</translation>
    </message>
    <message>
        <source>has its statements already</source>
        <translation>heeft zijn instructies al</translation>
    </message>
    <message>
        <source>must be between {least} and 1</source>
        <translation>moet tussen {least} en 1 liggen</translation>
    </message>
    <message>
        <source>a wait for the extruder&apos;s start lag</source>
        <translation>wachten op de startvertraging van de extruder</translation>
    </message>
    <message>
        <source>stopping the extruder ahead of a bead&apos;s end</source>
        <translation>uitschakelen van de extruder vóór het einde van een streng</translation>
    </message>
    <message>
        <source>extruder {extruder} cannot keep the start and stop lag of process {process}</source>
        <translation>extruder {extruder} kan de start- en stopvertraging van proces {process} niet aanhouden</translation>
    </message>
    <message>
        <source>turning off the nozzle&apos;s heating</source>
        <translation>uitschakelen van de verwarming van de nozzle</translation>
    </message>
    <message>
        <source>turning off the bed&apos;s heating</source>
        <translation>uitschakelen van de verwarming van het bed</translation>
    </message>
    <message>
        <source>part cooling {found} % from this line on, {planned} % planned</source>
        <translation>onderdeelkoeling {found} % vanaf deze regel, {planned} % gepland</translation>
    </message>
    <message>
        <source>is above 250</source>
        <translation>is meer dan 250</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a material&apos;s id</source>
        <translation>&apos;{id}&apos; kan niet de id van een materiaal zijn</translation>
    </message>
    <message>
        <source>use small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>gebruik kleine letters, cijfers, &apos;-&apos;, &apos;_&apos; en &apos;.&apos;</translation>
    </message>
    <message>
        <source>a material &apos;{id}&apos; comes with the program</source>
        <translation>een materiaal &apos;{id}&apos; wordt met het programma meegeleverd</translation>
    </message>
    <message>
        <source>choose another id</source>
        <translation>kies een andere id</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Koeling</translation>
    </message>
    <message>
        <source>minimum layer time</source>
        <translation>minimale laagtijd</translation>
    </message>
    <message>
        <source>Minimum time before a bead is covered by the next layer, at every place. The robot waits above the part where the order of the beads does not give them this time. 0: no limit.</source>
        <translation>Minimale tijd voordat een streng door de volgende laag wordt bedekt, op elke plaats. De robot wacht boven het onderdeel waar de volgorde van de strengen die tijd niet geeft. 0: geen grens.</translation>
    </message>
    <message>
        <source>maximum layer time</source>
        <translation>maximale laagtijd</translation>
    </message>
    <message>
        <source>Age up to which a bead still bonds with the one above it. Older places are reported. 0: no limit.</source>
        <translation>Leeftijd tot welke een streng nog hecht aan die erboven. Oudere plaatsen worden gemeld. 0: geen grens.</translation>
    </message>
    <message>
        <source>a wait</source>
        <translation>een wachttijd</translation>
    </message>
    <message>
        <source>lower the minimum layer time, print slower, or print without a spiral</source>
        <translation>verlaag de minimale laagtijd, print langzamer, of print zonder spiraal</translation>
    </message>
    <message>
        <source>only you know how long a bead has to cool: change the minimum layer time</source>
        <translation>alleen jij weet hoelang een streng moet afkoelen: wijzig de minimale laagtijd</translation>
    </message>
    <message>
        <source>the bead below is {time:.1f} old when it is covered, beyond the maximum layer time of {limit:.1f}; so are {length:.0f} of beads</source>
        <translation>de streng eronder is {time:.1f} oud wanneer hij wordt bedekt, voorbij de maximale laagtijd van {limit:.1f}; zo ook {length:.0f} streng</translation>
    </message>
    <message>
        <source>print faster, or fewer parts at a time</source>
        <translation>print sneller, of minder onderdelen tegelijk</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average; at least {limit:.0f} required.</source>
        <translation>Tijd tussen lagen: {shortest:.1f} tot {longest:.1f} op zijn besturing, gemiddeld {mean:.1f}; minstens {limit:.0f} vereist.</translation>
    </message>
    <message>
        <source>Layer time</source>
        <translation>Laagtijd</translation>
    </message>
    <message>
        <source>slowest speed for cooling</source>
        <translation>laagste snelheid voor koeling</translation>
    </message>
    <message>
        <source>Down to this speed beads are printed slower to keep the minimum layer time, before the robot waits. 0: it only waits.</source>
        <translation>Tot deze snelheid worden strengen langzamer geprint om de minimale laagtijd aan te houden, voordat de robot wacht. 0: hij wacht alleen.</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average.</source>
        <translation>Tijd tussen lagen: {shortest:.1f} tot {longest:.1f} op zijn besturing, gemiddeld {mean:.1f}.</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than `maxLayerTimeS={greatest:.0f}`</source>
        <translation>`minLayerTimeS={least:.0f}` is langer dan `maxLayerTimeS={greatest:.0f}`</translation>
    </message>
    <message>
        <source>give a shorter minimum, or a longer maximum</source>
        <translation>geef een korter minimum, of een langer maximum</translation>
    </message>
    <message>
        <source>#RRGGBB, for the view.</source>
        <translation>#RRGGBB, voor de weergave.</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a process&apos;s id</source>
        <translation>&apos;{id}&apos; kan niet de id van een proces zijn</translation>
    </message>
    <message>
        <source>0: as in the process.</source>
        <translation>0: zoals in het proces.</translation>
    </message>
    <message>
        <source>Beads are nowhere narrower.</source>
        <translation>Strengen zijn nergens smaller.</translation>
    </message>
    <message>
        <source>Beads are nowhere wider.</source>
        <translation>Strengen zijn nergens breder.</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Bruggen</translation>
    </message>
    <message>
        <source>Colder nozzles do not print it.</source>
        <translation>Koudere nozzles printen het niet.</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thicker.</source>
        <translation>Gebogen lagen zijn nergens dikker.</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thinner.</source>
        <translation>Gebogen lagen zijn nergens dunner.</translation>
    </message>
    <message>
        <source>Density of the printed material.</source>
        <translation>Dichtheid van het geprinte materiaal.</translation>
    </message>
    <message>
        <source>Diameter of the nozzle&apos;s opening.</source>
        <translation>Diameter van de opening van de nozzle.</translation>
    </message>
    <message>
        <source>Distance of waypoints along a tool-path.</source>
        <translation>Afstand tussen baanpunten langs een gereedschapsbaan.</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Extruder</translation>
    </message>
    <message>
        <source>Factor of the bead&apos;s section.</source>
        <translation>Factor van de strengdoorsnede.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Elementen</translation>
    </message>
    <message>
        <source>Flow at full scale of the analogue output.</source>
        <translation>Doorvoer bij volle uitslag van de analoge uitgang.</translation>
    </message>
    <message>
        <source>For people, for example how to dry it.</source>
        <translation>Voor mensen, bijvoorbeeld hoe het te drogen.</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kop</translation>
    </message>
    <message>
        <source>Height and radius of its sections, in mm.</source>
        <translation>Hoogte en straal van de doorsneden, in mm.</translation>
    </message>
    <message>
        <source>Hotter nozzles damage it.</source>
        <translation>Hetere nozzles beschadigen het.</translation>
    </message>
    <message>
        <source>How deep the head may enter soft beads before it is a collision.</source>
        <translation>Hoe diep de kop in zachte strengen mag komen voordat het een botsing is.</translation>
    </message>
    <message>
        <source>In your currency. 0: unknown.</source>
        <translation>In je eigen valuta. 0: onbekend.</translation>
    </message>
    <message>
        <source>Length of filament that is retracted for a travel. 0: none.</source>
        <translation>Filamentlengte die voor een verplaatsing wordt ingetrokken. 0: geen.</translation>
    </message>
    <message>
        <source>Length that a bead bridges, unless the process states it.</source>
        <translation>Lengte die een streng overbrugt, tenzij het proces die geeft.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Material that the process prints.</source>
        <translation>Materiaal dat het proces print.</translation>
    </message>
    <message>
        <source>Maximum acceleration of the nozzle.</source>
        <translation>Maximale versnelling van de nozzle.</translation>
    </message>
    <message>
        <source>Maximum length of an unsupported bridge.</source>
        <translation>Maximale lengte van een niet ondersteunde brug.</translation>
    </message>
    <message>
        <source>Maximum speed on a bridge.</source>
        <translation>Maximale snelheid op een brug.</translation>
    </message>
    <message>
        <source>Melted at most, whatever the process allows.</source>
        <translation>Hoogstens gesmolten, wat het proces ook toestaat.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Overige</translation>
    </message>
    <message>
        <source>Part cooling from the second layer on, 0 to 1.</source>
        <translation>Onderdeelkoeling vanaf de tweede laag, 0 tot 1.</translation>
    </message>
    <message>
        <source>Part cooling of bridges, 0 to 1.</source>
        <translation>Onderdeelkoeling van bruggen, 0 tot 1.</translation>
    </message>
    <message>
        <source>Shown in lists and reports.</source>
        <translation>Getoond in lijsten en rapporten.</translation>
    </message>
    <message>
        <source>Speed of the nozzle between tool-paths.</source>
        <translation>Snelheid van de nozzle tussen gereedschapsbanen.</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Snelheden</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Temperaturen</translation>
    </message>
    <message>
        <source>The extruder runs this long before a tool-path begins.</source>
        <translation>De extruder loopt zo lang voordat een gereedschapsbaan begint.</translation>
    </message>
    <message>
        <source>Usual height of a layer, and of a bead.</source>
        <translation>Gebruikelijke hoogte van een laag, en van een streng.</translation>
    </message>
    <message>
        <source>Usual speed of the nozzle while it prints.</source>
        <translation>Gebruikelijke snelheid van de nozzle tijdens het printen.</translation>
    </message>
    <message>
        <source>Usual temperature of the nozzle.</source>
        <translation>Gebruikelijke temperatuur van de nozzle.</translation>
    </message>
    <message>
        <source>Usual temperature of the plate.</source>
        <translation>Gebruikelijke temperatuur van de plaat.</translation>
    </message>
    <message>
        <source>Usual width of a bead.</source>
        <translation>Gebruikelijke breedte van een streng.</translation>
    </message>
    <message>
        <source>Whatever the process allows.</source>
        <translation>Wat het proces ook toestaat.</translation>
    </message>
    <message>
        <source>a process &apos;{id}&apos; comes with the program</source>
        <translation>een proces &apos;{id}&apos; wordt met het programma meegeleverd</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>versnelling</translation>
    </message>
    <message>
        <source>any</source>
        <translation>willekeurig</translation>
    </message>
    <message>
        <source>as elsewhere</source>
        <translation>zoals elders</translation>
    </message>
    <message>
        <source>as in the process</source>
        <translation>zoals in het proces</translation>
    </message>
    <message>
        <source>block height</source>
        <translation>blokhoogte</translation>
    </message>
    <message>
        <source>block width</source>
        <translation>blokbreedte</translation>
    </message>
    <message>
        <source>bridge flow</source>
        <translation>doorvoer van bruggen</translation>
    </message>
    <message>
        <source>bridge length in bead widths</source>
        <translation>bruglengte in strengbreedtes</translation>
    </message>
    <message>
        <source>bridge speed</source>
        <translation>snelheid van bruggen</translation>
    </message>
    <message>
        <source>cannot be deleted</source>
        <translation>kan niet worden verwijderd</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>kleur</translation>
    </message>
    <message>
        <source>cone angle</source>
        <translation>kegelhoek</translation>
    </message>
    <message>
        <source>cone angle must be below 180°</source>
        <translation>kegelhoek moet kleiner zijn dan 180°</translation>
    </message>
    <message>
        <source>cone height</source>
        <translation>kegelhoogte</translation>
    </message>
    <message>
        <source>contact tolerance</source>
        <translation>contacttolerantie</translation>
    </message>
    <message>
        <source>density</source>
        <translation>dichtheid</translation>
    </message>
    <message>
        <source>export the head with its nozzle pointing down</source>
        <translation>exporteer de kop met de nozzle omlaag gericht</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>ventilator</translation>
    </message>
    <message>
        <source>fan on bridges</source>
        <translation>ventilator bij bruggen</translation>
    </message>
    <message>
        <source>first-layer flow</source>
        <translation>doorvoer van de eerste laag</translation>
    </message>
    <message>
        <source>first-layer width</source>
        <translation>breedte van de eerste laag</translation>
    </message>
    <message>
        <source>infill flow</source>
        <translation>doorvoer van de vulling</translation>
    </message>
    <message>
        <source>inner-wall flow</source>
        <translation>doorvoer van de binnenwanden</translation>
    </message>
    <message>
        <source>is above 1000</source>
        <translation>is meer dan 1000</translation>
    </message>
    <message>
        <source>is above 30 g/cm3: check the unit</source>
        <translation>is meer dan 30 g/cm3: controleer de eenheid</translation>
    </message>
    <message>
        <source>is above {most} {unit}: check the unit</source>
        <translation>is meer dan {most} {unit}: controleer de eenheid</translation>
    </message>
    <message>
        <source>is below 1</source>
        <translation>is kleiner dan 1</translation>
    </message>
    <message>
        <source>is {usual}, above &apos;max&apos;, which is {most}</source>
        <translation>is {usual}, boven &apos;max&apos;, dat {most} is</translation>
    </message>
    <message>
        <source>is {usual}, below &apos;min&apos;, which is {least}</source>
        <translation>is {usual}, onder &apos;min&apos;, dat {least} is</translation>
    </message>
    <message>
        <source>label</source>
        <translation>label</translation>
    </message>
    <message>
        <source>longest bridge</source>
        <translation>langste brug</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiaal</translation>
    </message>
    <message>
        <source>maximum bead width</source>
        <translation>maximale strengbreedte</translation>
    </message>
    <message>
        <source>maximum flow</source>
        <translation>maximale doorvoer</translation>
    </message>
    <message>
        <source>maximum layer height</source>
        <translation>maximale laaghoogte</translation>
    </message>
    <message>
        <source>maximum nozzle temperature</source>
        <translation>maximale nozzletemperatuur</translation>
    </message>
    <message>
        <source>minimum bead width</source>
        <translation>minimale strengbreedte</translation>
    </message>
    <message>
        <source>minimum layer height</source>
        <translation>minimale laaghoogte</translation>
    </message>
    <message>
        <source>minimum nozzle temperature</source>
        <translation>minimale nozzletemperatuur</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>mag niet leeg zijn</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>notities</translation>
    </message>
    <message>
        <source>nozzle diameter</source>
        <translation>nozzlediameter</translation>
    </message>
    <message>
        <source>nozzle temperature</source>
        <translation>nozzletemperatuur</translation>
    </message>
    <message>
        <source>nozzle tip radius</source>
        <translation>straal van de nozzlepunt</translation>
    </message>
    <message>
        <source>outer-wall flow</source>
        <translation>doorvoer van de buitenwand</translation>
    </message>
    <message>
        <source>outer-wall width</source>
        <translation>breedte van de buitenwand</translation>
    </message>
    <message>
        <source>plate temperature</source>
        <translation>plaattemperatuur</translation>
    </message>
    <message>
        <source>price per kg</source>
        <translation>prijs per kg</translation>
    </message>
    <message>
        <source>prime time</source>
        <translation>primetijd</translation>
    </message>
    <message>
        <source>print speed</source>
        <translation>printsnelheid</translation>
    </message>
    <message>
        <source>reduce angle or height of the cone</source>
        <translation>verklein hoek of hoogte van de kegel</translation>
    </message>
    <message>
        <source>retraction length</source>
        <translation>intreklengte</translation>
    </message>
    <message>
        <source>sparse-infill flow</source>
        <translation>doorvoer van de open vulling</translation>
    </message>
    <message>
        <source>sparse-infill speed</source>
        <translation>snelheid van de open vulling</translation>
    </message>
    <message>
        <source>support flow</source>
        <translation>doorvoer van de ondersteuning</translation>
    </message>
    <message>
        <source>support width</source>
        <translation>breedte van de ondersteuning</translation>
    </message>
    <message>
        <source>the cone is {cone} wide at its top, more than the block&apos;s corners, {block}</source>
        <translation>de kegel is bovenaan {cone} breed, meer dan de hoeken van het blok, {block}</translation>
    </message>
    <message>
        <source>the mesh is flat: it has no height along z</source>
        <translation>de mesh is vlak: hij heeft geen hoogte langs z</translation>
    </message>
    <message>
        <source>travel speed</source>
        <translation>verplaatsingssnelheid</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>onbekend</translation>
    </message>
    <message>
        <source>waypoint distance</source>
        <translation>afstand van baanpunten</translation>
    </message>
    <message>
        <source>{name} must be greater than 0</source>
        <translation>{name} moet groter zijn dan 0</translation>
    </message>
    <message>
        <source>&apos;Pause&apos; does not wait for the motions before it (QueueTag)</source>
        <translation>&apos;Pause&apos; wacht niet op de bewegingen ervoor (QueueTag)</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of tools</source>
        <translation>&apos;{text}&apos; is geen lijst van gereedschappen</translation>
    </message>
    <message>
        <source>Material that flows out at the place of the tool change after each change of the tool.</source>
        <translation>Materiaal dat op de plaats van de gereedschapswissel uitvloeit na elke wissel van het gereedschap.</translation>
    </message>
    <message>
        <source>Mode planar: numbers of the tools that print the pieces, separated by commas. The list starts over if there are more pieces. Empty: the tool of the part.</source>
        <translation>Bouwwijze vlakke delen: nummers van de gereedschappen die de delen printen, gescheiden door komma&apos;s. De lijst begint opnieuw als er meer delen zijn. Leeg: het gereedschap van het onderdeel.</translation>
    </message>
    <message>
        <source>Number of the tool that fills the interior within walls and skins; 0: that of the part.</source>
        <translation>Nummer van het gereedschap dat het binnenste binnen wanden en huiden vult; 0: dat van het onderdeel.</translation>
    </message>
    <message>
        <source>Number of the tool that prints supports; 0: that of the part.</source>
        <translation>Nummer van het gereedschap dat ondersteuning print; 0: dat van het onderdeel.</translation>
    </message>
    <message>
        <source>Number of the tool that prints the part. The tips of all tools are in one place, that of the cell&apos;s nozzle.</source>
        <translation>Nummer van het gereedschap dat het onderdeel print. De punten van alle gereedschappen liggen op één plaats, die van de nozzle van de cel.</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Gereedschapswissels</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Gereedschappen</translation>
    </message>
    <message>
        <source>a purge of the nozzle</source>
        <translation>spoelen van de nozzle</translation>
    </message>
    <message>
        <source>a tool is selected together with a command</source>
        <translation>een gereedschap wordt samen met een commando gekozen</translation>
    </message>
    <message>
        <source>add a tool, or give the number of one</source>
        <translation>voeg een gereedschap toe, of geef het nummer van een bestaand</translation>
    </message>
    <message>
        <source>are those of a changer</source>
        <translation>zijn die van een wisselaar</translation>
    </message>
    <message>
        <source>cannot be changer: the nozzle does not move</source>
        <translation>kan geen changer zijn: de nozzle beweegt niet</translation>
    </message>
    <message>
        <source>cell {cell} has no dock for tool {tool}</source>
        <translation>cel {cell} heeft geen dock voor gereedschap {tool}</translation>
    </message>
    <message>
        <source>give numbers, such as 1,2</source>
        <translation>geef getallen, zoals 1,2</translation>
    </message>
    <message>
        <source>give up to {most}</source>
        <translation>geef er hoogstens {most}</translation>
    </message>
    <message>
        <source>locking the tool</source>
        <translation>vergrendelen van het gereedschap</translation>
    </message>
    <message>
        <source>the selection of the first tool</source>
        <translation>de keuze van het eerste gereedschap</translation>
    </message>
    <message>
        <source>the tool that the program begins with</source>
        <translation>het gereedschap waarmee het programma begint</translation>
    </message>
    <message>
        <source>before {event}</source>
        <translation>vóór {event}</translation>
    </message>
    <message>
        <source>behind {event}</source>
        <translation>na {event}</translation>
    </message>
    <message>
        <source>the time for {event}</source>
        <translation>de tijd voor {event}</translation>
    </message>
    <message>
        <source>the text of the stop</source>
        <translation>de tekst van de stop</translation>
    </message>
    <message>
        <source>a motion that begins with no tool</source>
        <translation>een beweging die zonder gereedschap begint</translation>
    </message>
    <message>
        <source>the output of a tool is not set: an earlier run may have left it on</source>
        <translation>de uitgang van een gereedschap is niet gezet: een eerdere run heeft hem mogelijk aan gelaten</translation>
    </message>
    <message>
        <source>the arm does not get to the place for purges without a collision</source>
        <translation>de arm komt niet zonder botsing op de spoelplaats</translation>
    </message>
    <message>
        <source>move the place or the part</source>
        <translation>verplaats de plaats of het onderdeel</translation>
    </message>
    <message>
        <source>the nozzle does not move</source>
        <translation>de nozzle beweegt niet</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the {body}</source>
        <translation>{volume:.0f} van primen of spoelen valt op: {body}</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the plate, beside the print</source>
        <translation>{volume:.0f} van primen of spoelen valt op de plaat, naast de print</translation>
    </message>
    <message>
        <source>state a place for purges in the cell (purgeMm), or move the part</source>
        <translation>geef in de cel een spoelplaats op (purgeMm), of verplaats het onderdeel</translation>
    </message>
    <message>
        <source>remove the strand before it is dragged along, or state a place for purges in the cell (purgeMm)</source>
        <translation>verwijder de draad voordat hij wordt meegesleept, of geef in de cel een spoelplaats op (purgeMm)</translation>
    </message>
    <message>
        <source>print</source>
        <translation>print</translation>
    </message>
    <message>
        <source>workpiece</source>
        <translation>werkstuk</translation>
    </message>
    <message>
        <source>the arm does not reach the place for purges</source>
        <translation>de arm bereikt de spoelplaats niet</translation>
    </message>
    <message>
        <source>the arm collides at the place for purges</source>
        <translation>de arm botst op de spoelplaats</translation>
    </message>
    <message>
        <source>move the place for purges</source>
        <translation>verplaats de spoelplaats</translation>
    </message>
    <message>
        <source>move the dock or the part</source>
        <translation>verplaats het dock of het onderdeel</translation>
    </message>
    <message>
        <source>must be hand, feeder or changer</source>
        <translation>moet hand, feeder of changer zijn</translation>
    </message>
    <message>
        <source>purge</source>
        <translation>spoelen</translation>
    </message>
    <message>
        <source>releasing the tool</source>
        <translation>ontgrendelen van het gereedschap</translation>
    </message>
    <message>
        <source>remove a tool, or choose another cell</source>
        <translation>verwijder een gereedschap, of kies een andere cel</translation>
    </message>
    <message>
        <source>the arm does not get to the dock of tool {number} without a collision</source>
        <translation>de arm komt niet zonder botsing bij het dock van gereedschap {number}</translation>
    </message>
    <message>
        <source>the extruder {extruder} prints with one tool</source>
        <translation>de extruder {extruder} print met één gereedschap</translation>
    </message>
    <message>
        <source>the job has no tool {number}, it has {tools}</source>
        <translation>de opdracht heeft geen gereedschap {number}, wel {tools}</translation>
    </message>
    <message>
        <source>the outputs of several tools are on</source>
        <translation>de uitgangen van meerdere gereedschappen zijn aan</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>gereedschap</translation>
    </message>
    <message>
        <source>tool {number} cannot print layers of {height}</source>
        <translation>gereedschap {number} kan geen lagen van {height} printen</translation>
    </message>
    <message>
        <source>tool {number}: {material}, {process}, {mass:.1f} g</source>
        <translation>gereedschap {number}: {material}, {process}, {mass:.1f} g</translation>
    </message>
    <message>
        <source>tools of the pieces</source>
        <translation>gereedschappen van de delen</translation>
    </message>
    <message>
        <source>{changes}, {mass:.1f} g purged</source>
        <translation>{changes}, {mass:.1f} g gespoeld</translation>
    </message>
    <message>
        <source>{tools} tools are too many for a job</source>
        <translation>{tools} gereedschappen zijn te veel voor een opdracht</translation>
    </message>
    <message>
        <source>export it in millimetres</source>
        <translation>exporteer het in millimeters</translation>
    </message>
    <message>
        <source>the mesh is only {height} high</source>
        <translation>de mesh is maar {height} hoog</translation>
    </message>
    <message>
        <source>Layer times</source>
        <translation>Laagtijden</translation>
    </message>
    <message>
        <source>Time that a bead needs before the next layer covers it, unless the job states it.</source>
        <translation>Tijd die een streng nodig heeft voordat de volgende laag hem bedekt, tenzij de opdracht die geeft.</translation>
    </message>
    <message>
        <source>Age up to which a bead bonds with the next layer, unless the job states it.</source>
        <translation>Leeftijd tot welke een streng hecht aan de volgende laag, tenzij de opdracht die geeft.</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Injectie</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Steken</translation>
    </message>
    <message>
        <source>spacing of stitches</source>
        <translation>afstand van steken</translation>
    </message>
    <message>
        <source>Mode flat: distance of pockets that are filled from above in one shot and lock the layers together. 0: none.</source>
        <translation>Bouwwijze vlakke lagen: afstand van pockets die van boven in één injectie worden gevuld en de lagen aan elkaar verankeren. 0: geen.</translation>
    </message>
    <message>
        <source>diameter of stitches</source>
        <translation>diameter van steken</translation>
    </message>
    <message>
        <source>stitches after every n-th layer</source>
        <translation>steken na elke n-de laag</translation>
    </message>
    <message>
        <source>Pockets end at the top of these layers.</source>
        <translation>Pockets eindigen aan de bovenkant van deze lagen.</translation>
    </message>
    <message>
        <source>stitches need horizontal layers</source>
        <translation>steken vereisen horizontale lagen</translation>
    </message>
    <message>
        <source>set `stitchSpacing=0`, or give no `layerPlanes`</source>
        <translation>stel `stitchSpacing=0` in, of geef geen `layerPlanes`</translation>
    </message>
    <message>
        <source>excess of a shot</source>
        <translation>overmaat van een injectie</translation>
    </message>
    <message>
        <source>Material of a shot beyond the volume of its pocket, as a share of that volume.</source>
        <translation>Materiaal van een injectie boven het volume van haar pocket, als aandeel van dat volume.</translation>
    </message>
    <message>
        <source>nozzle depth of a shot</source>
        <translation>nozzlediepte van een injectie</translation>
    </message>
    <message>
        <source>Depth of the nozzle in the pocket; 0: it seals the opening.</source>
        <translation>Diepte van de nozzle in de pocket; 0: hij dicht de opening af.</translation>
    </message>
    <message>
        <source>flow of a shot</source>
        <translation>doorvoer van een injectie</translation>
    </message>
    <message>
        <source>Flow into a pocket, at most that of the process. 0: as much.</source>
        <translation>Doorvoer in een pocket, hoogstens die van het proces. 0: evenveel.</translation>
    </message>
    <message>
        <source>wait after a shot</source>
        <translation>wachttijd na een injectie</translation>
    </message>
    <message>
        <source>Time that the nozzle stays in the pocket after the shot, so that the material does not come out again.</source>
        <translation>Tijd dat de nozzle na de injectie in de pocket blijft, zodat het materiaal er niet weer uit komt.</translation>
    </message>
    <message>
        <source>a shot into a pocket</source>
        <translation>een injectie in een pocket</translation>
    </message>
    <message>
        <source>Trace on a surface</source>
        <translation>Spoor op een oppervlak</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Spoor</translation>
    </message>
    <message>
        <source>find the seam</source>
        <translation>naad zoeken</translation>
    </message>
    <message>
        <source>the part has no surface within {angle} of the vertical that is wide enough for a seam</source>
        <translation>het onderdeel heeft binnen {angle} van de verticaal geen oppervlak dat breed genoeg is voor een naad</translation>
    </message>
    <message>
        <source>turn the part, or increase `traceAngle`</source>
        <translation>draai het onderdeel, of vergroot `traceAngle`</translation>
    </message>
    <message>
        <source>greatest angle of the traced surface</source>
        <translation>grootste hoek van het gevolgde oppervlak</translation>
    </message>
    <message>
        <source>Mode trace: the seam is the outline of the part&apos;s surface whose normal is within this angle of the vertical.</source>
        <translation>Bouwwijze spoor: de naad is de omtrek van het oppervlak van het onderdeel waarvan de normaal binnen deze hoek van de verticaal ligt.</translation>
    </message>
    <message>
        <source>inset of the seam</source>
        <translation>inzet van de naad</translation>
    </message>
    <message>
        <source>Distance of the first bead from the outline, inwards, seen from above.</source>
        <translation>Afstand van de eerste streng tot de omtrek, naar binnen, van boven gezien.</translation>
    </message>
    <message>
        <source>seams</source>
        <translation>naden</translation>
    </message>
    <message>
        <source>Number of beads from the outline inwards.</source>
        <translation>Aantal strengen vanaf de omtrek naar binnen.</translation>
    </message>
    <message>
        <source>side passes</source>
        <translation>zijgangen</translation>
    </message>
    <message>
        <source>Number of beads on the side of the part, below the outline.</source>
        <translation>Aantal strengen op de zijkant van het onderdeel, onder de omtrek.</translation>
    </message>
    <message>
        <source>depth of side passes</source>
        <translation>diepte van zijgangen</translation>
    </message>
    <message>
        <source>Height of the outline above the first side pass.</source>
        <translation>Hoogte van de omtrek boven de eerste zijgang.</translation>
    </message>
    <message>
        <source>lines at heel and toe</source>
        <translation>lijnen bij hiel en teen</translation>
    </message>
    <message>
        <source>Number of parallel beads that fill each of the two ends inside the innermost seam.</source>
        <translation>Aantal evenwijdige strengen dat elk van de twee uiteinden binnen de binnenste naad vult.</translation>
    </message>
    <message>
        <source>angle of lines</source>
        <translation>hoek van lijnen</translation>
    </message>
    <message>
        <source>Angle of the lines at heel and toe to the x axis, seen from above.</source>
        <translation>Hoek van de lijnen bij hiel en teen met de x-as, van boven gezien.</translation>
    </message>
    <message>
        <source>dovetail</source>
        <translation>zwaluwstaart</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>kegel</translation>
    </message>
    <message>
        <source>shape of stitches</source>
        <translation>vorm van steken</translation>
    </message>
    <message>
        <source>Dovetail: chamber, cone and opening, three quarters of the diameter high. Cone: half of the diameter high.</source>
        <translation>Zwaluwstaart: kamer, kegel en opening, driekwart van de diameter hoog. Kegel: de helft van de diameter hoog.</translation>
    </message>
    <message>
        <source>Diameter of a pocket where it is widest. Its opening is half of it wide.</source>
        <translation>Diameter van een pocket op het breedste punt. De opening is half zo breed.</translation>
    </message>
    <message>
        <source>process {process} has no statements (beadWords) for format {format}, which its beads need</source>
        <translation>proces {process} heeft geen instructies (beadWords) voor formaat {format}, die zijn strengen nodig hebben</translation>
    </message>
    <message>
        <source>use {formats}, or add the statements to the process</source>
        <translation>gebruik {formats}, of voeg de instructies aan het proces toe</translation>
    </message>
    <message>
        <source>beadWords: &apos;{word}&apos; is not a word for a force</source>
        <translation>beadWords: &apos;{word}&apos; is geen woord voor een kracht</translation>
    </message>
    <message>
        <source>write {pressFrame}, {pressSpace}, {press 5} or {pressAxis 20}</source>
        <translation>schrijf {pressFrame}, {pressSpace}, {press 5} of {pressAxis 20}</translation>
    </message>
    <message>
        <source>the nozzle of cell {cell} is along no axis of the arm&apos;s base, so that MELFA cannot press along it</source>
        <translation>de nozzle van cel {cell} ligt langs geen as van de basis van de arm, zodat MELFA er niet langs kan drukken</translation>
    </message>
    <message>
        <source>use a cell whose nozzle is upright, or another format</source>
        <translation>gebruik een cel met een rechtopstaande nozzle, of een ander formaat</translation>
    </message>
    <message>
        <source>find the skeleton</source>
        <translation>skelet zoeken</translation>
    </message>
    <message>
        <source>pith</source>
        <translation>merg</translation>
    </message>
    <message>
        <source>the part is not closed</source>
        <translation>het onderdeel is niet gesloten</translation>
    </message>
    <message>
        <source>the part has no limbs</source>
        <translation>het onderdeel heeft geen takken</translation>
    </message>
    <message>
        <source>use infill that is dense along the part&apos;s middle (`sparsePattern=pith`)</source>
        <translation>gebruik vulling die dicht is langs het midden van het onderdeel (`sparsePattern=pith`)</translation>
    </message>
    <message>
        <source>the limbs of the pith cannot be joined</source>
        <translation>de takken van het merg kunnen niet worden verbonden</translation>
    </message>
    <message>
        <source>change the pith&apos;s share</source>
        <translation>wijzig het aandeel van het merg</translation>
    </message>
    <message>
        <source>the pith cannot be cut at the part&apos;s surface</source>
        <translation>het merg kan niet bij het oppervlak van het onderdeel worden afgesneden</translation>
    </message>
    <message>
        <source>distance of seams</source>
        <translation>afstand van naden</translation>
    </message>
    <message>
        <source>Distance between beads, seen from above. 0: the bead&apos;s width.</source>
        <translation>Afstand tussen strengen, van boven gezien. 0: de strengbreedte.</translation>
    </message>
    <message>
        <source>radius of the outline&apos;s hull</source>
        <translation>straal van de omhullende van de omtrek</translation>
    </message>
    <message>
        <source>Gaps of the outline through which no disc of this radius passes are closed.</source>
        <translation>Openingen in de omtrek waar geen schijf met deze straal door past, worden gesloten.</translation>
    </message>
    <message>
        <source>Hard plastic</source>
        <translation>Harde kunststof</translation>
    </message>
    <message>
        <source>Soft plastic</source>
        <translation>Zachte kunststof</translation>
    </message>
    <message>
        <source>the cutter has no diameter or no teeth</source>
        <translation>de frees heeft geen diameter of geen tanden</translation>
    </message>
    <message>
        <source>give --cutter and --teeth above 0</source>
        <translation>geef --cutter en --teeth groter dan 0</translation>
    </message>
    <message>
        <source>a distance of passes is not positive</source>
        <translation>een afstand van gangen is niet positief</translation>
    </message>
    <message>
        <source>give distances above 0</source>
        <translation>geef afstanden groter dan 0</translation>
    </message>
    <message>
        <source>the block is less than the cutter&apos;s {diameter} wider than the part</source>
        <translation>het blok is minder dan de {diameter} van de frees breder dan het onderdeel</translation>
    </message>
    <message>
        <source>increase --gap</source>
        <translation>vergroot --gap</translation>
    </message>
    <message>
        <source>unknown word {word}</source>
        <translation>onbekend woord {word}</translation>
    </message>
    <message>
        <source>a motion before {word}</source>
        <translation>een beweging vóór {word}</translation>
    </message>
    <message>
        <source>G53 with another position than Z0 is not understood</source>
        <translation>G53 met een andere positie dan Z0 wordt niet begrepen</translation>
    </message>
    <message>
        <source>the block turns while the cutter is not home</source>
        <translation>het blok draait terwijl de frees niet in de uitgangsstand is</translation>
    </message>
    <message>
        <source>the block is turned by neither 0 nor 180 degrees</source>
        <translation>het blok wordt niet 0 of 180 graden gedraaid</translation>
    </message>
    <message>
        <source>coordinates of another side</source>
        <translation>coördinaten van een andere kant</translation>
    </message>
    <message>
        <source>a rapid move through the block</source>
        <translation>een ijlgang door het blok</translation>
    </message>
    <message>
        <source>the spindle has another speed than planned</source>
        <translation>de spil heeft een andere snelheid dan gepland</translation>
    </message>
    <message>
        <source>another feed than planned</source>
        <translation>andere voeding dan gepland</translation>
    </message>
    <message>
        <source>{volume:.0f} of the block stay in slots, undercuts or holes that should be free, up to {height:.1f} high</source>
        <translation>{volume:.0f} van het blok blijft staan in sleuven, ondersnijdingen of gaten die vrij moeten zijn, tot {height:.1f} hoog</translation>
    </message>
    <message>
        <source>only you know which cutter and block you have: change the values of the passes</source>
        <translation>alleen jij weet welke frees en welk blok je hebt: wijzig de waarden van de gangen</translation>
    </message>
    <message>
        <source>the cutter takes up to {depth:.3f} from the part</source>
        <translation>de frees neemt tot {depth:.3f} van het onderdeel weg</translation>
    </message>
    <message>
        <source>the way home</source>
        <translation>de weg naar de uitgangsstand</translation>
    </message>
    <message>
        <source>&apos;{place}&apos; is no place</source>
        <translation>&apos;{place}&apos; is geen plaats</translation>
    </message>
    <message>
        <source>give X,Y,Z in mm and a rotation about z in degrees, as in 900,0,0,180</source>
        <translation>geef X,Y,Z in mm en een draaiing om z in graden, zoals in 900,0,0,180</translation>
    </message>
    <message>
        <source>the job has no motion</source>
        <translation>de opdracht heeft geen beweging</translation>
    </message>
    <message>
        <source>looking for an order of work</source>
        <translation>een werkvolgorde wordt gezocht</translation>
    </message>
    <message>
        <source>{count} jobs: two to {most} machines can work together</source>
        <translation>{count} opdrachten: twee tot {most} machines kunnen samenwerken</translation>
    </message>
    <message>
        <source>machine {machine} waits in line {line} for a mark that the other does not reach</source>
        <translation>machine {machine} wacht in regel {line} op een markering die de andere niet bereikt</translation>
    </message>
    <message>
        <source>machine {machine} passes the mark in line {line} before machine {other} has reached it, if signals are still on or the programs are not started at once</source>
        <translation>machine {machine} passeert de markering in regel {line} voordat machine {other} haar heeft bereikt, als signalen nog aan staan of de programma&apos;s niet tegelijk worden gestart</translation>
    </message>
    <message>
        <source>machine {machine}: {reason}</source>
        <translation>machine {machine}: {reason}</translation>
    </message>
    <message>
        <source>name a folder that &apos;together&apos; wrote</source>
        <translation>noem een map die &apos;together&apos; heeft geschreven</translation>
    </message>
    <message>
        <source>comparing the motions of the machines</source>
        <translation>de bewegingen van de machines worden vergeleken</translation>
    </message>
    <message>
        <source>running all programs in one time</source>
        <translation>alle programma&apos;s worden in één tijd uitgevoerd</translation>
    </message>
    <message>
        <source>a mark for the other machine</source>
        <translation>een markering voor de andere machine</translation>
    </message>
    <message>
        <source>an input is read while motions are queued</source>
        <translation>een ingang wordt gelezen terwijl er bewegingen in de wachtrij staan</translation>
    </message>
    <message>
        <source>dense at the pith</source>
        <translation>dicht bij het merg</translation>
    </message>
    <message>
        <source>mean step height</source>
        <translation>gemiddelde trapjeshoogte</translation>
    </message>
    <message>
        <source>Mean step
mm</source>
        <translation>Gem. trapje
mm</translation>
    </message>
    <message>
        <source>greatest step height</source>
        <translation>grootste trapjeshoogte</translation>
    </message>
    <message>
        <source>Greatest
step mm</source>
        <translation>Grootste
trapje mm</translation>
    </message>
    <message>
        <source>angle between beads and load</source>
        <translation>hoek tussen strengen en belasting</translation>
    </message>
    <message>
        <source>Bead
angle °</source>
        <translation>Streng-
hoek °</translation>
    </message>
    <message>
        <source>interfaces across the load</source>
        <translation>grensvlakken dwars op de belasting</translation>
    </message>
    <message>
        <source>Inter-
faces %</source>
        <translation>Grens-
vlakken %</translation>
    </message>
    <message>
        <source>interfaces in the weakest section</source>
        <translation>grensvlakken in de zwakste doorsnede</translation>
    </message>
    <message>
        <source>Weakest
% interf.</source>
        <translation>Zwakste
% grensvl.</translation>
    </message>
    <message>
        <source>is below {least}</source>
        <translation>is kleiner dan {least}</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Maten</translation>
    </message>
    <message>
        <source>size factor along x</source>
        <translation>maatfactor langs x</translation>
    </message>
    <message>
        <source>Flat layers are made larger by it, so that printed lengths are right. 1: none.</source>
        <translation>Vlakke lagen worden hiermee vergroot, zodat geprinte lengtes kloppen. 1: geen.</translation>
    </message>
    <message>
        <source>size factor along y</source>
        <translation>maatfactor langs y</translation>
    </message>
    <message>
        <source>As along x.</source>
        <translation>Zoals langs x.</translation>
    </message>
    <message>
        <source>outline offset</source>
        <translation>verschuiving van de omtrek</translation>
    </message>
    <message>
        <source>Outlines of flat layers move outwards by it.</source>
        <translation>Omtrekken van vlakke lagen schuiven hiermee naar buiten.</translation>
    </message>
    <message>
        <source>hole offset</source>
        <translation>verschuiving van gaten</translation>
    </message>
    <message>
        <source>Contours of holes in flat layers move into the material by it.</source>
        <translation>Contouren van gaten in vlakke lagen schuiven hiermee het materiaal in.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Sterkte</translation>
    </message>
    <message>
        <source>direction of the load</source>
        <translation>richting van de belasting</translation>
    </message>
    <message>
        <source>the job has no motion to compare with</source>
        <translation>de opdracht heeft geen beweging om mee te vergelijken</translation>
    </message>
    <message>
        <source>give rows such as: length x 50 49.8; slot y 5 4.8; hole 10 9.6</source>
        <translation>geef rijen zoals: length x 50 49.8; slot y 5 4.8; hole 10 9.6</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a size</source>
        <translation>&apos;{word}&apos; is geen maat</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a kind of size</source>
        <translation>&apos;{word}&apos; is geen soort maat</translation>
    </message>
    <message>
        <source>not a kind, an axis and two sizes</source>
        <translation>niet een soort, een as en twee maten</translation>
    </message>
    <message>
        <source>{measured} is too far from {nominal}</source>
        <translation>{measured} ligt te ver van {nominal}</translation>
    </message>
    <message>
        <source>{key} would be {value}, beyond {least} to {most}</source>
        <translation>{key} zou {value} zijn, buiten {least} tot {most}</translation>
    </message>
    <message>
        <source>check the measured sizes</source>
        <translation>controleer de gemeten maten</translation>
    </message>
    <message>
        <source>no measured sizes</source>
        <translation>geen gemeten maten</translation>
    </message>
    <message>
        <source>aligning</source>
        <translation>uitlijnen</translation>
    </message>
    <message>
        <source>path</source>
        <translation>baan</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>snelheid</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>doorvoer</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>ontbrekend</translation>
    </message>
    <message>
        <source>the record does not come near the planned path</source>
        <translation>de opname komt niet in de buurt van de geplande baan</translation>
    </message>
    <message>
        <source>choose the project and the cell that it was recorded with</source>
        <translation>kies het project en de cel waarmee is opgenomen</translation>
    </message>
    <message>
        <source>{found} joints are recorded, the cell has {wanted} axes</source>
        <translation>er zijn {found} gewrichten opgenomen, de cel heeft {wanted} assen</translation>
    </message>
    <message>
        <source>record all axes, external ones included</source>
        <translation>neem alle assen op, ook externe</translation>
    </message>
    <message>
        <source>poses of the TCP do not contain the external axes</source>
        <translation>poses van het TCP bevatten de externe assen niet</translation>
    </message>
    <message>
        <source>record the joints of all axes</source>
        <translation>neem de gewrichten van alle assen op</translation>
    </message>
    <message>
        <source>the pose of the TCP is incomplete</source>
        <translation>de pose van het TCP is onvolledig</translation>
    </message>
    <message>
        <source>record actual_q or all of actual_TCP_pose</source>
        <translation>neem actual_q of heel actual_TCP_pose op</translation>
    </message>
    <message>
        <source>column &apos;{name}&apos; is missing</source>
        <translation>kolom &apos;{name}&apos; ontbreekt</translation>
    </message>
    <message>
        <source>record X, Y, Z, A, B and C, or all joints</source>
        <translation>neem X, Y, Z, A, B en C op, of alle gewrichten</translation>
    </message>
    <message>
        <source>RTDE of Universal Robots</source>
        <translation>RTDE van Universal Robots</translation>
    </message>
    <message>
        <source>monitor of MELFA</source>
        <translation>monitor van MELFA</translation>
    </message>
    <message>
        <source>table of joints</source>
        <translation>tabel met gewrichten</translation>
    </message>
    <message>
        <source>no joints and no pose of the TCP among the columns</source>
        <translation>geen gewrichten en geen pose van het TCP onder de kolommen</translation>
    </message>
    <message>
        <source>record actual_q (RTDE), X to C (MELFA) or j1_deg, j2_deg ...</source>
        <translation>neem actual_q (RTDE), X tot C (MELFA) of j1_deg, j2_deg ... op</translation>
    </message>
    <message>
        <source>no column of times</source>
        <translation>geen kolom met tijden</translation>
    </message>
    <message>
        <source>name it timestamp, time_s or time_ms</source>
        <translation>noem die timestamp, time_s of time_ms</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>minder dan twee meetpunten</translation>
    </message>
    <message>
        <source>record the whole run</source>
        <translation>neem de hele run op</translation>
    </message>
    <message>
        <source>no number in column &apos;{column}&apos;</source>
        <translation>geen getal in kolom &apos;{column}&apos;</translation>
    </message>
    <message>
        <source>{found} values in a row instead of {wanted}, as there are names</source>
        <translation>{found} waarden in een rij in plaats van {wanted}, zoveel als er namen zijn</translation>
    </message>
    <message>
        <source>no rows of numbers below a row of names</source>
        <translation>geen rijen met getallen onder een rij met namen</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a direction</source>
        <translation>&apos;{text}&apos; is geen richting</translation>
    </message>
    <message>
        <source>give x,y,z, for example 1,0,0</source>
        <translation>geef x,y,z, bijvoorbeeld 1,0,0</translation>
    </message>
    <message>
        <source>the job waits for another machine at marks</source>
        <translation>de opdracht wacht bij markeringen op een andere machine</translation>
    </message>
    <message>
        <source>resume the job from which it was made, and print its rest alone</source>
        <translation>hervat de opdracht waaruit ze is gemaakt, en print de rest ervan alleen</translation>
    </message>
    <message>
        <source>milling passes</source>
        <translation>freesgangen</translation>
    </message>
    <message>
        <source>milling the block</source>
        <translation>het blok wordt gefreesd</translation>
    </message>
    <message>
        <source>another motion than planned</source>
        <translation>andere beweging dan gepland</translation>
    </message>
    <message>
        <source>laying the part down</source>
        <translation>het onderdeel wordt neergelegd</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>negative volume</source>
        <translation>negatief volume</translation>
    </message>
    <message>
        <source>modifier volume</source>
        <translation>modificatorvolume</translation>
    </message>
    <message>
        <source>support enforcer</source>
        <translation>ondersteuning afdwingen</translation>
    </message>
    <message>
        <source>support blocker</source>
        <translation>ondersteuning blokkeren</translation>
    </message>
    <message>
        <source>not used: extruder {number} of &apos;{object}&apos; ({where}): choose the tool of the part</source>
        <translation>niet gebruikt: extruder {number} van &apos;{object}&apos; ({where}): kies het gereedschap van het onderdeel</translation>
    </message>
    <message>
        <source>not used: settings of &apos;{object}&apos; ({where}): {keys}</source>
        <translation>niet gebruikt: instellingen van &apos;{object}&apos; ({where}): {keys}</translation>
    </message>
    <message>
        <source>not used: the slice stack of object &apos;{id}&apos; ({where}): its mesh is printed</source>
        <translation>niet gebruikt: de plakkenstapel van object &apos;{id}&apos; ({where}): de mesh ervan wordt geprint</translation>
    </message>
    <message>
        <source>cut away: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>weggesneden: {kind} &apos;{name}&apos; van &apos;{object}&apos;, het midden op {place} in het bestand</translation>
    </message>
    <message>
        <source>not used: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>niet gebruikt: {kind} &apos;{name}&apos; van &apos;{object}&apos;, het midden op {place} in het bestand</translation>
    </message>
    <message>
        <source>read although its namespace is &apos;{space}&apos; and not that of 3MF ({where})</source>
        <translation>gelezen hoewel de namespace &apos;{space}&apos; is en niet die van 3MF ({where})</translation>
    </message>
    <message>
        <source>not used: materials and colours of objects and triangles, more than one from line {line} of {where}</source>
        <translation>niet gebruikt: materialen en kleuren van objecten en driehoeken, meer dan één, vanaf regel {line} van {where}</translation>
    </message>
    <message>
        <source>M200 changes the meaning of E between beads</source>
        <translation>M200 wijzigt de betekenis van E tussen strengen</translation>
    </message>
    <message>
        <source>export the whole file with lengths of filament, or with volumes</source>
        <translation>exporteer het hele bestand met filamentlengtes, of met volumes</translation>
    </message>
    <message>
        <source>purge lines beside the part are left out: {volume:.0f} from line {line} on</source>
        <translation>spoellijnen naast het onderdeel zijn weggelaten: {volume:.0f} vanaf regel {line}</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as the setting use_volumetric_e of the file says</source>
        <translation>hoeveelheden worden als volumes opgevat, zoals de instelling use_volumetric_e van het bestand aangeeft</translation>
    </message>
    <message>
        <source>the negative volume &apos;{negative}&apos; cannot be cut out of &apos;{part}&apos;: their meshes are not closed or intersect themselves</source>
        <translation>het negatieve volume &apos;{negative}&apos; kan niet uit &apos;{part}&apos; worden gesneden: hun meshes zijn niet gesloten of doorsnijden zichzelf</translation>
    </message>
    <message>
        <source>repair them in the slicer, or export the part as STL</source>
        <translation>herstel ze in de slicer, of exporteer het onderdeel als STL</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} elements {name}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>niet gebruikt: {count} element {name}, in regel {line} van {where}</numerusform>
            <numerusform>niet gebruikt: {count} elementen {name}, het eerste in regel {line} van {where}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: attribute {name} of {count} elements {element}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>niet gebruikt: attribuut {name} van {count} element {element}, in regel {line} van {where}</numerusform>
            <numerusform>niet gebruikt: attribuut {name} van {count} elementen {element}, het eerste in regel {line} van {where}</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: metadata &apos;{name}&apos; ({where})</source>
        <translation>niet gebruikt: metadata &apos;{name}&apos; ({where})</translation>
    </message>
    <message>
        <source>not used: the division into {plates} plates ({where}): the parts of all are read</source>
        <translation>niet gebruikt: de verdeling over {plates} platen ({where}): de onderdelen van alle worden gelezen</translation>
    </message>
    <message>
        <source>not used: settings of plates ({where}): {keys}</source>
        <translation>niet gebruikt: instellingen van platen ({where}): {keys}</translation>
    </message>
    <message>
        <source>printed like the part: a volume of the unknown kind &apos;{kind}&apos; ({where})</source>
        <translation>geprint als het onderdeel: een volume van de onbekende soort &apos;{kind}&apos; ({where})</translation>
    </message>
    <message>
        <source>the slicer&apos;s settings</source>
        <translation>de instellingen van de slicer</translation>
    </message>
    <message>
        <source>variable layer heights</source>
        <translation>variabele laaghoogten</translation>
    </message>
    <message>
        <source>settings of ranges of height</source>
        <translation>instellingen van hoogtebereiken</translation>
    </message>
    <message>
        <source>stops, tools and G-code at given heights</source>
        <translation>stops, gereedschappen en G-code op gegeven hoogten</translation>
    </message>
    <message>
        <source>points of support</source>
        <translation>steunpunten</translation>
    </message>
    <message>
        <source>drain holes</source>
        <translation>afvoergaten</translation>
    </message>
    <message>
        <source>ears of the brim</source>
        <translation>oren van de brim</translation>
    </message>
    <message>
        <source>not used: {what} (&apos;{member}&apos;)</source>
        <translation>niet gebruikt: {what} (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: {count} further members of the package</source>
        <translation>niet gebruikt: {count} verdere bestanden in het pakket</translation>
    </message>
    <message>
        <source>not used: &apos;{member}&apos; in the package</source>
        <translation>niet gebruikt: &apos;{member}&apos; in het pakket</translation>
    </message>
    <message>
        <source>not used, as they are damaged: kinds and settings of objects ({where}): modifiers and negative volumes may be printed as parts: {why}</source>
        <translation>niet gebruikt, omdat ze beschadigd zijn: soorten en instellingen van objecten ({where}): modificatoren en negatieve volumes worden mogelijk als onderdelen geprint: {why}</translation>
    </message>
    <message>
        <source>does not have three numbers</source>
        <translation>heeft geen drie getallen</translation>
    </message>
    <message>
        <source>refers to a missing vertex</source>
        <translation>verwijst naar een ontbrekend hoekpunt</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>heeft geen driehoeken</translation>
    </message>
    <message>
        <source>is another version</source>
        <translation>is een andere versie</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>is onbekend</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}, estimated); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): overhang na het snijden {left:.0f} (delen: {pieces}) in plaats van {leftBefore:.0f#} (delen: {piecesBefore}, geschat); ongesneden {overhang:.0f} in plaats van {overhangBefore:.0f#}</translation>
    </message>
    <message numerus="yes">
        <source>{shots} shots into pockets last up to {seconds:.1f}: after {most:.0f} in a pocket the nozzle melts the layers around it</source>
        <translation>
            <numerusform>{shots} injectie in een pocket duurt {seconds:.1f}: na {most:.0f} in een pocket smelt de nozzle de lagen eromheen</numerusform>
            <numerusform>{shots} injecties in pockets duren tot {seconds:.1f}: na {most:.0f} in een pocket smelt de nozzle de lagen eromheen</numerusform>
        </translation>
    </message>
    <message>
        <source>use a process with a greater flow, or smaller pockets (`stitchDiameter`)</source>
        <translation>gebruik een proces met een grotere doorvoer, of kleinere pockets (`stitchDiameter`)</translation>
    </message>
    <message>
        <source>support in closed hollows of the part cannot be removed: {volume:.3g}</source>
        <translation>ondersteuning in gesloten holtes van het onderdeel kan niet worden verwijderd: {volume:.3g}</translation>
    </message>
    <message>
        <source>too many intersecting triangles to unite them ({pairs} pairs, at most {most}): shells stay as they are, overlaps count as one solid when layers are made</source>
        <translation>te veel elkaar snijdende driehoeken om te verenigen ({pairs} paren, hoogstens {most}): schillen blijven zoals ze zijn, overlappingen tellen bij het maken van lagen als één lichaam</translation>
    </message>
    <message>
        <source>change parameters, process or cell of the plan, or leave this format out</source>
        <translation>wijzig parameters, proces of cel van het plan, of laat dit formaat weg</translation>
    </message>
    <message>
        <source>choose another program format</source>
        <translation>kies een ander programmaformaat</translation>
    </message>
    <message>
        <source>the tool-paths are those of the file: change them where they were made</source>
        <translation>de gereedschapsbanen zijn die van het bestand: wijzig ze waar ze zijn gemaakt</translation>
    </message>
    <message>
        <source>slice the part again with supports there, or with denser infill; its tool-paths are printed as they are</source>
        <translation>slice het onderdeel opnieuw met ondersteuning daar, of met dichtere vulling; de gereedschapsbanen worden geprint zoals ze zijn</translation>
    </message>
    <message>
        <source>check the widths and layer heights in the slicer against the bead of the process; the tool-paths are printed as they are</source>
        <translation>vergelijk de breedtes en laaghoogten in de slicer met de streng van het proces; de gereedschapsbanen worden geprint zoals ze zijn</translation>
    </message>
    <message>
        <source>check the flow in the slicer, and purge or prime lines that it does not mark; the tool-paths are printed as they are</source>
        <translation>controleer de doorvoer in de slicer, en spoel- of primelijnen die hij niet markeert; de gereedschapsbanen worden geprint zoals ze zijn</translation>
    </message>
    <message>
        <source>check the slicer&apos;s flow, its filament diameter and its amounts at tool changes; the tool-paths are printed as they are</source>
        <translation>controleer de doorvoer van de slicer, zijn filamentdiameter en zijn hoeveelheden bij gereedschapswissels; de gereedschapsbanen worden geprint zoals ze zijn</translation>
    </message>
    <message>
        <source>no {format} program: {why}</source>
        <translation>geen {format}-programma: {why}</translation>
    </message>
    <message>
        <source>the {format} program lays beads by position, without the force of process {process}</source>
        <translation>het {format}-programma legt strengen op positie, zonder de kracht van proces {process}</translation>
    </message>
    <message>
        <source>to press with the force, use {formats}, or add the statements to the process (beadWords)</source>
        <translation>gebruik {formats} om met de kracht te drukken, of voeg de instructies aan het proces toe (beadWords)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {command} in {count} lines, the first is line {line}</source>
        <translation>
            <numerusform>niet gebruikt: {command} in {count} regel, regel {line}</numerusform>
            <numerusform>niet gebruikt: {command} in {count} regels, de eerste is regel {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>{cell}: best of the planned rows (row {row})</source>
        <translation>{cell}: beste van de geplande rijen (rij {row})</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} statements &apos;{word}&apos;, the first in line {line}</source>
        <translation>
            <numerusform>niet gebruikt: {count} instructie &apos;{word}&apos;, in regel {line}</numerusform>
            <numerusform>niet gebruikt: {count} instructies &apos;{word}&apos;, de eerste in regel {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not followed by a joint motion: it changes the speed of a later travel</source>
        <translation>&apos;{word}&apos; wordt niet gevolgd door een gewrichtsbeweging: het wijzigt de snelheid van een latere verplaatsing</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out already</source>
        <translation>het mes van de tape is al uit</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not out</source>
        <translation>het mes van de tape is niet uit</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out for {time:.2f}: it needs {least:.1f} to {most:.1f}</source>
        <translation>het mes van de tape is {time:.2f} uit: het heeft {least:.1f} tot {most:.1f} nodig</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not drawn back</source>
        <translation>het mes van de tape is niet teruggetrokken</translation>
    </message>
    <message>
        <source>outside the function of a part: &apos;{code}&apos;</source>
        <translation>buiten de functie van een deel: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>the cutter&apos;s output needs S255 or S0</source>
        <translation>de uitgang van het mes heeft S255 of S0 nodig</translation>
    </message>
    <message>
        <source>the cutter&apos;s output runs ahead of the motions: M400 is missing before it</source>
        <translation>de uitgang van het mes loopt voor op de bewegingen: M400 ontbreekt ervoor</translation>
    </message>
    <message>
        <source>the first module declares &apos;{procedure}&apos;, too</source>
        <translation>de eerste module declareert ook &apos;{procedure}&apos;</translation>
    </message>
    <message>
        <source>frame {id} follows frame {before}: frames are missing or in another order</source>
        <translation>frame {id} volgt op frame {before}: frames ontbreken of staan in een andere volgorde</translation>
    </message>
    <message>
        <source>the velocity at this point leads off the path</source>
        <translation>de snelheid op dit punt leidt van de baan af</translation>
    </message>
    <message>
        <source>the motors&apos; power for the first motion</source>
        <translation>het motorvermogen voor de eerste beweging</translation>
    </message>
    <message>
        <source>full</source>
        <translation>vol</translation>
    </message>
    <message>
        <source>low</source>
        <translation>laag</translation>
    </message>
    <message>
        <source>no place differs from the plan by more than the tolerances</source>
        <translation>geen plaats wijkt meer dan de toleranties van het plan af</translation>
    </message>
    <message numerus="yes">
        <source>{count} places are beyond the tolerances</source>
        <translation>
            <numerusform>{count} plaats ligt buiten de toleranties</numerusform>
            <numerusform>{count} plaatsen liggen buiten de toleranties</numerusform>
        </translation>
    </message>
    <message>
        <source>only {recorded:.1f} of {planned:.1f} of beads are recorded</source>
        <translation>slechts {recorded:.1f} van {planned:.1f} aan strengen is opgenomen</translation>
    </message>
    <message>
        <source>this is no record of this job: {recorded:.1f} of {planned:.1f} of beads agree</source>
        <translation>dit is geen opname van deze opdracht: {recorded:.1f} van {planned:.1f} aan strengen komt overeen</translation>
    </message>
    <message>
        <source>Plan: {finding}.</source>
        <translation>Plan: {finding}.</translation>
    </message>
    <message numerus="yes">
        <source>Plan: {count} more blocking findings.</source>
        <translation>
            <numerusform>Plan: nog {count} blokkerende bevinding.</numerusform>
            <numerusform>Plan: nog {count} blokkerende bevindingen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not approved: the plan has blocking findings.</source>
        <translation>Niet goedgekeurd: het plan heeft blokkerende bevindingen.</translation>
    </message>
    <message>
        <source>exists, perhaps with measured frames and obstacles</source>
        <translation>bestaat, mogelijk met gemeten assenstelsels en obstakels</translation>
    </message>
    <message>
        <source>give another name, --id, or replace it: --replace</source>
        <translation>geef een andere naam, --id, of vervang het: --replace</translation>
    </message>
    <message>
        <source>a share that is not positive</source>
        <translation>een aandeel dat niet positief is</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as UltiGCode states them</source>
        <translation>hoeveelheden worden als volumes opgevat, zoals UltiGCode ze geeft</translation>
    </message>
    <message>
        <source>give S in percent</source>
        <translation>geef S in procent</translation>
    </message>
    <message>
        <source>two commands in one line: &apos;{code}&apos; and &apos;{next}&apos;</source>
        <translation>twee commando&apos;s in één regel: &apos;{code}&apos; en &apos;{next}&apos;</translation>
    </message>
    <message>
        <source>write each command in a line of its own</source>
        <translation>schrijf elk commando in een eigen regel</translation>
    </message>
    <message>
        <source>a second object of the id &apos;{id}&apos;</source>
        <translation>een tweede object met de id &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>cells of {pitch} are too fine for a block of {along} by {across}</source>
        <translation>cellen van {pitch} zijn te fijn voor een blok van {along} bij {across}</translation>
    </message>
    <message>
        <source>give --pitch of {least} or more</source>
        <translation>geef --pitch van {least} of meer</translation>
    </message>
    <message>
        <source>must be within a kilometre</source>
        <translation>moet binnen een kilometer liggen</translation>
    </message>
    <message>
        <source>not used: {bytes} bytes behind the {facets} facets that the header states</source>
        <translation>niet gebruikt: {bytes} bytes na de {facets} facetten die de kop opgeeft</translation>
    </message>
    <message>
        <source>under G93 a way from an unknown place has no speed</source>
        <translation>onder G93 heeft een weg vanaf een onbekende plaats geen snelheid</translation>
    </message>
    <message>
        <source>the table turns while the nozzle goes to its start</source>
        <translation>de tafel draait terwijl de nozzle naar zijn begin gaat</translation>
    </message>
    <message>
        <source>the nozzle is not above its start: its way has no speed</source>
        <translation>de nozzle staat niet boven zijn begin: zijn weg heeft geen snelheid</translation>
    </message>
    <message>
        <source>the nozzle&apos;s height beside the print</source>
        <translation>de hoogte van de nozzle naast de print</translation>
    </message>
    <message>
        <source>at least {height:.1f}</source>
        <translation>minstens {height:.1f}</translation>
    </message>
    <message>
        <source>the heat of {tool}</source>
        <translation>de verwarming van {tool}</translation>
    </message>
    <message>
        <source>the payload</source>
        <translation>de last</translation>
    </message>
    <message>
        <source>the payload is not set</source>
        <translation>de last is niet ingesteld</translation>
    </message>
    <message>
        <source>the payload&apos;s centre, mm</source>
        <translation>het zwaartepunt van de last, mm</translation>
    </message>
    <message>
        <source>a payload&apos;s centre is no sensible place</source>
        <translation>het zwaartepunt van een last ligt op geen zinnige plaats</translation>
    </message>
    <message>
        <source>this text does not go to the extruder as those before it</source>
        <translation>deze tekst gaat niet naar de extruder zoals die ervoor</translation>
    </message>
    <message>
        <source>the head is {tip:.3g} wide at its tip and {end:.3g} at its other end: its nozzle seems to point away from the part</source>
        <translation>de kop is {tip:.3g} breed aan zijn punt en {end:.3g} aan zijn andere uiteinde: de nozzle lijkt van het onderdeel af te wijzen</translation>
    </message>
    <message>
        <source>turn the head of process {process} over</source>
        <translation>keer de kop van proces {process} om</translation>
    </message>
    <message>
        <source>the plates of machine {one} ({cell}) and machine {two} ({other}) overlap by {depth:.1f} ({area:.0f})</source>
        <translation>de platen van machine {one} ({cell}) en machine {two} ({other}) overlappen {depth:.1f} ({area:.0f})</translation>
    </message>
    <message>
        <source>{volume:.1f} extruded at rest are left out, from line {line} on</source>
        <translation>{volume:.1f} dat in stilstand is geëxtrudeerd, is weggelaten, vanaf regel {line}</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded by the printer&apos;s own code are left out, from line {line} on</source>
        <translation>{volume:.0f} dat door de eigen code van de printer is geëxtrudeerd, is weggelaten, vanaf regel {line}</translation>
    </message>
    <message>
        <source>the file states the filament diameter &apos;{text}&apos;: {diameter} assumed for values that cannot be used; for another one set `pathsFlow`</source>
        <translation>het bestand geeft de filamentdiameter &apos;{text}&apos;: {diameter} aangenomen voor waarden die niet bruikbaar zijn; stel voor een andere `pathsFlow` in</translation>
    </message>
    <message>
        <source>the program ends here, beads that follow in line {line} would not be printed</source>
        <translation>het programma eindigt hier, strengen die in regel {line} volgen, zouden niet worden geprint</translation>
    </message>
    <message>
        <source>remove the end (M2, M30, M112), or everything that follows it</source>
        <translation>verwijder het einde (M2, M30, M112), of alles wat erop volgt</translation>
    </message>
    <message numerus="yes">
        <source>{count} settings have no effect on the tool-paths of a file: {keys}</source>
        <translation>
            <numerusform>{count} instelling heeft geen effect op de gereedschapsbanen van een bestand: {keys}</numerusform>
            <numerusform>{count} instellingen hebben geen effect op de gereedschapsbanen van een bestand: {keys}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the job has {count} tools: its first tool prints the file&apos;s beads of {tools}</source>
        <translation>
            <numerusform>de opdracht heeft {count} gereedschap: het print de strengen van het bestand van {tools}</numerusform>
            <numerusform>de opdracht heeft {count} gereedschappen: het eerste print de strengen van het bestand van {tools}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} entries of the element &apos;{name}&apos;</source>
        <translation>
            <numerusform>niet gebruikt: {count} vermelding van het element &apos;{name}&apos;</numerusform>
            <numerusform>niet gebruikt: {count} vermeldingen van het element &apos;{name}&apos;</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>divided into triangles: {count} facets of more than three vertices, the first in line {line}</source>
        <translation>
            <numerusform>in driehoeken verdeeld: {count} facet met meer dan drie hoekpunten, in regel {line}</numerusform>
            <numerusform>in driehoeken verdeeld: {count} facetten met meer dan drie hoekpunten, het eerste in regel {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>two joints are named &apos;{joint}&apos;</source>
        <translation>twee gewrichten heten &apos;{joint}&apos;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the limits of its safety controller leave no room</source>
        <translation>gewricht &apos;{joint}&apos;: de grenzen van zijn veiligheidsbesturing laten geen ruimte</translation>
    </message>
    <message>
        <source>the time runs backwards, from {before:.3f} to {after:.3f} after the first row</source>
        <translation>de tijd loopt terug, van {before:.3f} naar {after:.3f} na de eerste rij</translation>
    </message>
    <message>
        <source>record one run in one file</source>
        <translation>neem één run in één bestand op</translation>
    </message>
    <message>
        <source>not used: the material or colour of objects and triangles, from line {line} of {where}</source>
        <translation>niet gebruikt: het materiaal of de kleur van objecten en driehoeken, vanaf regel {line} van {where}</translation>
    </message>
    <message>
        <source>not used: the recommended extension &apos;{name}&apos; ({where})</source>
        <translation>niet gebruikt: de aanbevolen extensie &apos;{name}&apos; ({where})</translation>
    </message>
    <message>
        <source>not used: the unit {unit} of {where}: its lengths are taken in {main}, the unit of the main model</source>
        <translation>niet gebruikt: de eenheid {unit} van {where}: de lengtes worden in {main} gelezen, de eenheid van het hoofdmodel</translation>
    </message>
    <message>
        <source>not used: the layer &apos;{path}&apos;, which is not in the list of layers</source>
        <translation>niet gebruikt: de laag &apos;{path}&apos;, die niet in de lijst van lagen staat</translation>
    </message>
    <message>
        <source>the name of the folder is empty</source>
        <translation>de naam van de map is leeg</translation>
    </message>
    <message>
        <source>name a folder for the results</source>
        <translation>noem een map voor de resultaten</translation>
    </message>
    <message>
        <source>beads of {least} to {most} do not fit a nozzle of {nozzle}</source>
        <translation>strengen van {least} tot {most} passen niet bij een nozzle van {nozzle}</translation>
    </message>
    <message>
        <source>check nozzleDiameterMm and beadWidthMm</source>
        <translation>controleer nozzleDiameterMm en beadWidthMm</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no pair x,radius</source>
        <translation>&apos;{text}&apos; is geen paar x,straal</translation>
    </message>
    <message>
        <source>contains no points</source>
        <translation>bevat geen punten</translation>
    </message>
    <message>
        <source>give numbers in mm, separated by commas: x,y,z</source>
        <translation>geef getallen in mm, gescheiden door komma&apos;s: x,y,z</translation>
    </message>
    <message>
        <source>is no result of this kind of job, and would be replaced</source>
        <translation>is geen resultaat van dit soort opdracht, en zou worden vervangen</translation>
    </message>
    <message>
        <source>choose another folder, or give --replace</source>
        <translation>kies een andere map, of geef --replace</translation>
    </message>
    <message>
        <source>give it for the job: --set {key}=...</source>
        <translation>geef het voor de opdracht: --set {key}=...</translation>
    </message>
    <message>
        <source>one mesh</source>
        <translation>één mesh</translation>
    </message>
    <message>
        <source>one mesh; read by a program of its own</source>
        <translation>één mesh; gelezen door een apart programma</translation>
    </message>
    <message>
        <source>several parts, or tool-paths (build files)</source>
        <translation>meerdere onderdelen, of gereedschapsbanen (bouwbestanden)</translation>
    </message>
    <message>
        <source>solid cells, drawn as text</source>
        <translation>massieve cellen, als tekst getekend</translation>
    </message>
    <message>
        <source>tool-paths of a slicer</source>
        <translation>gereedschapsbanen van een slicer</translation>
    </message>
    <message>
        <source>{key} is a setting of the job, not of a part</source>
        <translation>{key} is een instelling van de opdracht, niet van een onderdeel</translation>
    </message>
    <message>
        <source>use one of these formats: {formats}</source>
        <translation>gebruik een van deze formaten: {formats}</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not a part</source>
        <translation>het project van een station met meerdere machines, geen onderdeel</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, &apos;verify&apos; or &apos;resume&apos;; a part is a file of its own</source>
        <translation>geef het aan &apos;together&apos;, &apos;verify&apos; of &apos;resume&apos;; een onderdeel is een eigen bestand</translation>
    </message>
    <message>
        <source>a project, not a part</source>
        <translation>een project, geen onderdeel</translation>
    </message>
    <message>
        <source>give it to &apos;resume&apos;, &apos;verify&apos; or &apos;together&apos;; a part is a file of its own</source>
        <translation>geef het aan &apos;resume&apos;, &apos;verify&apos; of &apos;together&apos;; een onderdeel is een eigen bestand</translation>
    </message>
    <message>
        <source>not the file of a part</source>
        <translation>niet het bestand van een onderdeel</translation>
    </message>
    <message>
        <source>the file ends within line {line}, without a line end: it may be cut there, and the part unfinished; export it again</source>
        <translation>het bestand eindigt binnen regel {line}, zonder regeleinde: het is daar mogelijk afgekapt, en het onderdeel onvolledig; exporteer het opnieuw</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is more than a kilometre away</source>
        <translation>&apos;{text}&apos; is meer dan een kilometer ver</translation>
    </message>
    <message>
        <source>give places in mm</source>
        <translation>geef plaatsen in mm</translation>
    </message>
    <message>
        <source>there is no curve for tapes</source>
        <translation>er is geen kromme voor tapes</translation>
    </message>
    <message>
        <source>this text goes nowhere: the connection &apos;{name}&apos; is not open</source>
        <translation>deze tekst gaat nergens heen: de verbinding &apos;{name}&apos; is niet open</translation>
    </message>
    <message>
        <source>a connection needs an address and a port</source>
        <translation>een verbinding heeft een adres en een poort nodig</translation>
    </message>
    <message>
        <source>this file moves the arm before it states the payload</source>
        <translation>dit bestand beweegt de arm voordat het de last geeft</translation>
    </message>
    <message>
        <source>this file sets the flow before it states the range of the output</source>
        <translation>dit bestand stelt de doorvoer in voordat het het bereik van de uitgang geeft</translation>
    </message>
    <message>
        <source>G28 with a number goes to a place first: give letters alone, or none</source>
        <translation>G28 met een getal gaat eerst naar een plaats: geef alleen letters, of geen</translation>
    </message>
    <message>
        <source>G94 is missing before this motion: after a run that was stopped its F would be read as a time</source>
        <translation>G94 ontbreekt vóór deze beweging: na een gestopte run zou F als tijd worden gelezen</translation>
    </message>
    <message>
        <source>change the places of the machines in their table</source>
        <translation>wijzig de plaatsen van de machines in hun tabel</translation>
    </message>
    <message>
        <source>every two machines can work together, but no order of work was found for all</source>
        <translation>elke twee machines kunnen samenwerken, maar er is geen werkvolgorde voor alle gevonden</translation>
    </message>
    <message>
        <source>give a bead or a line for each machine, in their order</source>
        <translation>geef voor elke machine een streng of een regel, in hun volgorde</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, or the job.voluta of one machine here</source>
        <translation>geef het aan &apos;together&apos;, of hier de job.voluta van één machine</translation>
    </message>
    <message>
        <source>increase the minimum distance of moving arms, or place the machines further apart</source>
        <translation>vergroot de minimale afstand van bewegende armen, of zet de machines verder uit elkaar</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>het is een map</translation>
    </message>
    <message>
        <source>no order of work keeps the machines apart: {first} of machine {one} and {second} of machine {two} hinder each other</source>
        <translation>geen werkvolgorde houdt de machines uit elkaar: {first} van machine {one} en {second} van machine {two} hinderen elkaar</translation>
    </message>
    <message>
        <source>no program of it passed that states the arm</source>
        <translation>geen geslaagd programma ervan geeft de arm aan</translation>
    </message>
    <message>
        <source>not the project of a station</source>
        <translation>niet het project van een station</translation>
    </message>
    <message>
        <source>place the machines further apart if they stand at two plates</source>
        <translation>zet de machines verder uit elkaar als ze bij twee platen staan</translation>
    </message>
    <message>
        <source>place the machines further apart, or the parts further from the border</source>
        <translation>zet de machines verder uit elkaar, of de onderdelen verder van de grens</translation>
    </message>
    <message>
        <source>place the machines further apart, the parts further from the border, or the arms at rest further from it</source>
        <translation>zet de machines verder uit elkaar, de onderdelen verder van de grens, of de armen in rust verder ervan</translation>
    </message>
    <message>
        <source>see the report of that machine</source>
        <translation>zie het rapport van die machine</translation>
    </message>
    <message>
        <source>the file of the station is truncated</source>
        <translation>het bestand van het station is afgekapt</translation>
    </message>
    <message>
        <source>the folder holds no program of the station</source>
        <translation>de map bevat geen programma van het station</translation>
    </message>
    <message>
        <source>the header of the station&apos;s file is damaged</source>
        <translation>de kop van het stationsbestand is beschadigd</translation>
    </message>
    <message>
        <source>the part of machine {one} or {two} is inside the part, the plate or an obstacle of the other</source>
        <translation>het onderdeel van machine {one} of {two} zit in het onderdeel, de plaat of een obstakel van de andere</translation>
    </message>
    <message>
        <source>the place of a machine is damaged</source>
        <translation>de plaats van een machine is beschadigd</translation>
    </message>
    <message>
        <source>the program is refused</source>
        <translation>het programma is afgewezen</translation>
    </message>
    <message>
        <source>the project is not of machines that work together</source>
        <translation>het project is niet van machines die samenwerken</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not of one job</source>
        <translation>het project van een station met meerdere machines, niet van één opdracht</translation>
    </message>
    <message>
        <source>the rules of the station are damaged</source>
        <translation>de regels van het station zijn beschadigd</translation>
    </message>
    <message>
        <source>the station has no machines</source>
        <translation>het station heeft geen machines</translation>
    </message>
    <message>
        <source>write the programs of all machines again</source>
        <translation>schrijf de programma&apos;s van alle machines opnieuw</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} ({layer})</source>
        <translation>{body} van machine {one} raakt {obstacle} van machine {two} ({layer})</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} after {time}; collisions of the machines: {collisions}</source>
        <translation>{body} van machine {one} raakt {obstacle} van machine {two} na {time}; botsingen van de machines: {collisions}</translation>
    </message>
    <message>
        <source>{places} places for {machines} machines</source>
        <translation>{places} plaatsen voor {machines} machines</translation>
    </message>
    <message>
        <source>bead {bead} is printed: this rest begins with bead {first}</source>
        <translation>streng {bead} is geprint: deze rest begint met streng {first}</translation>
    </message>
    <message>
        <source>beads have the numbers of the whole print</source>
        <translation>strengen hebben de nummers van de hele print</translation>
    </message>
    <message>
        <source>the place of a machine</source>
        <translation>de plaats van een machine</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepteren</translation>
    </message>
    <message>
        <source>How far the printed part may differ from the requested one before the plan is marked. Never changes what is safe to run.</source>
        <translation>Hoeveel het geprinte onderdeel van het gevraagde mag afwijken voordat het plan wordt gemarkeerd. Verandert nooit wat veilig is om uit te voeren.</translation>
    </message>
    <message>
        <source>In this job; the verification report lists it</source>
        <translation>In deze opdracht; het verificatierapport vermeldt het</translation>
    </message>
    <message numerus="yes">
        <source>Nothing that was checked endangers robot or cell: {checks} checks of the part are beyond their limits.</source>
        <translation>
            <numerusform>Niets van wat is gecontroleerd, brengt robot of cel in gevaar: {checks} controle van het onderdeel ligt buiten de grenzen.</numerusform>
            <numerusform>Niets van wat is gecontroleerd, brengt robot of cel in gevaar: {checks} controles van het onderdeel liggen buiten hun grenzen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kwaliteit</translation>
    </message>
    <message>
        <source>Safe to run, but it does not print the part as asked.</source>
        <translation>Veilig om uit te voeren, maar het print het onderdeel niet zoals gevraagd.</translation>
    </message>
    <message>
        <source>accepted differences</source>
        <translation>geaccepteerde afwijkingen</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>concept</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>massa</translation>
    </message>
    <message>
        <source>overfill</source>
        <translation>overvulling</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>kwaliteit</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>strikt</translation>
    </message>
    <message>
        <source>uncovered</source>
        <translation>niet bedekt</translation>
    </message>
    <message>
        <source>unsupported</source>
        <translation>niet ondersteund</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>gebruikelijk</translation>
    </message>
    <message>
        <source>{length:.1f} of bead ({share:.2f}) is unsupported</source>
        <translation>{length:.1f} streng ({share:.2f}) is niet ondersteund</translation>
    </message>
    <message>
        <source>{quality}; accepted: {shares}</source>
        <translation>{quality}; geaccepteerd: {shares}</translation>
    </message>
    <message>
        <source>How a part whose surface has wide openings or no thickness is handled: close openings that are flat or small and refuse others, refuse it, close the openings with patches, thicken the surface to a wall two beads wide, or print it as one wall, one bead wide.</source>
        <translation>Hoe een onderdeel wordt behandeld waarvan het oppervlak wijde openingen of geen dikte heeft: openingen sluiten die vlak of klein zijn en andere weigeren, het weigeren, de openingen opvullen, het oppervlak verdikken tot een wand van twee strengen breed, of het printen als één wand van één streng breed.</translation>
    </message>
    <message>
        <source>Shares that are accepted in this job beyond the quality&apos;s limits: uncovered, unsupported, overfill, mass and thin, such as uncovered=0.05, mass=0.04. Verification reports list them.</source>
        <translation>Aandelen die in deze opdracht buiten de grenzen van de kwaliteit worden geaccepteerd: uncovered, unsupported, overfill, mass en thin, zoals uncovered=0.05, mass=0.04. Verificatierapporten vermelden ze.</translation>
    </message>
    <message>
        <source>The spiral follows the largest contour of each layer; holes and other contours are left out.</source>
        <translation>De spiraal volgt de grootste contour van elke laag; gaten en andere contouren worden weggelaten.</translation>
    </message>
    <message>
        <source>Thin: {share:.1f} of the part is narrower than the narrowest bead and stays open; at most {limit:.4g} allowed.</source>
        <translation>Dun: {share:.1f} van het onderdeel is smaller dan de smalste streng en blijft open; hoogstens {limit:.4g} toegestaan.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>check these places in the view; move the part on the plate if they matter</source>
        <translation>controleer deze plaatsen in de weergave; verplaats het onderdeel op de plaat als ze ertoe doen</translation>
    </message>
    <message>
        <source>choose a process with narrower beads, or slice the part again with wider ones</source>
        <translation>kies een proces met smallere strengen, of slice het onderdeel opnieuw met bredere</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for; the tool-paths are printed as they are</source>
        <translation>kies het proces waarvoor het bestand is geslicet; de gereedschapsbanen worden geprint zoals ze zijn</translation>
    </message>
    <message>
        <source>export the file again in millimetres, at the size to be printed</source>
        <translation>exporteer het bestand opnieuw in millimeters, op de te printen grootte</translation>
    </message>
    <message>
        <source>in line {line} first</source>
        <translation>voor het eerst in regel {line}</translation>
    </message>
    <message>
        <source>in no single line</source>
        <translation>in geen enkele regel in het bijzonder</translation>
    </message>
    <message>
        <source>look at that line: export the file again without it, with straight lines or arcs (G1, G2, G3)</source>
        <translation>bekijk die regel: exporteer het bestand opnieuw zonder, met rechte lijnen of bogen (G1, G2, G3)</translation>
    </message>
    <message>
        <source>move the part on the plate, or slice it again for a lower speed there</source>
        <translation>verplaats het onderdeel op de plaat, of slice het opnieuw voor een lagere snelheid daar</translation>
    </message>
    <message>
        <source>move the part on the plate, or use another cell; its tool-paths are printed as they are</source>
        <translation>verplaats het onderdeel op de plaat, of gebruik een andere cel; de gereedschapsbanen ervan worden geprint zoals ze zijn</translation>
    </message>
    <message>
        <source>move the part on the plate, use a slimmer print head, or allow less clearance</source>
        <translation>verplaats het onderdeel op de plaat, gebruik een slankere printkop, of sta minder vrije afstand toe</translation>
    </message>
    <message>
        <source>outer contour alone</source>
        <translation>alleen buitencontour</translation>
    </message>
    <message>
        <source>plan again with more clearance, or move the part on the plate</source>
        <translation>plan opnieuw met meer vrije afstand, of verplaats het onderdeel op de plaat</translation>
    </message>
    <message>
        <source>see its report</source>
        <translation>zie het rapport ervan</translation>
    </message>
    <message>
        <source>see the remedies in the job of that machine</source>
        <translation>zie de oplossingen in de opdracht van die machine</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, its beads and what is left out have {read:.0f}; they part {line}</source>
        <translation>het bestand extrudeert {stated:.0f} volgens zijn E-woorden, de strengen ervan en wat is weggelaten hebben {read:.0f}; ze lopen uiteen {line}</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, the tool-paths taken from it have {read:.0f}; they part {line}</source>
        <translation>het bestand extrudeert {stated:.0f} volgens zijn E-woorden, de eruit gelezen gereedschapsbanen hebben {read:.0f}; ze lopen uiteen {line}</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>dun</translation>
    </message>
    <message>
        <source>use a cell whose arm can tilt the nozzle, or print the paths on the plate</source>
        <translation>gebruik een cel waarvan de arm de nozzle kan kantelen, of print de banen op de plaat</translation>
    </message>
    <message>
        <source>use a cell with a larger plate, or slice the part again at a smaller size</source>
        <translation>gebruik een cel met een grotere plaat, of slice het onderdeel opnieuw op een kleinere grootte</translation>
    </message>
    <message numerus="yes">
        <source>{share:.2f} of the part ({volume:.3g}) is narrower than the narrowest bead ({bead:.3g}) and stays open, at {places} places, mostly around this point</source>
        <translation>
            <numerusform>{share:.2f} van het onderdeel ({volume:.3g}) is smaller dan de smalste streng ({bead:.3g}) en blijft open, op {places} plaats, vooral rond dit punt</numerusform>
            <numerusform>{share:.2f} van het onderdeel ({volume:.3g}) is smaller dan de smalste streng ({bead:.3g}) en blijft open, op {places} plaatsen, vooral rond dit punt</numerusform>
        </translation>
    </message>
    <message>
        <source>choose another pattern or another share, or a quality that accepts longer bridges</source>
        <translation>kies een ander patroon of een ander aandeel, of een kwaliteit die langere bruggen accepteert</translation>
    </message>
    <message>
        <source>its lines branch below skins that would sag between them</source>
        <translation>de lijnen ervan vertakken zich onder huiden die ertussen zouden doorhangen</translation>
    </message>
    <message>
        <source>sparse infill fills {found:.0f} of the interior instead of {asked:.0f}: {reason}</source>
        <translation>open vulling vult {found:.0f} van het binnenste in plaats van {asked:.0f}: {reason}</translation>
    </message>
    <message>
        <source>the interior is too small for its lines, or they cannot lie any closer</source>
        <translation>het binnenste is te klein voor de lijnen ervan, of ze kunnen niet dichter bij elkaar liggen</translation>
    </message>
    <message>
        <source>Bead width, length that it bridges with a sag of up to 0.2 mm; and so on, in mm. Quality usual and draft accept it. Those of the program&apos;s materials are estimates: replace them by those of a test print.</source>
        <translation>Strengbreedte, lengte die de streng overbrugt met een doorhang tot 0,2 mm; enzovoort, in mm. Kwaliteit gebruikelijk en concept accepteren dit. Die van de materialen van het programma zijn schattingen: vervang ze door die van een proefprint.</translation>
    </message>
    <message>
        <source>Maximum distance between waypoints along a tool-path; plain G-code has fewer where beads are straight.</source>
        <translation>Maximale afstand tussen baanpunten langs een gereedschapsbaan; gewone G-code heeft er minder waar strengen recht zijn.</translation>
    </message>
    <message>
        <source>Share of the speed of a wall that overhangs the layer below by that share of its width.</source>
        <translation>Aandeel van de snelheid voor een wand die met dat deel van zijn breedte over de laag eronder hangt.</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), turn the part, or use planar or curved mode</source>
        <translation>voeg ondersteuning toe (`supports=auto`), draai het onderdeel, of gebruik vlakke delen of gebogen lagen</translation>
    </message>
    <message>
        <source>bridges with a little sag</source>
        <translation>bruggen met een beetje doorhang</translation>
    </message>
    <message>
        <source>choose a plate with a size, or type the number of copies</source>
        <translation>kies een plaat met een grootte, of typ het aantal kopieën</translation>
    </message>
    <message>
        <source>is above 1000 mm: check the unit</source>
        <translation>is meer dan 1000 mm: controleer de eenheid</translation>
    </message>
    <message>
        <source>is more than with less overhang</source>
        <translation>is meer dan bij minder overhang</translation>
    </message>
    <message>
        <source>is not wider than the bead before it</source>
        <translation>is niet breder dan de streng ervoor</translation>
    </message>
    <message>
        <source>must be a pair of bead width and length</source>
        <translation>moet een paar van strengbreedte en lengte zijn</translation>
    </message>
    <message>
        <source>must have four shares, for 25, 50, 75 and 100 % of the width</source>
        <translation>moet vier aandelen hebben, voor 25, 50, 75 en 100 % van de breedte</translation>
    </message>
    <message>
        <source>speed of walls, 100 % overhang</source>
        <translation>snelheid van wanden, 100 % overhang</translation>
    </message>
    <message>
        <source>speed of walls, 25 % overhang</source>
        <translation>snelheid van wanden, 25 % overhang</translation>
    </message>
    <message>
        <source>speed of walls, 50 % overhang</source>
        <translation>snelheid van wanden, 50 % overhang</translation>
    </message>
    <message>
        <source>speed of walls, 75 % overhang</source>
        <translation>snelheid van wanden, 75 % overhang</translation>
    </message>
    <message>
        <source>the plate is made as large as the parts need</source>
        <translation>de plaat wordt zo groot gemaakt als de onderdelen nodig hebben</translation>
    </message>
    <message>
        <source>write the program again, or use smaller cells for the part&apos;s map</source>
        <translation>schrijf het programma opnieuw, of gebruik kleinere cellen voor de kaart van het onderdeel</translation>
    </message>
    <message>
        <source>allow larger facets, or export less detail</source>
        <translation>sta grotere facetten toe, of exporteer minder detail</translation>
    </message>
    <message>
        <source>cannot be read: voluta-cad-reader is missing beside this program</source>
        <translation>kan niet worden gelezen: voluta-cad-reader ontbreekt naast dit programma</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>kopieer of exporteer het opnieuw</translation>
    </message>
    <message>
        <source>export the solid from the CAD program</source>
        <translation>exporteer het lichaam uit het CAD-programma</translation>
    </message>
    <message>
        <source>give it the ending .stl</source>
        <translation>geef het de extensie .stl</translation>
    </message>
    <message>
        <source>has no solid and no surface</source>
        <translation>heeft geen lichaam en geen oppervlak</translation>
    </message>
    <message>
        <source>has only curves, no solid and no surface</source>
        <translation>heeft alleen krommen, geen lichaam en geen oppervlak</translation>
    </message>
    <message>
        <source>is an STL, not a STEP or IGES file</source>
        <translation>is een STL, geen STEP- of IGES-bestand</translation>
    </message>
    <message>
        <source>is cut short: {lacking}</source>
        <translation>is afgekapt: {lacking}</translation>
    </message>
    <message>
        <source>is damaged: Open CASCADE cannot read it</source>
        <translation>is beschadigd: Open CASCADE kan het niet lezen</translation>
    </message>
    <message>
        <source>needs more than 4 GB of memory to read</source>
        <translation>heeft meer dan 4 GB geheugen nodig om te lezen</translation>
    </message>
    <message>
        <source>not a STEP or IGES file</source>
        <translation>geen STEP- of IGES-bestand</translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} curves</source>
        <translation>
            <numerusform>weggelaten: één kromme</numerusform>
            <numerusform>weggelaten: {n} krommen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} surfaces without facets</source>
        <translation>
            <numerusform>weggelaten: één oppervlak zonder facetten</numerusform>
            <numerusform>weggelaten: {n} oppervlakken zonder facetten</numerusform>
        </translation>
    </message>
    <message>
        <source>one or several solids; read by a program of its own</source>
        <translation>een of meer lichamen; gelezen door een eigen programma</translation>
    </message>
    <message>
        <source>open the hollow or turn the part; without supports (`supports=none`, `rimSupports=none`) the hollow&apos;s roof is unsupported</source>
        <translation>open de holte of draai het onderdeel; zonder ondersteuning (`supports=none`, `rimSupports=none`) is het dak van de holte niet ondersteund</translation>
    </message>
    <message>
        <source>surfaces are read as facets, at most {chord:.3g} off</source>
        <translation>oppervlakken worden als facetten gelezen, hoogstens {chord:.3g} ernaast</translation>
    </message>
    <message>
        <source>takes longer than {time:.0f} to read</source>
        <translation>duurt langer dan {time:.0f} om te lezen</translation>
    </message>
    <message>
        <source>the end of a STEP file is missing</source>
        <translation>het einde van een STEP-bestand ontbreekt</translation>
    </message>
    <message>
        <source>the last line of an IGES file is missing, or names other numbers of lines</source>
        <translation>de laatste regel van een IGES-bestand ontbreekt, of noemt andere aantallen regels</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a preset&apos;s id</source>
        <translation>&apos;{id}&apos; kan niet de id van een preset zijn</translation>
    </message>
    <message>
        <source>&apos;{key}&apos; is not a setting of presets</source>
        <translation>&apos;{key}&apos; is geen instelling van presets</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of layers</source>
        <translation>&apos;{text}&apos; is geen lijst van lagen</translation>
    </message>
    <message>
        <source>Fill of what is meant to be solid: mean along the view, for beads with round edges</source>
        <translation>Vulling van wat massief moet zijn: gemiddelde langs de kijkrichting, voor rupsen met ronde randen</translation>
    </message>
    <message>
        <source>Overhang
mm²</source>
        <translation>Overhang
mm²</translation>
    </message>
    <message>
        <source>Unprinted
voxels</source>
        <translation>Niet geprinte
voxels</translation>
    </message>
    <message>
        <source>a film of {length} cannot be made</source>
        <translation>een film van {length} kan niet worden gemaakt</translation>
    </message>
    <message>
        <source>a preset &apos;{id}&apos; comes with the program</source>
        <translation>een preset &apos;{id}&apos; wordt met het programma meegeleverd</translation>
    </message>
    <message>
        <source>a preset &apos;{label}&apos; comes with the program</source>
        <translation>een preset &apos;{label}&apos; wordt met het programma meegeleverd</translation>
    </message>
    <message>
        <source>a preset needs a name</source>
        <translation>een preset heeft een naam nodig</translation>
    </message>
    <message>
        <source>add supports, make sparse infill denser, rotate the part, or choose mode auto</source>
        <translation>voeg ondersteuning toe, maak de open vulling dichter, draai het onderdeel, of kies modus auto</translation>
    </message>
    <message>
        <source>choose a smaller dovetail, another direction or another plane</source>
        <translation>kies een kleinere zwaluwstaart, een andere richting of een ander vlak</translation>
    </message>
    <message>
        <source>choose a smaller pin or another plane</source>
        <translation>kies een kleinere pen of een ander vlak</translation>
    </message>
    <message>
        <source>choose another folder, or check the space on the disk</source>
        <translation>kies een andere map, of controleer de ruimte op de schijf</translation>
    </message>
    <message>
        <source>drawing the film</source>
        <translation>de film wordt getekend</translation>
    </message>
    <message>
        <source>format {format} has no command for {event}</source>
        <translation>formaat {format} heeft geen opdracht voor {event}</translation>
    </message>
    <message>
        <source>give numbers, such as 12, 40</source>
        <translation>geef nummers, zoals 12, 40</translation>
    </message>
    <message>
        <source>import the parent first, or name another one</source>
        <translation>importeer eerst de ouder, of noem een andere</translation>
    </message>
    <message>
        <source>in their home poses machines {one} and {two} are too close to each other</source>
        <translation>in hun rustposities staan machines {one} en {two} te dicht bij elkaar</translation>
    </message>
    <message>
        <source>infill tool</source>
        <translation>gereedschap voor vulling</translation>
    </message>
    <message>
        <source>move the plane into the part</source>
        <translation>verplaats het vlak in het onderdeel</translation>
    </message>
    <message>
        <source>move them apart, or change a home pose</source>
        <translation>zet ze verder uit elkaar, of wijzig een rustpositie</translation>
    </message>
    <message>
        <source>must not be blank</source>
        <translation>mag niet leeg zijn</translation>
    </message>
    <message>
        <source>name another parent</source>
        <translation>noem een andere ouder</translation>
    </message>
    <message>
        <source>name it &apos;{id}&apos;</source>
        <translation>noem het &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>no platform below the overhang: {area:.3g}</source>
        <translation>geen platform onder de overhang: {area:.3g}</translation>
    </message>
    <message>
        <source>no room in the section for a dovetail of {width}, {height} high</source>
        <translation>geen plaats in de doorsnede voor een zwaluwstaart van {width}, {height} hoog</translation>
    </message>
    <message>
        <source>no room in the section for a pin of {diameter}, {depth} deep</source>
        <translation>geen plaats in de doorsnede voor een pen van {diameter}, {depth} diep</translation>
    </message>
    <message>
        <source>pauses before layers</source>
        <translation>pauzes vóór lagen</translation>
    </message>
    <message>
        <source>preset &apos;{id}&apos; is its own parent, through its parents</source>
        <translation>preset &apos;{id}&apos; is via zijn ouders zijn eigen ouder</translation>
    </message>
    <message>
        <source>repair the part, or move the plane</source>
        <translation>repareer het onderdeel, of verplaats het vlak</translation>
    </message>
    <message>
        <source>small contact with the plate: {foot:.3g}; uncut, the part has {whole:.3g#}</source>
        <translation>klein contact met de plaat: {foot:.3g}; ongesneden heeft het onderdeel {whole:.3g#}</translation>
    </message>
    <message>
        <source>support tool</source>
        <translation>gereedschap voor ondersteuning</translation>
    </message>
    <message>
        <source>the bead below is covered after {time:.1f}, before the minimum layer time of {limit:.1f}; on {length:.0f} of beads in all</source>
        <translation>de rups eronder wordt na {time:.1f} bedekt, vóór de minimale laagtijd van {limit:.1f}; in totaal op {length:.0f} aan rupsen</translation>
    </message>
    <message>
        <source>the cutter cuts into the fixture below the block</source>
        <translation>de frees snijdt in de opspanning onder het blok</translation>
    </message>
    <message>
        <source>the film cannot be written</source>
        <translation>de film kan niet worden geschreven</translation>
    </message>
    <message>
        <source>the id &apos;{id}&apos; is not the name of the file</source>
        <translation>de id &apos;{id}&apos; is niet de naam van het bestand</translation>
    </message>
    <message>
        <source>the joint cannot be cut out of this mesh</source>
        <translation>de verbinding kan niet uit dit net worden gesneden</translation>
    </message>
    <message>
        <source>the parent &apos;{parent}&apos; of preset &apos;{id}&apos; does not exist</source>
        <translation>de ouder &apos;{parent}&apos; van preset &apos;{id}&apos; bestaat niet</translation>
    </message>
    <message>
        <source>the plane does not cut the part</source>
        <translation>het vlak snijdt het onderdeel niet</translation>
    </message>
    <message>
        <source>there is a preset &apos;{label}&apos; already</source>
        <translation>er is al een preset &apos;{label}&apos;</translation>
    </message>
    <message>
        <source>type a name</source>
        <translation>typ een naam</translation>
    </message>
    <message>
        <source>unknown preset &apos;{id}&apos;</source>
        <translation>onbekende preset &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>use a smaller cutter or a smaller stepover, or rotate the part</source>
        <translation>gebruik een kleinere frees of een kleinere zijstap, of draai het onderdeel</translation>
    </message>
    <message>
        <source>x,y,z in the part&apos;s file, for example 1,0,0: reports the strength for a load in this direction. Empty: no load.</source>
        <translation>x,y,z in het bestand van het onderdeel, bijvoorbeeld 1,0,0: vermeldt de sterkte voor een belasting in deze richting. Leeg: geen belasting.</translation>
    </message>
    <message>
        <source>the film cannot be written: FFmpeg has no encoder for VP9</source>
        <translation>de film kan niet worden geschreven: FFmpeg heeft geen encoder voor VP9</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from &apos;{parent}&apos;, which does not exist</source>
        <translation>&apos;{id}&apos; erft van &apos;{parent}&apos;, die niet bestaat</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from itself, through its parents</source>
        <translation>&apos;{id}&apos; erft via zijn ouders van zichzelf</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is incomplete</source>
        <translation>&apos;{text}&apos; is onvolledig</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an event of a layer</source>
        <translation>&apos;{text}&apos; is geen gebeurtenis van een laag</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} {number} is out of range</source>
        <translation>&apos;{text}&apos;: {field} {number} valt buiten het bereik</translation>
    </message>
    <message>
        <source>At a stop the pendant shows no text: the controller sends it to the sender of the frames, which has to show it.</source>
        <translation>Bij een stop toont het handbedieningspaneel geen tekst: de besturing stuurt die naar de zender van de frames, die hem moet tonen.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Wegsnijden</translation>
    </message>
    <message>
        <source>Cylinder along Z</source>
        <translation>Cilinder langs Z</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Diepte</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Richting X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Richting Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Richting Z</translation>
    </message>
    <message>
        <source>Flat layers along a direction</source>
        <translation>Vlakke lagen langs een richting</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Van</translation>
    </message>
    <message>
        <source>Height (Z)</source>
        <translation>Hoogte (Z)</translation>
    </message>
    <message>
        <source>Layers along the surface</source>
        <translation>Lagen langs het oppervlak</translation>
    </message>
    <message>
        <source>Layers around the rest</source>
        <translation>Lagen rondom de rest</translation>
    </message>
    <message>
        <source>Layers that turn to a direction</source>
        <translation>Lagen die naar een richting draaien</translation>
    </message>
    <message>
        <source>Middle X</source>
        <translation>Midden X</translation>
    </message>
    <message>
        <source>Middle Y</source>
        <translation>Midden Y</translation>
    </message>
    <message>
        <source>Middle Z</source>
        <translation>Midden Z</translation>
    </message>
    <message>
        <source>Numbers of layers of the part, separated by commas: before each of them the arm goes beside the part and waits until the operator continues, for example to put in an insert. Then it primes the nozzle there.</source>
        <translation>Nummers van lagen van het onderdeel, gescheiden door komma&apos;s: vóór elk daarvan gaat de arm naast het onderdeel staan en wacht tot de operator verdergaat, bijvoorbeeld om een inzetstuk te plaatsen. Daarna primet hij daar de spuitmond.</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>Eigen instellingen</translation>
    </message>
    <message>
        <source>Painted surface</source>
        <translation>Beschilderd oppervlak</translation>
    </message>
    <message>
        <source>Pauses before layers</source>
        <translation>Pauzes vóór lagen</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Range of heights over the plate</source>
        <translation>Hoogtebereik boven de plaat</translation>
    </message>
    <message>
        <source>Skin below the upper surface</source>
        <translation>Huid onder het bovenvlak</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Bol</translation>
    </message>
    <message>
        <source>Steepest slope (degrees)</source>
        <translation>Steilste helling (graden)</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Tot</translation>
    </message>
    <message>
        <source>a change of colour</source>
        <translation>een kleurwissel</translation>
    </message>
    <message>
        <source>a change to extruder {number}</source>
        <translation>een wissel naar extruder {number}</translation>
    </message>
    <message>
        <source>a painted fuzzy skin</source>
        <translation>een geschilderd ruw oppervlak</translation>
    </message>
    <message>
        <source>a painted seam</source>
        <translation>een geschilderde naad</translation>
    </message>
    <message>
        <source>a pause</source>
        <translation>een pauze</translation>
    </message>
    <message>
        <source>a spiral has no regions</source>
        <translation>een spiraal heeft geen gebieden</translation>
    </message>
    <message>
        <source>a statement of your own</source>
        <translation>een eigen instructie</translation>
    </message>
    <message>
        <source>a tool changes before a layer, not at a height</source>
        <translation>een gereedschap wisselt vóór een laag, niet op een hoogte</translation>
    </message>
    <message>
        <source>add it from its file again</source>
        <translation>voeg het opnieuw toe vanuit zijn bestand</translation>
    </message>
    <message>
        <source>change the tool where the file was made</source>
        <translation>wissel het gereedschap waar het bestand is gemaakt</translation>
    </message>
    <message>
        <source>check what it does on the controller; leave it out of `layerEvents` if you do not need it</source>
        <translation>controleer wat hij op de besturing doet; laat hem weg uit `layerEvents` als je hem niet nodig hebt</translation>
    </message>
    <message>
        <source>choose a process without corrections, or remove the regions</source>
        <translation>kies een proces zonder correcties, of verwijder de gebieden</translation>
    </message>
    <message>
        <source>correct the setting; layers are counted for each part</source>
        <translation>corrigeer de instelling; lagen worden per onderdeel geteld</translation>
    </message>
    <message>
        <source>custom G-code</source>
        <translation>eigen G-code</translation>
    </message>
    <message>
        <source>event</source>
        <translation>gebeurtenis</translation>
    </message>
    <message>
        <source>events before layers</source>
        <translation>gebeurtenissen vóór lagen</translation>
    </message>
    <message>
        <source>format {format} has outputs {first} to {last}, not {number}</source>
        <translation>formaat {format} heeft uitgangen {first} tot en met {last}, niet {number}</translation>
    </message>
    <message>
        <source>give a steeper slope</source>
        <translation>geef een steilere helling op</translation>
    </message>
    <message>
        <source>give a tilted direction</source>
        <translation>geef een schuine richting op</translation>
    </message>
    <message>
        <source>give the lower height first</source>
        <translation>geef eerst de laagste hoogte op</translation>
    </message>
    <message>
        <source>give the number of the layer</source>
        <translation>geef het nummer van de laag op</translation>
    </message>
    <message>
        <source>give {field} from {least} to {most}</source>
        <translation>geef {field} op van {least} tot {most}</translation>
    </message>
    <message>
        <source>height {height}</source>
        <translation>hoogte {height}</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>is geen JSON-object</translation>
    </message>
    <message>
        <source>layers of region {region} turn to a vertical direction</source>
        <translation>de lagen van gebied {region} draaien naar een verticale richting</translation>
    </message>
    <message>
        <source>layers that turn by {angle} within the region are {thin:.2f} to {thick:.2f} thick, outside the limits</source>
        <translation>lagen die binnen het gebied {angle} draaien, zijn {thin:.2f} tot {thick:.2f} dik, buiten de grenzen</translation>
    </message>
    <message>
        <source>line {line}: the print pauses before bead {bead} in layer {layer}: {text} ({command})</source>
        <translation>regel {line}: de print pauzeert vóór rups {bead} in laag {layer}: {text} ({command})</translation>
    </message>
    <message>
        <source>make it deeper, or use a process with lower layers</source>
        <translation>maak het dieper, of gebruik een proces met lagere lagen</translation>
    </message>
    <message>
        <source>make the region higher or narrower, or turn by less</source>
        <translation>maak het gebied hoger of smaller, of draai minder</translation>
    </message>
    <message>
        <source>make the region smaller</source>
        <translation>maak het gebied kleiner</translation>
    </message>
    <message>
        <source>make the region smaller, or move it</source>
        <translation>maak het gebied kleiner, of verplaats het</translation>
    </message>
    <message>
        <source>make the regions smaller, or move them up</source>
        <translation>maak de gebieden kleiner, of verplaats ze omhoog</translation>
    </message>
    <message>
        <source>mode {mode} prints on the part: it has no regions</source>
        <translation>modus {mode} print op het onderdeel: die heeft geen gebieden</translation>
    </message>
    <message>
        <source>move the plane further into the part</source>
        <translation>verplaats het vlak verder het onderdeel in</translation>
    </message>
    <message>
        <source>move the plane into a body, or split the part into its bodies</source>
        <translation>verplaats het vlak in een lichaam, of splits het onderdeel in zijn lichamen</translation>
    </message>
    <message>
        <source>no change of the tool before layer {layer}: the part has {layers} layers</source>
        <translation>geen gereedschapswissel vóór laag {layer}: het onderdeel heeft {layers} lagen</translation>
    </message>
    <message>
        <source>no {what} before {place} of part {part}: the part has {layers} layers</source>
        <translation>geen {what} vóór {place} van onderdeel {part}: het onderdeel heeft {layers} lagen</translation>
    </message>
    <message>
        <source>no {what} before {place}: the print ends with layer {layers}</source>
        <translation>geen {what} vóór {place}: de print eindigt met laag {layers}</translation>
    </message>
    <message>
        <source>nobody but you knows what the statement is for</source>
        <translation>alleen jij weet waar de instructie voor dient</translation>
    </message>
    <message>
        <source>not used, as they are damaged: {what} (&apos;{member}&apos;): {why}</source>
        <translation>niet gebruikt, want beschadigd: {what} (&apos;{member}&apos;): {why}</translation>
    </message>
    <message>
        <source>not used: invalid settings of region &apos;{region}&apos; from the file: {settings}</source>
        <translation>niet gebruikt: ongeldige instellingen van gebied &apos;{region}&apos; uit het bestand: {settings}</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file, which has no settings</source>
        <translation>niet gebruikt: gebied &apos;{region}&apos; uit het bestand, dat geen instellingen heeft</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file: its mesh is not closed</source>
        <translation>niet gebruikt: gebied &apos;{region}&apos; uit het bestand: zijn mesh is niet gesloten</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height (&apos;{member}&apos;)</source>
        <translation>niet gebruikt: instellingen van hoogtebereiken (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height of object {number}, which does not exist (&apos;{member}&apos;)</source>
        <translation>niet gebruikt: instellingen van hoogtebereiken van object {number}, dat niet bestaat (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height: the objects of the file are one part</source>
        <translation>niet gebruikt: instellingen van hoogtebereiken: de objecten van het bestand zijn één onderdeel</translation>
    </message>
    <message>
        <source>not used: settings of region &apos;{region}&apos; from the file without a counterpart: {settings}</source>
        <translation>niet gebruikt: instellingen van gebied &apos;{region}&apos; uit het bestand zonder tegenhanger: {settings}</translation>
    </message>
    <message>
        <source>not used: the range of heights from {from} to {to} in the file, which is empty</source>
        <translation>niet gebruikt: het hoogtebereik van {from} tot {to} in het bestand, dat leeg is</translation>
    </message>
    <message>
        <source>not used: tool {tool} of region &apos;{region}&apos; from the file: the job has {tools}</source>
        <translation>niet gebruikt: gereedschap {tool} van gebied &apos;{region}&apos; uit het bestand: de taak heeft er {tools}</translation>
    </message>
    <message>
        <source>not used: {count} further events at heights (&apos;{member}&apos;)</source>
        <translation>niet gebruikt: nog {count} gebeurtenissen op hoogten (&apos;{member}&apos;)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} further regions of the file</source>
        <translation>
            <numerusform>niet gebruikt: nog {count} gebied van het bestand</numerusform>
            <numerusform>niet gebruikt: nog {count} gebieden van het bestand</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops before the first bead, since programs begin with a question</source>
        <translation>
            <numerusform>niet gebruikt: {count} stop vóór de eerste rups, omdat programma&apos;s met een vraag beginnen</numerusform>
            <numerusform>niet gebruikt: {count} stops vóór de eerste rups, omdat programma&apos;s met een vraag beginnen</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} (&apos;{member}&apos;)</source>
        <translation>niet gebruikt: {event} op een hoogte van {height} (&apos;{member}&apos;)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, from line {line} of {where})</source>
        <translation>
            <numerusform>niet gebruikt: {paint} op {count} driehoek van &apos;{object}&apos; ({attribute}, vanaf regel {line} van {where})</numerusform>
            <numerusform>niet gebruikt: {paint} op {count} driehoeken van &apos;{object}&apos; ({attribute}, vanaf regel {line} van {where})</numerusform>
        </translation>
    </message>
    <message>
        <source>output {number} is used by the program itself</source>
        <translation>uitgang {number} wordt door het programma zelf gebruikt</translation>
    </message>
    <message>
        <source>paint it in the window, or give a body</source>
        <translation>beschilder het in het venster, of geef een lichaam op</translation>
    </message>
    <message>
        <source>painted colours</source>
        <translation>geschilderde kleuren</translation>
    </message>
    <message>
        <source>painted supports</source>
        <translation>geschilderde ondersteuning</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pauze</translation>
    </message>
    <message>
        <source>presets hold settings of layers, beads, tool-paths, cooling and quality</source>
        <translation>presets bevatten instellingen van lagen, rupsen, gereedschapsbanen, koeling en kwaliteit</translation>
    </message>
    <message>
        <source>process {process} corrects sizes: layers of regions have no corrections</source>
        <translation>proces {process} corrigeert maten: lagen van gebieden hebben geen correcties</translation>
    </message>
    <message>
        <source>region</source>
        <translation>gebied</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: its mesh is open, and was closed</source>
        <translation>gebied &apos;{region}&apos; uit het bestand: zijn mesh is open en werd gesloten</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: the skin is as thick as the larger one of top and bottom</source>
        <translation>gebied &apos;{region}&apos; uit het bestand: de huid is zo dik als de grootste van boven en onder</translation>
    </message>
    <message numerus="yes">
        <source>region &apos;{region}&apos; from the file: {count} settings</source>
        <translation>
            <numerusform>gebied &apos;{region}&apos; uit het bestand: {count} instelling</numerusform>
            <numerusform>gebied &apos;{region}&apos; uit het bestand: {count} instellingen</numerusform>
        </translation>
    </message>
    <message>
        <source>region &apos;{text}&apos; has no painted surface</source>
        <translation>gebied &apos;{text}&apos; heeft geen beschilderd oppervlak</translation>
    </message>
    <message>
        <source>region &apos;{text}&apos;: &apos;{setting}&apos; is no setting</source>
        <translation>gebied &apos;{text}&apos;: &apos;{setting}&apos; is geen instelling</translation>
    </message>
    <message>
        <source>region {region} cannot be separated from the part: one of them is not closed or intersects itself</source>
        <translation>gebied {region} kan niet van het onderdeel worden gescheiden: een van beide is niet gesloten of doorsnijdt zichzelf</translation>
    </message>
    <message>
        <source>region {region} contains the whole part: nothing carries its layers</source>
        <translation>gebied {region} bevat het hele onderdeel: niets draagt zijn lagen</translation>
    </message>
    <message>
        <source>region {region} cuts away the whole part</source>
        <translation>gebied {region} snijdt het hele onderdeel weg</translation>
    </message>
    <message>
        <source>region {region} follows no surface: it has no layers of its own</source>
        <translation>gebied {region} volgt geen oppervlak: het heeft geen eigen lagen</translation>
    </message>
    <message>
        <source>region {region} has no mesh</source>
        <translation>gebied {region} heeft geen net</translation>
    </message>
    <message>
        <source>region {region} is thinner than the lowest layer ({least})</source>
        <translation>gebied {region} is dunner dan de laagste laag ({least})</translation>
    </message>
    <message>
        <source>region {region}: no face of the part is as flat as that</source>
        <translation>gebied {region}: geen vlak van het onderdeel is zo vlak</translation>
    </message>
    <message>
        <source>regions take away what the part stands on: the rest of it begins {gap:.3g} above its place</source>
        <translation>gebieden nemen weg waarop het onderdeel staat: de rest begint {gap:.3g} boven zijn plaats</translation>
    </message>
    <message>
        <source>remove the regions, or choose another mode</source>
        <translation>verwijder de gebieden, of kies een andere modus</translation>
    </message>
    <message>
        <source>remove the regions, or plan layers of the part (`givenToolPaths=false`)</source>
        <translation>verwijder de gebieden, of plan lagen van het onderdeel (`givenToolPaths=false`)</translation>
    </message>
    <message>
        <source>remove the regions, or set spiral to false</source>
        <translation>verwijder de gebieden, of zet spiral op false</translation>
    </message>
    <message>
        <source>repair the part, or move the region a little</source>
        <translation>repareer het onderdeel, of verplaats het gebied een beetje</translation>
    </message>
    <message>
        <source>setting an output</source>
        <translation>het instellen van een uitgang</translation>
    </message>
    <message>
        <source>settings of a region: {keys}</source>
        <translation>instellingen van een gebied: {keys}</translation>
    </message>
    <message>
        <source>template G-code</source>
        <translation>sjabloon-G-code</translation>
    </message>
    <message>
        <source>the body of a region is not closed</source>
        <translation>het lichaam van een gebied is niet gesloten</translation>
    </message>
    <message>
        <source>the plane leaves a slab of {thickness} at {place}, thinner than a layer</source>
        <translation>het vlak laat bij {place} een plak van {thickness} over, dunner dan een laag</translation>
    </message>
    <message>
        <source>the plane passes between the bodies of the part and cuts none</source>
        <translation>het vlak gaat tussen de lichamen van het onderdeel door en snijdt er geen</translation>
    </message>
    <message>
        <source>the range of heights from {from} to {to} is empty</source>
        <translation>het hoogtebereik van {from} tot {to} is leeg</translation>
    </message>
    <message>
        <source>the statement &apos;{text}&apos; is one of format {wanted}, not of {format}</source>
        <translation>de instructie &apos;{text}&apos; hoort bij formaat {wanted}, niet bij {format}</translation>
    </message>
    <message>
        <source>the tool-paths of a file have no regions</source>
        <translation>de gereedschapsbanen van een bestand hebben geen gebieden</translation>
    </message>
    <message>
        <source>the tools of a file&apos;s tool-paths are its own: none changes before a layer</source>
        <translation>de gereedschappen van de gereedschapsbanen van een bestand zijn die van het bestand: geen ervan wisselt vóór een laag</translation>
    </message>
    <message>
        <source>unknown parameter {key}</source>
        <translation>onbekende parameter {key}</translation>
    </message>
    <message>
        <source>unknown parent &apos;{id}&apos;</source>
        <translation>onbekende ouder &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown region &apos;{name}&apos;</source>
        <translation>onbekend gebied &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown use &apos;{name}&apos; of a region</source>
        <translation>onbekend gebruik &apos;{name}&apos; van een gebied</translation>
    </message>
    <message>
        <source>unsupported voxels in flat layers: {missed} of {voxels} ({share:.1f}); no layer below carries them</source>
        <translation>niet ondersteunde voxels in vlakke lagen: {missed} van {voxels} ({share:.1f}); geen laag eronder draagt ze</translation>
    </message>
    <message>
        <source>use &apos;{text}&apos; of a region has no direction</source>
        <translation>gebruik &apos;{text}&apos; van een gebied heeft geen richting</translation>
    </message>
    <message>
        <source>use another output</source>
        <translation>gebruik een andere uitgang</translation>
    </message>
    <message>
        <source>write {form}, lengths in mm</source>
        <translation>schrijf {form}, lengten in mm</translation>
    </message>
    <message>
        <source>your own statement, which nothing checks: {statement}</source>
        <translation>eigen instructie, die door niets wordt gecontroleerd: {statement}</translation>
    </message>
    <message>
        <source>{key} is a setting of the part, not of a region</source>
        <translation>{key} is een instelling van het onderdeel, niet van een gebied</translation>
    </message>
    <message>
        <source>{name}; changed: {settings}</source>
        <translation>{name}; gewijzigd: {settings}</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebied</translation>
    </message>
    <message>
        <source>&apos;{code}&apos; is missing before the line: it would run ahead of the arm</source>
        <translation>&apos;{code}&apos; ontbreekt vóór de regel: hij zou op de arm vooruitlopen</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; has characters that controllers do not know</source>
        <translation>&apos;{text}&apos; heeft tekens die besturingen niet kennen</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: a pause&apos;s text has at most {limit} characters</source>
        <translation>&apos;{text}&apos;: de tekst van een pauze heeft hoogstens {limit} tekens</translation>
    </message>
    <message>
        <source>a stop shows no text</source>
        <translation>een stop toont geen tekst</translation>
    </message>
    <message>
        <source>shorten the text</source>
        <translation>verkort de tekst</translation>
    </message>
    <message>
        <source>write English letters, digits and signs; in a pause&apos;s text no quotes</source>
        <translation>gebruik Engelse letters, cijfers en tekens; in de tekst van een pauze geen aanhalingstekens</translation>
    </message>
    <message numerus="yes">
        <source>{waits} pauses and waits above the part: the arm reaches no place beside it, nothing is primed, and material may drip on the part</source>
        <translation>
            <numerusform>{waits} pauze of wachttijd boven het onderdeel: de arm bereikt geen plaats ernaast, er wordt niets voorbereid, en er kan materiaal op het onderdeel druppelen</numerusform>
            <numerusform>{waits} pauzes en wachttijden boven het onderdeel: de arm bereikt geen plaats ernaast, er wordt niets voorbereid, en er kan materiaal op het onderdeel druppelen</numerusform>
        </translation>
    </message>
    <message>
        <source>a text is shown without a stop</source>
        <translation>een tekst wordt getoond zonder stop</translation>
    </message>
    <message>
        <source>a module that reads G-code has no commands for stops, waits, tools and outputs</source>
        <translation>een module die G-code leest heeft geen opdrachten voor stops, wachttijden, gereedschappen en uitgangen</translation>
    </message>
    <message>
        <source>give the cell a place for purges or a home pose beside the plate, or move the part on the plate</source>
        <translation>geef de cel een spoelplaats of een rustpositie naast de plaat, of verplaats het onderdeel op de plaat</translation>
    </message>
    <message>
        <source>&apos;Close&apos; is missing behind the text</source>
        <translation>&apos;Close&apos; ontbreekt na de tekst</translation>
    </message>
    <message>
        <source>&apos;Close&apos; without its &apos;Open&apos; before it</source>
        <translation>&apos;Close&apos; zonder bijbehorende &apos;Open&apos; ervoor</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;{name}&apos; tussen PVTEnter en PVTExit</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no point of a curve</source>
        <translation>&apos;{part}&apos; is geen punt van een kromme</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement &apos;{text}&apos; {effect}</source>
        <translation>&apos;{word}&apos; in de instructie &apos;{text}&apos; {effect}</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement before {place}, &apos;{text}&apos;, {effect}</source>
        <translation>&apos;{word}&apos; in de instructie vóór {place}, &apos;{text}&apos;, {effect}</translation>
    </message>
    <message>
        <source>Across
layers MPa</source>
        <translation>Dwars op
lagen MPa</translation>
    </message>
    <message>
        <source>Add a skin</source>
        <translation>Een huid toevoegen</translation>
    </message>
    <message>
        <source>Along
stress %</source>
        <translation>Langs
spanning %</translation>
    </message>
    <message>
        <source>Break-away columns below overhangs beyond the overhang angle, in mode curved below voxels that growth would miss. A region without them blocks them.</source>
        <translation>Afbreekbare kolommen onder overhangen voorbij de overhanghoek, in modus curved onder voxels die de groei zou missen. Een gebied zonder kolommen houdt ze tegen.</translation>
    </message>
    <message>
        <source>Deflec-
tion mm</source>
        <translation>Door-
buiging mm</translation>
    </message>
    <message>
        <source>Factor of the speed of the part&apos;s beads, within the flow of the extruder and the speed of bridges.</source>
        <translation>Factor voor de snelheid van de strengen van het onderdeel, binnen de doorvoer van de extruder en de snelheid van bruggen.</translation>
    </message>
    <message>
        <source>For infill along a field: a direction x,y,z, or x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them. Empty: along the stress between regions that hold the part and regions with a force.</source>
        <translation>Voor vulling langs een veld: een richting x,y,z, of x,y,z,dx,dy,dz in mm op de plaat, gescheiden door spaties of regels, of een bestand daarmee. Leeg: langs de spanning tussen gebieden die het onderdeel vasthouden en gebieden met een kracht.</translation>
    </message>
    <message>
        <source>Force X</source>
        <translation>Kracht X</translation>
    </message>
    <message>
        <source>Force Y</source>
        <translation>Kracht Y</translation>
    </message>
    <message>
        <source>Force Z</source>
        <translation>Kracht Z</translation>
    </message>
    <message>
        <source>Force on the part</source>
        <translation>Kracht op het onderdeel</translation>
    </message>
    <message>
        <source>Held under load</source>
        <translation>Vastgehouden onder belasting</translation>
    </message>
    <message>
        <source>In a region: closed beads that pass through it begin there, or never do if they can begin elsewhere.</source>
        <translation>In een gebied: gesloten strengen die erdoorheen gaan, beginnen daar, of nooit als ze elders kunnen beginnen.</translation>
    </message>
    <message>
        <source>In flat layers the region reaches half of it into the part around it, in every other layer the part reaches as far into the region, so that both hold each other.</source>
        <translation>In vlakke lagen reikt het gebied voor de helft van deze waarde in het onderdeel eromheen; om de andere laag reikt het onderdeel even ver in het gebied, zodat beide elkaar vasthouden.</translation>
    </message>
    <message>
        <source>Region {number}</source>
        <translation>Gebied {number}</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements, which nothing checks.</source>
        <translation>Veilig om uit te voeren, behalve je eigen instructies, die door niets worden gecontroleerd.</translation>
    </message>
    <message>
        <source>Three curved layers along the upper surface, over the flat ones</source>
        <translation>Drie gebogen lagen langs het bovenvlak, over de vlakke heen</translation>
    </message>
    <message>
        <source>What happens before layers of the part, separated by semicolons. Each begins with a layer (12) or a height in mm (z5.5): 12 pause TEXT; 20 wait SECONDS; 30 output NUMBER on; 35 photo OUTPUT SECONDS; 40 tool NUMBER; 50 statement FORMAT LINE.</source>
        <translation>Wat er vóór lagen van het onderdeel gebeurt, gescheiden door puntkomma&apos;s. Elk begint met een laag (12) of een hoogte in mm (z5.5): 12 pause TEKST; 20 wait SECONDEN; 30 output NUMMER on; 35 photo UITGANG SECONDEN; 40 tool NUMMER; 50 statement FORMAAT REGEL.</translation>
    </message>
    <message>
        <source>a line for a wait differs from the line before in its last number</source>
        <translation>een regel voor een wachttijd verschilt in het laatste getal van de regel ervoor</translation>
    </message>
    <message>
        <source>a region with a force contains nothing of the part that is held</source>
        <translation>een gebied met een kracht bevat niets van het onderdeel dat wordt vastgehouden</translation>
    </message>
    <message>
        <source>a skin of layers along the surface has none</source>
        <translation>een huid van lagen langs het oppervlak heeft er geen</translation>
    </message>
    <message>
        <source>a statement of your own sets &apos;{name}&apos;, which the program uses itself</source>
        <translation>een eigen instructie stelt &apos;{name}&apos; in, die het programma zelf gebruikt</translation>
    </message>
    <message>
        <source>add a second region of that shape for its settings</source>
        <translation>voeg voor de instellingen een tweede gebied met die vorm toe</translation>
    </message>
    <message>
        <source>along a field</source>
        <translation>langs een veld</translation>
    </message>
    <message>
        <source>always</source>
        <translation>altijd</translation>
    </message>
    <message>
        <source>changes a temperature</source>
        <translation>wijzigt een temperatuur</translation>
    </message>
    <message>
        <source>changes the extruder</source>
        <translation>wijzigt de extruder</translation>
    </message>
    <message>
        <source>changes the order of the program&apos;s lines</source>
        <translation>wijzigt de volgorde van de programmaregels</translation>
    </message>
    <message>
        <source>changes the origin, the tool or the units</source>
        <translation>wijzigt de oorsprong, het gereedschap of de eenheden</translation>
    </message>
    <message>
        <source>deflection under the forces</source>
        <translation>doorbuiging onder de krachten</translation>
    </message>
    <message>
        <source>field of the infill</source>
        <translation>veld van de vulling</translation>
    </message>
    <message>
        <source>found no equilibrium of the part under its load</source>
        <translation>geen evenwicht van het onderdeel onder zijn belasting gevonden</translation>
    </message>
    <message>
        <source>from the file: {event} at a height of {height}</source>
        <translation>uit het bestand: {event} op een hoogte van {height}</translation>
    </message>
    <message>
        <source>give a direction x,y,z or samples x,y,z,dx,dy,dz, or the part regions that hold it and regions with a force</source>
        <translation>geef een richting x,y,z of monsters x,y,z,dx,dy,dz op, of geef het onderdeel gebieden die het vasthouden en gebieden met een kracht</translation>
    </message>
    <message>
        <source>give a region where the part is fixed the use &apos;hold&apos;</source>
        <translation>geef een gebied waar het onderdeel vastzit het gebruik &apos;hold&apos;</translation>
    </message>
    <message>
        <source>give it as a skin or a painted surface, or use it for settings</source>
        <translation>geef het op als huid of beschilderd oppervlak, of gebruik het voor instellingen</translation>
    </message>
    <message>
        <source>give, for example, 12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript LINE</source>
        <translation>geef bijvoorbeeld 12 pause; 20 pause Plaats de moer; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript REGEL op</translation>
    </message>
    <message>
        <source>hold the part in more places</source>
        <translation>houd het onderdeel op meer plaatsen vast</translation>
    </message>
    <message>
        <source>infill along the stress</source>
        <translation>vulling langs de spanning</translation>
    </message>
    <message>
        <source>interlock of a region</source>
        <translation>vertanding van een gebied</translation>
    </message>
    <message>
        <source>is above &apos;alongMPa&apos;</source>
        <translation>is groter dan &apos;alongMPa&apos;</translation>
    </message>
    <message>
        <source>is above {limit}</source>
        <translation>is groter dan {limit}</translation>
    </message>
    <message>
        <source>leave it out: the plan moves the arm</source>
        <translation>laat hem weg: het plan beweegt de arm</translation>
    </message>
    <message>
        <source>machine {machine} is {verdict}: {reason}</source>
        <translation>machine {machine} is {verdict}: {reason}</translation>
    </message>
    <message>
        <source>move it into the part, paint it, or remove it</source>
        <translation>verplaats het in het onderdeel, beschilder het, of verwijder het</translation>
    </message>
    <message>
        <source>move it onto the part, or make it larger</source>
        <translation>verplaats het naar het onderdeel, of maak het groter</translation>
    </message>
    <message>
        <source>move them onto the part, or make them larger</source>
        <translation>verplaats ze naar het onderdeel, of maak ze groter</translation>
    </message>
    <message>
        <source>moves the arm, or changes how it moves</source>
        <translation>beweegt de arm, of wijzigt hoe die beweegt</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nooit</translation>
    </message>
    <message numerus="yes">
        <source>not used, as it is damaged: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, {where})</source>
        <translation>
            <numerusform>niet gebruikt, want beschadigd: {paint} op {count} driehoek van &apos;{object}&apos; ({attribute}, {where})</numerusform>
            <numerusform>niet gebruikt, want beschadigd: {paint} op {count} driehoeken van &apos;{object}&apos; ({attribute}, {where})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops behind the last bead, where the print is done</source>
        <translation>
            <numerusform>niet gebruikt: {count} stop na de laatste streng, waar de print klaar is</numerusform>
            <numerusform>niet gebruikt: {count} stops na de laatste streng, waar de print klaar is</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} in the file: the part ends at {top}</source>
        <translation>niet gebruikt: {event} op een hoogte van {height} in het bestand: het onderdeel eindigt op {top}</translation>
    </message>
    <message>
        <source>nothing of the part is within the regions that hold it</source>
        <translation>niets van het onderdeel ligt binnen de gebieden die het vasthouden</translation>
    </message>
    <message>
        <source>paint whole faces</source>
        <translation>beschilder hele vlakken</translation>
    </message>
    <message>
        <source>put it into a routine on the controller, and call that</source>
        <translation>zet hem in een routine op de besturing, en roep die aan</translation>
    </message>
    <message>
        <source>region {region} asks for supports, which mode {mode} does not have</source>
        <translation>gebied {region} vraagt om ondersteuning, die modus {mode} niet heeft</translation>
    </message>
    <message>
        <source>region {region} asks for supports: its own layers have none</source>
        <translation>gebied {region} vraagt om ondersteuning: zijn eigen lagen hebben die niet</translation>
    </message>
    <message>
        <source>region {region} carries the load: it has no settings</source>
        <translation>gebied {region} draagt de belasting: het heeft geen instellingen</translation>
    </message>
    <message>
        <source>region {region} is outside the part, behind later regions, or not painted: it has no effect</source>
        <translation>gebied {region} ligt buiten het onderdeel, achter latere gebieden, of is niet beschilderd: het heeft geen effect</translation>
    </message>
    <message>
        <source>region {region}: half of no face of the part is painted</source>
        <translation>gebied {region}: geen enkel vlak van het onderdeel is minstens voor de helft beschilderd</translation>
    </message>
    <message>
        <source>safe to run but for its own statements, which nothing checks</source>
        <translation>veilig om uit te voeren, behalve haar eigen instructies, die door niets worden gecontroleerd</translation>
    </message>
    <message>
        <source>safe to run, but does not print its part as asked</source>
        <translation>veilig om uit te voeren, maar print haar onderdeel niet zoals gevraagd</translation>
    </message>
    <message>
        <source>seam here</source>
        <translation>naad hier</translation>
    </message>
    <message>
        <source>set `supports=none` for the region, or choose another mode</source>
        <translation>zet `supports=none` voor het gebied, of kies een andere modus</translation>
    </message>
    <message>
        <source>set it in the cell before the program starts</source>
        <translation>stel dit in de cel in voordat het programma start</translation>
    </message>
    <message>
        <source>set it in the process</source>
        <translation>stel dit in het proces in</translation>
    </message>
    <message>
        <source>set the temperatures of the material</source>
        <translation>stel de temperaturen van het materiaal in</translation>
    </message>
    <message>
        <source>sets an output</source>
        <translation>stelt een uitgang in</translation>
    </message>
    <message>
        <source>speed factor</source>
        <translation>snelheidsfactor</translation>
    </message>
    <message>
        <source>stops or ends the program</source>
        <translation>stopt of beëindigt het programma</translation>
    </message>
    <message>
        <source>tension across layers</source>
        <translation>trekspanning dwars op de lagen</translation>
    </message>
    <message>
        <source>there are regions with a force, but none that holds the part</source>
        <translation>er zijn gebieden met een kracht, maar geen dat het onderdeel vasthoudt</translation>
    </message>
    <message>
        <source>there is no field of directions for the infill</source>
        <translation>er is geen richtingsveld voor de vulling</translation>
    </message>
    <message>
        <source>under all overhangs</source>
        <translation>onder alle overhangen</translation>
    </message>
    <message>
        <source>use another name</source>
        <translation>gebruik een andere naam</translation>
    </message>
    <message>
        <source>{share:.0f} of the surface are gentle slopes with steps of {mean:.2g} on average</source>
        <translation>{share:.0f} van het oppervlak bestaat uit flauwe hellingen met treden van gemiddeld {mean:.2g}</translation>
    </message>
    <message>
        <source>a force acts only where the part is held</source>
        <translation>een kracht werkt alleen waar het onderdeel wordt vastgehouden</translation>
    </message>
    <message>
        <source>infill across the stress</source>
        <translation>vulling dwars op de spanning</translation>
    </message>
    <message>
        <source>may do anything: Voluta does not know it</source>
        <translation>kan van alles doen: Voluta kent het niet</translation>
    </message>
    <message>
        <source>move the region with the force away from the one that holds</source>
        <translation>verplaats het gebied met de kracht weg van het gebied dat vasthoudt</translation>
    </message>
    <message>
        <source>the flow is not 0 while the extruder is off</source>
        <translation>de stroom is niet 0 terwijl de extruder uit is</translation>
    </message>
    <message>
        <source>the part has no volume to be loaded</source>
        <translation>het onderdeel heeft geen volume om te belasten</translation>
    </message>
    <message>
        <source>use a region of its own for the supports, whose use is settings</source>
        <translation>gebruik voor de steunen een eigen gebied, met gebruik instellingen</translation>
    </message>
    <message>
        <source>use an event for it, for example 12 pause Put in the nut</source>
        <translation>gebruik er een gebeurtenis voor, bijvoorbeeld 12 pause Put in the nut</translation>
    </message>
    <message>
        <source>use an event for it, for example 30 output 3 on</source>
        <translation>gebruik er een gebeurtenis voor, bijvoorbeeld 30 output 3 on</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no direction</source>
        <translation>&apos;{text}&apos; is geen richting</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} &apos;{word}&apos; is not a number</source>
        <translation>&apos;{text}&apos;: {field} &apos;{word}&apos; is geen getal</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} is no whole number</source>
        <translation>&apos;{text}&apos;: {field} is geen geheel getal</translation>
    </message>
    <message>
        <source>Before layer (0: automatic)</source>
        <translation>Vóór laag (0: automatisch)</translation>
    </message>
    <message>
        <source>Inserted part</source>
        <translation>Inzetstuk</translation>
    </message>
    <message>
        <source>Searches for a better orientation of the part: with the smallest overhanging area, with the fewest voxels missed by growth, along the axes, so that the projections on XY and XZ leave the least area of their bounding rectangles empty (blanks for milling), with the smallest overhanging area after the part is cut into pieces (mode planar), or with the least tension across the layers under the load of its regions.</source>
        <translation>Zoekt een betere oriëntatie van het onderdeel: met het kleinste overhangende oppervlak, met de minste door de groei gemiste voxels, langs de assen, zodat de projecties op XY en XZ het kleinste deel van hun omsluitende rechthoeken leeg laten (ruwdelen om te frezen), met het kleinste overhangende oppervlak nadat het onderdeel in delen is gesneden (modus planar), of met de kleinste trekspanning dwars op de lagen onder de belasting van zijn gebieden.</translation>
    </message>
    <message>
        <source>`orient=leastTension` needs a region that pushes the part</source>
        <translation>`orient=leastTension` vereist een gebied dat tegen het onderdeel duwt</translation>
    </message>
    <message>
        <source>add a statement for {format} at that place, or use {formats}</source>
        <translation>voeg op die plaats een instructie voor {format} toe, of gebruik {formats}</translation>
    </message>
    <message>
        <source>beads lie above its place before the print pauses</source>
        <translation>er liggen strengen boven zijn plaats voordat de print pauzeert</translation>
    </message>
    <message>
        <source>beads lie in its place</source>
        <translation>er liggen strengen op zijn plaats</translation>
    </message>
    <message>
        <source>figures</source>
        <translation>cijfers</translation>
    </message>
    <message>
        <source>found no equilibrium of the beads</source>
        <translation>geen evenwicht van de strengen gevonden</translation>
    </message>
    <message>
        <source>give forces that do not cancel each other</source>
        <translation>geef krachten op die elkaar niet opheffen</translation>
    </message>
    <message>
        <source>give regions with the uses &apos;hold&apos; and &apos;load&apos;</source>
        <translation>geef gebieden met het gebruik &apos;hold&apos; en &apos;load&apos; op</translation>
    </message>
    <message>
        <source>give three numbers, x,y,z, of which one is not 0</source>
        <translation>geef drie getallen op, x,y,z, waarvan er één niet 0 is</translation>
    </message>
    <message>
        <source>inserted part</source>
        <translation>inzetstuk</translation>
    </message>
    <message>
        <source>it is narrower than half a bead of {width}</source>
        <translation>het is smaller dan een halve streng van {width}</translation>
    </message>
    <message>
        <source>it is too thin for a layer of its own</source>
        <translation>het is te dun voor een eigen laag</translation>
    </message>
    <message>
        <source>it is too thin to meet a layer</source>
        <translation>het is te dun om een laag te raken</translation>
    </message>
    <message>
        <source>it stands above the first layer after it, so the head keeps away from it</source>
        <translation>het steekt boven de eerste laag erna uit, dus blijft de kop ervan weg</translation>
    </message>
    <message>
        <source>its interlock of {width} reaches through it in {crossed} of {layers} layers</source>
        <translation>de vertanding van {width} reikt er in {crossed} van {layers} lagen doorheen</translation>
    </message>
    <message>
        <source>later regions hold in all of it</source>
        <translation>overal erin gelden latere gebieden</translation>
    </message>
    <message>
        <source>layers along given planes have no supports: those asked for are left out</source>
        <translation>lagen langs gegeven vlakken hebben geen ondersteuning: de gevraagde wordt weggelaten</translation>
    </message>
    <message>
        <source>least tension across layers</source>
        <translation>kleinste trekspanning dwars op de lagen</translation>
    </message>
    <message>
        <source>make it larger, or the layers thinner</source>
        <translation>maak het groter, of de lagen dunner</translation>
    </message>
    <message>
        <source>make it wider, or use a finer nozzle</source>
        <translation>maak het breder, of gebruik een fijnere nozzle</translation>
    </message>
    <message>
        <source>material {material} states no elasticity</source>
        <translation>materiaal {material} vermeldt geen elasticiteit</translation>
    </message>
    <message>
        <source>move it down the list of regions</source>
        <translation>verplaats het omlaag in de lijst met gebieden</translation>
    </message>
    <message>
        <source>no bead is under stress</source>
        <translation>geen streng staat onder spanning</translation>
    </message>
    <message>
        <source>no effect of region {region}: {reason}</source>
        <translation>gebied {region} heeft geen effect: {reason}</translation>
    </message>
    <message>
        <source>nothing is below it when the print pauses</source>
        <translation>er ligt niets onder wanneer de print pauzeert</translation>
    </message>
    <message>
        <source>nothing is printed after it: the print does not pause for it</source>
        <translation>er wordt niets meer na geprint: de print pauzeert er niet voor</translation>
    </message>
    <message>
        <source>remove `layerPlanes`, or set `supports=none`</source>
        <translation>verwijder `layerPlanes`, of stel `supports=none` in</translation>
    </message>
    <message>
        <source>run it on the controller if the rest needs it</source>
        <translation>voer hem op de besturing uit als de rest hem nodig heeft</translation>
    </message>
    <message>
        <source>set a smaller `interlockMm`, or make the region larger</source>
        <translation>stel een kleinere `interlockMm` in, of maak het gebied groter</translation>
    </message>
    <message>
        <source>stiffness and tensions</source>
        <translation>stijfheid en trekspanningen</translation>
    </message>
    <message>
        <source>tape {process} or the plastic around it states no elasticity</source>
        <translation>tape {process} of de kunststof eromheen vermeldt geen elasticiteit</translation>
    </message>
    <message numerus="yes">
        <source>the field is perpendicular to {patches} patches of the layers, filled with straight lines</source>
        <translation>
            <numerusform>het veld staat loodrecht op {patches} deelvlak van de lagen, gevuld met rechte lijnen</numerusform>
            <numerusform>het veld staat loodrecht op {patches} deelvlakken van de lagen, gevuld met rechte lijnen</numerusform>
        </translation>
    </message>
    <message>
        <source>the infill is not along a field</source>
        <translation>de vulling loopt niet langs een veld</translation>
    </message>
    <message>
        <source>the infill of region {region} is not along a field</source>
        <translation>de vulling van gebied {region} loopt niet langs een veld</translation>
    </message>
    <message>
        <source>the inserted part {insert} does not fit: {reason}</source>
        <translation>het inzetstuk {insert} past niet: {reason}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): tension across its layers {tension:.2g} MPa instead of {tensionBefore:.2g}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>het onderdeel is {angle:.0f} gedraaid om ({x}, {y}, {z}): trekspanning dwars op de lagen {tension:.2g} MPa in plaats van {tensionBefore:.2g}, overhang {overhang:.0f} in plaats van {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the rest does not run your statement before its beginning: {statement}</source>
        <translation>de rest voert je instructie van vóór het begin ervan niet uit: {statement}</translation>
    </message>
    <message>
        <source>turn the part, or choose another field or infill</source>
        <translation>draai het onderdeel, of kies een ander veld of een andere vulling</translation>
    </message>
    <message>
        <source>turn the part, or let the region have supports if the overhang sags</source>
        <translation>draai het onderdeel, of geef het gebied ondersteuning als de overhang doorhangt</translation>
    </message>
    <message>
        <source>unknown {figures} under the forces: {reason}</source>
        <translation>{figures} onder de krachten onbekend: {reason}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle} where regions block supports; here is most of it</source>
        <translation>{area:.3g} hangt meer dan {angle} over waar gebieden ondersteuning tegenhouden; het meeste ligt hier</translation>
    </message>
    <message>
        <source>give the material its elasticity</source>
        <translation>geef het materiaal zijn elasticiteit</translation>
    </message>
    <message>
        <source>give the modulus and the share of its fibres, and the elasticity of the plastic</source>
        <translation>geef de modulus en het aandeel van de vezels op, en de elasticiteit van de kunststof</translation>
    </message>
    <message>
        <source>it is thinner than a layer, which leaves no room for it</source>
        <translation>het is dunner dan een laag, die er geen ruimte voor laat</translation>
    </message>
    <message>
        <source>it reaches below the plate</source>
        <translation>het reikt tot onder de plaat</translation>
    </message>
    <message>
        <source>it takes the place of {other}</source>
        <translation>het neemt de plaats in van {other}</translation>
    </message>
    <message>
        <source>move its region on the Prepare page</source>
        <translation>verplaats zijn gebied op de pagina Voorbereiden</translation>
    </message>
    <message>
        <source>move its region, or choose the layer before which it is put in</source>
        <translation>verplaats zijn gebied, of kies de laag waarvóór het wordt geplaatst</translation>
    </message>
    <message>
        <source>no effect of {key}: {reason}</source>
        <translation>{key} heeft geen effect: {reason}</translation>
    </message>
    <message>
        <source>set `infill=field`, or remove the field</source>
        <translation>stel `infill=field` in, of verwijder het veld</translation>
    </message>
</context>
<context>
    <name>EventMarks</name>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Pause: %1</source>
        <translation>Pauze: %1</translation>
    </message>
    <message>
        <source>Wait: %1 s</source>
        <translation>Wachten: %1 s</translation>
    </message>
    <message>
        <source>Output %1 on</source>
        <translation>Uitgang %1 aan</translation>
    </message>
    <message>
        <source>Output %1 off</source>
        <translation>Uitgang %1 uit</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Gereedschap %1</translation>
    </message>
    <message>
        <source>Before layer %1: %2</source>
        <translation>Vóór laag %1: %2</translation>
    </message>
</context>
<context>
    <name>Gizmo</name>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>HeadNumbersDialog</name>
    <message>
        <source>Nozzle tip radius</source>
        <translation>Straal van de nozzlepunt</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>Kegelhoek</translation>
    </message>
    <message>
        <source>Cone height</source>
        <translation>Kegelhoogte</translation>
    </message>
    <message>
        <source>Block width</source>
        <translation>Blokbreedte</translation>
    </message>
    <message>
        <source>Block height</source>
        <translation>Blokhoogte</translation>
    </message>
</context>
<context>
    <name>LayerEvents</name>
    <message>
        <source>The next plan pauses before layer %1.</source>
        <translation>Het volgende plan pauzeert vóór laag %1.</translation>
    </message>
    <message>
        <source>The next plan does not pause before layer %1.</source>
        <translation>Het volgende plan pauzeert niet vóór laag %1.</translation>
    </message>
    <message>
        <source>The next plan has the event before layer %1.</source>
        <translation>Het volgende plan heeft de gebeurtenis vóór laag %1.</translation>
    </message>
</context>
<context>
    <name>LegendFigures</name>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Aandeel</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Travel and waits</source>
        <translation>Verplaatsen en wachten</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 tot %2</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>Alle instellingen</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>instelling</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>betekenis</translation>
    </message>
    <message>
        <source>range</source>
        <translation>bereik</translation>
    </message>
    <message>
        <source>default</source>
        <translation>standaard</translation>
    </message>
    <message>
        <source>key</source>
        <translation>sleutel</translation>
    </message>
    <message>
        <source>All findings</source>
        <translation>Alle bevindingen</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>bevinding</translation>
    </message>
    <message>
        <source>what would help</source>
        <translation>wat zou helpen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhoud</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>Algoritmen</translation>
    </message>
</context>
<context>
    <name>MillForm</name>
    <message>
        <source>Cutter diameter</source>
        <translation>Freesdiameter</translation>
    </message>
    <message>
        <source>The cutter has a round end</source>
        <translation>De frees heeft een rond uiteinde</translation>
    </message>
    <message>
        <source>0: side load of the material; less leaves lower ridges</source>
        <translation>0: zijdelingse aanzet van het materiaal; minder laat lagere ribbels achter</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>volgens materiaal</translation>
    </message>
    <message>
        <source>Roughing depth</source>
        <translation>Voorfreesdiepte</translation>
    </message>
    <message>
        <source>Depth of one pass that stays above the part</source>
        <translation>Diepte van één gang die boven het onderdeel blijft</translation>
    </message>
    <message>
        <source>Across the lines; more than the cutter&apos;s diameter</source>
        <translation>Dwars op de lijnen; meer dan de freesdiameter</translation>
    </message>
    <message>
        <source>Along the lines, with the ends that hold the block; more than the cutter&apos;s diameter</source>
        <translation>Langs de lijnen, met de uiteinden die het blok vasthouden; meer dan de freesdiameter</translation>
    </message>
    <message>
        <source>Thickness that is milled away over the whole part</source>
        <translation>Dikte die over het hele onderdeel wordt weggefreesd</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Vrije afstand</translation>
    </message>
    <message>
        <source>Height of rapid moves above the block</source>
        <translation>Hoogte van ijlgangen boven het blok</translation>
    </message>
    <message>
        <source>Of the contour, at the part&apos;s lower end along y; cut by hand</source>
        <translation>Van de contour, aan het onderste uiteinde van het onderdeel langs y; met de hand doorsnijden</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Zijstap</translation>
    </message>
    <message>
        <source>Stock beyond the part, y</source>
        <translation>Overmaat buiten het onderdeel, y</translation>
    </message>
    <message>
        <source>Stock beyond the part, x</source>
        <translation>Overmaat buiten het onderdeel, x</translation>
    </message>
    <message>
        <source>Stock above and below</source>
        <translation>Overmaat boven en onder</translation>
    </message>
    <message>
        <source>Holding tab</source>
        <translation>Houdlip</translation>
    </message>
</context>
<context>
    <name>MillPicture</name>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Rapid moves</source>
        <translation>IJlgangen</translation>
    </message>
    <message>
        <source>Side A, roughing</source>
        <translation>Kant A, voorfrezen</translation>
    </message>
    <message>
        <source>Side A, finishing</source>
        <translation>Kant A, nafrezen</translation>
    </message>
    <message>
        <source>Side B, roughing</source>
        <translation>Kant B, voorfrezen</translation>
    </message>
    <message>
        <source>Side B, finishing</source>
        <translation>Kant B, nafrezen</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
</context>
<context>
    <name>ModeSwitch</name>
    <message>
        <source>This way of building does not support that platform.</source>
        <translation>Deze bouwwijze ondersteunt dat platform niet.</translation>
    </message>
    <message>
        <source>This way of building places the part itself: the search for an orientation does not apply.</source>
        <translation>Deze bouwwijze plaatst het onderdeel zelf: het zoeken naar een oriëntatie geldt niet.</translation>
    </message>
    <message>
        <source>This way of building needs the scale as a number.</source>
        <translation>Deze bouwwijze heeft de schaal als getal nodig.</translation>
    </message>
    <message>
        <source>The platform file %1 is missing.</source>
        <translation>Het platformbestand %1 ontbreekt.</translation>
    </message>
    <message>
        <source>This way of building needs a cell with a rotating rod.</source>
        <translation>Deze bouwwijze vereist een cel met een draaiende staaf.</translation>
    </message>
    <message>
        <source>This cell rotates a rod: this way of building needs one with a plate.</source>
        <translation>Deze cel draait een staaf: deze bouwwijze vereist er een met een plaat.</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>on</source>
        <translation>aan</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>Range: %1 to %2</source>
        <translation>Bereik: %1 tot %2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Standaard: %1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Sleutel: %1</translation>
    </message>
</context>
<context>
    <name>PresetBar</name>
    <message>
        <source>&amp;Save</source>
        <translation>Op&amp;slaan</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Opslaan &amp;als…</translation>
    </message>
    <message>
        <source>D&amp;iscard changes</source>
        <translation>W&amp;ijzigingen verwerpen</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>He&amp;rnoemen…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>Verwij&amp;deren…</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>Vergelijken &amp;met…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporteren…</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>I&amp;mporteren…</translation>
    </message>
</context>
<context>
    <name>Quote</name>
    <message>
        <source>Quote: %1</source>
        <translation>Offerte: %1</translation>
    </message>
    <message>
        <source>Price: %1</source>
        <translation>Prijs: %1</translation>
    </message>
    <message>
        <source>printed in %1, %2 g of material</source>
        <translation>geprint in %1, %2 g materiaal</translation>
    </message>
    <message>
        <source>The price of a material is missing.</source>
        <translation>De prijs van een materiaal ontbreekt.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Afmetingen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>%1, %2 g at %3 per kg: %4</source>
        <translation>%1, %2 g à %3 per kg: %4</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>%1 at %2 per hour: %3</source>
        <translation>%1 à %2 per uur: %3</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Instellen</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>Prijs</translation>
    </message>
</context>
<context>
    <name>Resume</name>
    <message>
        <source>Bead %1 of %2</source>
        <translation>Streng %1 van %2</translation>
    </message>
</context>
<context>
    <name>SettingWords</name>
    <message>
        <source>quality, resolution, thickness, fine, coarse, detail</source>
        <translation>kwaliteit, resolutie, dikte, fijn, grof, detail, quality</translation>
    </message>
    <message>
        <source>line width, extrusion width, nozzle, bead</source>
        <translation>lijnbreedte, extrusiebreedte, nozzle, spuitmond, line width</translation>
    </message>
    <message>
        <source>first layer, adhesion, line width, extrusion width</source>
        <translation>eerste laag, hechting, lijnbreedte, extrusiebreedte, first layer</translation>
    </message>
    <message>
        <source>retract, ooze, stringing, oozing</source>
        <translation>intrekken, retractie, lekken, draden, retract, stringing, oozing</translation>
    </message>
    <message>
        <source>resolution, point distance, segment length</source>
        <translation>resolutie, puntafstand, segmentlengte</translation>
    </message>
    <message>
        <source>perimeter, perimeters, shell, shells, outline, contour, strength</source>
        <translation>perimeter, perimeters, schil, schillen, omtrek, contour, sterkte, shell</translation>
    </message>
    <message>
        <source>fill, pattern, solid, interior</source>
        <translation>vullen, vulling, patroon, massief, binnenste, infill</translation>
    </message>
    <message>
        <source>fill, percent, solid, hollow, strength, interior</source>
        <translation>vullen, vulling, procent, massief, hol, sterkte, binnenste, infill</translation>
    </message>
    <message>
        <source>fill, infill, gyroid, honeycomb, grid</source>
        <translation>vullen, vulling, infill, gyroïde, honingraat, raster, gyroid, honeycomb, grid</translation>
    </message>
    <message>
        <source>roof, skin, top surface, shell</source>
        <translation>dak, huid, bovenvlak, schil, top, shell</translation>
    </message>
    <message>
        <source>floor, skin, bottom surface, shell</source>
        <translation>vloer, bodem, huid, ondervlak, schil, bottom, shell</translation>
    </message>
    <message>
        <source>roof, floor, top, bottom, shell</source>
        <translation>dak, vloer, boven, onder, schil, shell</translation>
    </message>
    <message>
        <source>orientation, rotation</source>
        <translation>oriëntatie, draaiing, rotatie</translation>
    </message>
    <message>
        <source>overhang, support, support material, bridge, hanging</source>
        <translation>overhang, ondersteuning, support, steunmateriaal, brug, hangend</translation>
    </message>
    <message>
        <source>overhang, support material, hanging, edge</source>
        <translation>overhang, steunmateriaal, support, hangend, rand</translation>
    </message>
    <message>
        <source>support, bridge, hanging, tilt</source>
        <translation>ondersteuning, support, brug, hangend, kantelen</translation>
    </message>
    <message>
        <source>skirt, purge, priming, start line, prime line</source>
        <translation>skirt, spoelen, primen, startlijn, purge, prime line</translation>
    </message>
    <message>
        <source>skirt, purge, start line</source>
        <translation>skirt, spoelen, startlijn, purge</translation>
    </message>
    <message>
        <source>adhesion, skirt, raft, warping, lifting, bed</source>
        <translation>hechting, skirt, raft, kromtrekken, loslaten, bed, warping</translation>
    </message>
    <message>
        <source>zipper, start point, z seam, scar</source>
        <translation>rits, beginpunt, z-naad, litteken, z seam</translation>
    </message>
    <message>
        <source>thin, narrow, detail</source>
        <translation>dun, smal, detail</translation>
    </message>
    <message>
        <source>vase, spiralize, continuous</source>
        <translation>vaas, spiraliseren, doorlopend, vase, spiralize</translation>
    </message>
    <message>
        <source>vase</source>
        <translation>vaas, vase</translation>
    </message>
    <message>
        <source>cooling, fan, temperature, overheating</source>
        <translation>koeling, ventilator, temperatuur, oververhitting, fan</translation>
    </message>
    <message>
        <source>cooling, temperature, fan, pause, wait, overheating</source>
        <translation>koeling, temperatuur, ventilator, pauze, wachten, oververhitting, fan</translation>
    </message>
    <message>
        <source>temperature, adhesion, cold joint, interlayer</source>
        <translation>temperatuur, hechting, koude naad, tussen lagen, interlayer</translation>
    </message>
    <message>
        <source>strength, force, stress</source>
        <translation>sterkte, kracht, spanning</translation>
    </message>
    <message>
        <source>perimeter, feed rate, velocity</source>
        <translation>perimeter, voeding, snelheid, feed rate</translation>
    </message>
    <message>
        <source>fill, feed rate, velocity</source>
        <translation>vullen, vulling, voeding, snelheid, infill, feed rate</translation>
    </message>
    <message>
        <source>overhang, feed rate, velocity</source>
        <translation>overhang, voeding, snelheid, feed rate</translation>
    </message>
    <message>
        <source>adhesion, feed rate, velocity, bed</source>
        <translation>hechting, voeding, snelheid, bed, feed rate</translation>
    </message>
    <message>
        <source>z hop, travel, retract, hop</source>
        <translation>z-hop, verplaatsing, intrekken, hop, travel, retract</translation>
    </message>
    <message>
        <source>stringing, ooze, seam</source>
        <translation>draden, lekken, naad, stringing, ooze</translation>
    </message>
    <message>
        <source>tool orientation, spin</source>
        <translation>gereedschapsoriëntatie, draaien, spin</translation>
    </message>
    <message>
        <source>tool orientation, angle</source>
        <translation>gereedschapsoriëntatie, hoek</translation>
    </message>
    <message>
        <source>collision, distance, safety, robot</source>
        <translation>botsing, afstand, veiligheid, robot</translation>
    </message>
    <message>
        <source>collision, distance, safety, nozzle</source>
        <translation>botsing, afstand, veiligheid, nozzle</translation>
    </message>
    <message>
        <source>collision, check</source>
        <translation>botsing, controle</translation>
    </message>
    <message>
        <source>configuration, flip, elbow, wrist</source>
        <translation>configuratie, omklappen, elleboog, pols, flip</translation>
    </message>
    <message>
        <source>acceleration, vibration, smooth</source>
        <translation>versnelling, trilling, vloeiend</translation>
    </message>
    <message>
        <source>rotate, orientation, auto orient, lay flat</source>
        <translation>draaien, oriëntatie, automatisch oriënteren, plat leggen, auto orient</translation>
    </message>
    <message>
        <source>repair, hole, mesh, thin, shell</source>
        <translation>herstellen, repareren, gat, mesh, dun, schil</translation>
    </message>
    <message>
        <source>variable layer height, quality</source>
        <translation>variabele laaghoogte, kwaliteit, variable layer height</translation>
    </message>
    <message>
        <source>variable layer height, quality, adaptive</source>
        <translation>variabele laaghoogte, kwaliteit, adaptief, adaptive</translation>
    </message>
    <message>
        <source>extruder, nozzle, multi material, head</source>
        <translation>extruder, nozzle, multimateriaal, multi material, kop</translation>
    </message>
    <message>
        <source>extruder, multi material, soluble</source>
        <translation>extruder, multimateriaal, multi material, oplosbaar</translation>
    </message>
    <message>
        <source>extruder, multi material, fill</source>
        <translation>extruder, multimateriaal, multi material, vulling</translation>
    </message>
    <message>
        <source>extruder, multi material</source>
        <translation>extruder, multimateriaal, multi material</translation>
    </message>
    <message>
        <source>tool change, wipe tower, multi material, colour change</source>
        <translation>gereedschapswissel, tool change, wipe tower, multimateriaal, kleurwissel</translation>
    </message>
    <message>
        <source>carbon, continuous fibre, reinforcement, strength</source>
        <translation>carbon, koolstof, continue vezel, versterking, sterkte</translation>
    </message>
    <message>
        <source>resolution, grid</source>
        <translation>resolutie, raster, grid</translation>
    </message>
    <message>
        <source>split program, memory</source>
        <translation>programma splitsen, geheugen</translation>
    </message>
    <message>
        <source>simplify, tolerance</source>
        <translation>vereenvoudigen, tolerantie</translation>
    </message>
    <message>
        <source>G2, G3, circle</source>
        <translation>G2, G3, cirkel</translation>
    </message>
    <message>
        <source>tolerance, strict, draft</source>
        <translation>tolerantie, strikt, concept, draft</translation>
    </message>
    <message>
        <source>strategy, slicing, non-planar, way of building</source>
        <translation>strategie, slicen, niet-vlak, non-planar, bouwwijze</translation>
    </message>
    <message>
        <source>plate, bed, build plate, table, rod</source>
        <translation>plaat, bed, bouwplaat, tafel, staaf</translation>
    </message>
    <message>
        <source>robot, arm, machine, printer, nozzle, head</source>
        <translation>robot, arm, machine, printer, nozzle, kop</translation>
    </message>
    <message>
        <source>nozzle, tool, extruder, speed, feed rate, bead, head, temperature</source>
        <translation>nozzle, gereedschap, extruder, snelheid, voeding, streng, kop, temperatuur</translation>
    </message>
    <message>
        <source>temperature, filament, plastic, heat, hot end, bed, fan, cooling, price, cost, flow, retraction</source>
        <translation>temperatuur, filament, kunststof, warmte, hot end, bed, ventilator, koeling, prijs, kosten, doorvoer, intrekken</translation>
    </message>
    <message>
        <source>tool, second nozzle, extruder, multi material, tool change, colour</source>
        <translation>gereedschap, tool, tweede nozzle, extruder, multimateriaal, gereedschapswissel, kleur</translation>
    </message>
    <message>
        <source>scheme, curved, algorithm</source>
        <translation>schema, gebogen, algoritme</translation>
    </message>
    <message>
        <source>random, repeatable</source>
        <translation>willekeurig, random, herhaalbaar</translation>
    </message>
    <message>
        <source>as process</source>
        <translation>zoals het proces</translation>
    </message>
    <message>
        <source>none</source>
        <translation>geen</translation>
    </message>
    <message>
        <source>no brim</source>
        <translation>geen brim</translation>
    </message>
    <message>
        <source>as the part</source>
        <translation>zoals het onderdeel</translation>
    </message>
    <message>
        <source>no tapes</source>
        <translation>geen tapes</translation>
    </message>
    <message>
        <source>all that fit</source>
        <translation>zoveel als er passen</translation>
    </message>
    <message>
        <source>only waits</source>
        <translation>alleen wachten</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>geen grens</translation>
    </message>
    <message>
        <source>one bead</source>
        <translation>één streng</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nooit</translation>
    </message>
    <message>
        <source>as format</source>
        <translation>zoals het formaat</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rond</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>pause, stop, colour change, insert, M600</source>
        <translation>pauze, stop, kleurwissel, inzetstuk, M600</translation>
    </message>
</context>
<context>
    <name>SizesDialog</name>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Slot length</source>
        <translation>Sleuflengte</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>Sleufbreedte</translation>
    </message>
    <message>
        <source>Hole diameter</source>
        <translation>Gatdiameter</translation>
    </message>
</context>
<context>
    <name>TypedChange</name>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1: %2 mm</translation>
    </message>
</context>
<context>
    <name>ValueBoxes</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 tot %2</translation>
    </message>
    <message>
        <source>This character is not possible here. Enter a number: %1.</source>
        <translation>Dit teken is hier niet mogelijk. Voer een getal in: %1.</translation>
    </message>
    <message>
        <source>%1 is not possible here: %2 is used. Range: %3.</source>
        <translation>%1 is hier niet mogelijk: %2 wordt gebruikt. Bereik: %3.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Naamloos</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 wijzigen</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 herstellen</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle parameters herstellen</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>Onderdeel schalen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 openen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 dupliceren</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>Change print order</source>
        <translation>Printvolgorde wijzigen</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>Onderdelen schikken</translation>
    </message>
    <message>
        <source>Paste %1 parts</source>
        <translation>%1 onderdelen plakken</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 plakken</translation>
    </message>
    <message>
        <source>Remove %1 parts</source>
        <translation>%1 onderdelen verwijderen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 hernoemen</translation>
    </message>
</context>
<context>
    <name>voluta::document::Opening</name>
    <message>
        <source>the rest of %1</source>
        <translation>de rest van %1</translation>
    </message>
</context>
<context>
    <name>voluta::document::RecentFiles</name>
    <message>
        <source>%1 no longer exists. It was removed from the list.</source>
        <translation>%1 bestaat niet meer en is uit de lijst verwijderd.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Saving</name>
    <message>
        <source>There is nothing to save yet. Open a part first.</source>
        <translation>Er is nog niets op te slaan. Open eerst een onderdeel.</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ChoicesForm</name>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Platform</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cel</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Proces</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startgetal</translation>
    </message>
    <message>
        <source>Another seed may find other travel paths; the same seed always gives the same result.</source>
        <translation>Een ander startgetal kan andere verplaatsingsbanen opleveren; hetzelfde startgetal geeft altijd hetzelfde resultaat.</translation>
    </message>
    <message>
        <source>Your own cells are JSON files in %1</source>
        <translation>Je eigen cellen zijn JSON-bestanden in %1</translation>
    </message>
    <message>
        <source>Your own processes are JSON files in %1</source>
        <translation>Je eigen processen zijn JSON-bestanden in %1</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Your own materials are JSON files in %1</source>
        <translation>Je eigen materialen zijn JSON-bestanden in %1</translation>
    </message>
    <message>
        <source>Edit processes</source>
        <translation>Processen bewerken</translation>
    </message>
    <message>
        <source>Edit materials</source>
        <translation>Materialen bewerken</translation>
    </message>
    <message>
        <source>Growth scheme</source>
        <translation>Groeischema</translation>
    </message>
    <message>
        <source>How the part is divided into layers</source>
        <translation>Hoe het onderdeel in lagen wordt verdeeld</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterForm</name>
    <message>
        <source>Simple</source>
        <translation>Eenvoudig</translation>
    </message>
    <message>
        <source>Show the most important and the changed parameters</source>
        <translation>De belangrijkste en de gewijzigde parameters tonen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Show every parameter</source>
        <translation>Elke parameter tonen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alles herstellen</translation>
    </message>
    <message>
        <source>Reset every parameter to its default</source>
        <translation>Elke parameter op de standaardwaarde terugzetten</translation>
    </message>
    <message>
        <source>No matching parameter.</source>
        <translation>Geen overeenkomende parameter.</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Printen</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Onderzoek</translation>
    </message>
    <message>
        <source>Search settings</source>
        <translation>Instellingen zoeken</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterRow</name>
    <message>
        <source>Reset to %1</source>
        <translation>Op %1 terugzetten</translation>
    </message>
    <message>
        <source>Files (%1)</source>
        <translation>Bestanden (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Kies een bestand</translation>
    </message>
</context>
<context>
    <name>voluta::forms::PlatformEditor</name>
    <message>
        <source>Body to print on</source>
        <translation>Lichaam om op te printen</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Kies een bestand…</translation>
    </message>
    <message>
        <source>A closed mesh, positioned as in the part&apos;s file</source>
        <translation>Een gesloten mesh, geplaatst zoals in het bestand van het onderdeel</translation>
    </message>
    <message>
        <source>%1
Click to choose another one</source>
        <translation>%1
Klik om een ander te kiezen</translation>
    </message>
    <message>
        <source>Stepped: x,radius points</source>
        <translation>Getrapt: punten x,straal</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rond</translation>
    </message>
    <message>
        <source>Hexagonal, across corners</source>
        <translation>Zeskant, over de hoeken</translation>
    </message>
    <message>
        <source>%1 sides, across corners</source>
        <translation>%1 zijden, over de hoeken</translation>
    </message>
    <message>
        <source>Shape of the rod</source>
        <translation>Vorm van de staaf</translation>
    </message>
    <message>
        <source>Profile of the rod</source>
        <translation>Profiel van de staaf</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm; a step has two pairs at one x</source>
        <translation>Paren van x en straal in mm; een trap heeft twee paren bij dezelfde x</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Meshes (%1);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Surface on which the print begins</source>
        <translation>Oppervlak waarop de print begint</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ToolRows</name>
    <message>
        <source>Add tool</source>
        <translation>Gereedschap toevoegen</translation>
    </message>
    <message>
        <source>Adds a second nozzle or material, for some parts, supports, pieces or the interior. The program stops for each change.</source>
        <translation>Voegt een tweede nozzle of materiaal toe, voor sommige onderdelen, ondersteuning, delen of het inwendige. Het programma stopt bij elke wissel.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Gereedschap %1</translation>
    </message>
    <message>
        <source>Process of tool %1</source>
        <translation>Proces van gereedschap %1</translation>
    </message>
    <message>
        <source>Material of tool %1</source>
        <translation>Materiaal van gereedschap %1</translation>
    </message>
    <message>
        <source>Remove tool %1</source>
        <translation>Gereedschap %1 verwijderen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ComparePanel</name>
    <message>
        <source>Cells</source>
        <translation>Cellen</translation>
    </message>
    <message>
        <source>Compares these cells; none selected: the job&apos;s own</source>
        <translation>Vergelijkt deze cellen; geen geselecteerd: die van de opdracht</translation>
    </message>
    <message>
        <source>Open a part first.</source>
        <translation>Open eerst een onderdeel.</translation>
    </message>
    <message>
        <source>Select what to compare.</source>
        <translation>Selecteer wat je wilt vergelijken.</translation>
    </message>
    <message>
        <source>Plans: %1</source>
        <translation>Plannen: %1</translation>
    </message>
    <message>
        <source>Ways of building</source>
        <translation>Bouwwijzen</translation>
    </message>
    <message>
        <source>Growth of curved layers</source>
        <translation>Groei van gebogen lagen</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>Platforms</translation>
    </message>
    <message>
        <source>Delete removes the selected one from the list</source>
        <translation>Delete verwijdert het geselecteerde uit de lijst</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>Also compare with this platform</source>
        <translation>Ook met dit platform vergelijken</translation>
    </message>
    <message>
        <source>Plan up to</source>
        <translation>Plannen tot en met</translation>
    </message>
    <message>
        <source>verified programs</source>
        <translation>geverifieerde programma&apos;s</translation>
    </message>
    <message>
        <source>missed voxels and pieces</source>
        <translation>gemiste voxels en delen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergelijken</translation>
    </message>
    <message>
        <source>Plans them one after the other, in the background</source>
        <translation>Plant ze één voor één, op de achtergrond</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Stops; completed rows are kept</source>
        <translation>Stopt; voltooide rijen blijven behouden</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichten</translation>
    </message>
    <message>
        <source>Ways without blocking findings rank first, then the lowest score: each figure as a share of the column&apos;s largest, times its weight.</source>
        <translation>Bouwwijzen zonder blokkerende bevindingen staan vooraan, daarna telt de laagste score: elk cijfer als aandeel van het grootste in de kolom, maal het gewicht.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Restore the default weights</source>
        <translation>Standaardgewichten herstellen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CompareTable</name>
    <message>
        <source>Best</source>
        <translation>Beste</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In gebruik</translation>
    </message>
    <message>
        <source>Rank, and the score below it: lower is better</source>
        <translation>Rang, met daaronder de score: lager is beter</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Plaats</translation>
    </message>
    <message>
        <source>Way of building</source>
        <translation>Bouwwijze</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CursorInfo</name>
    <message>
        <source>Line %1</source>
        <translation>Regel %1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Spuitmond</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Kanteling</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gewrichten</translation>
    </message>
    <message>
        <source>The nozzle&apos;s tip, from the middle of the platform</source>
        <translation>De punt van de spuitmond, vanaf het midden van het platform</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotatie</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Geprint</translation>
    </message>
    <message>
        <source>About X, Y and Z of the platform, from the upright nozzle</source>
        <translation>Om X, Y en Z van het platform, vanaf de verticale spuitmond</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CutPanel</name>
    <message>
        <source>Cut</source>
        <translation>Snijden</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 snijden</translation>
    </message>
    <message>
        <source>Perpendicular to</source>
        <translation>Loodrecht op</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Positie</translation>
    </message>
    <message>
        <source>Distance from the lowest point of the part along the axis</source>
        <translation>Afstand tot het laagste punt van het onderdeel langs de as</translation>
    </message>
    <message>
        <source>Tilt about %1</source>
        <translation>Kanteling om %1</translation>
    </message>
    <message>
        <source>Parallel to a face</source>
        <translation>Evenwijdig aan een vlak van het onderdeel</translation>
    </message>
    <message>
        <source>Then click the face; the plane goes through the clicked point</source>
        <translation>Klik daarna op het vlak; het snijvlak gaat door dat punt</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behouden</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>Beide helften</translation>
    </message>
    <message>
        <source>Lower half</source>
        <translation>Onderste helft</translation>
    </message>
    <message>
        <source>Upper half</source>
        <translation>Bovenste helft</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Verbinding</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>Dowels</source>
        <translation>Deuvels</translation>
    </message>
    <message>
        <source>Pegs</source>
        <translation>Pennen</translation>
    </message>
    <message>
        <source>Dovetail</source>
        <translation>Zwaluwstaart</translation>
    </message>
    <message>
        <source>Dowels: loose pins in holes of both halves. Pegs: pins of the lower half. Dovetail: a tongue of the lower half in a groove.</source>
        <translation>Deuvels: losse pennen in gaten van beide helften. Pennen: vast aan de onderste helft. Zwaluwstaart: een tong van de onderste helft in een groef.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Diepte</translation>
    </message>
    <message>
        <source>Height of the tongue</source>
        <translation>Hoogte van de tong</translation>
    </message>
    <message>
        <source>Of a pin in each half</source>
        <translation>Van een pen in elke helft</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Speling</translation>
    </message>
    <message>
        <source>Gap on every side of a pin or of the tongue</source>
        <translation>Ruimte aan elke kant van een pen of van de tong</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Aantal</translation>
    </message>
    <message>
        <source>Pins in each section, if there is room</source>
        <translation>Pennen in elke doorsnede, als er plaats is</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richting</translation>
    </message>
    <message>
        <source>In which the dovetail slides, from the horizontal</source>
        <translation>Waarin de zwaluwstaart schuift, vanaf de horizontaal</translation>
    </message>
    <message>
        <source>Lay halves on their cut face</source>
        <translation>Helften op hun snijvlak leggen</translation>
    </message>
    <message>
        <source>A half with pegs or a tongue keeps its orientation</source>
        <translation>Een helft met pennen of een tong behoudt haar stand</translation>
    </message>
    <message>
        <source>Show apart</source>
        <translation>Uit elkaar tonen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>voluta::panels::EffectCard</name>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Takes the remedy back, and shows the plan before it</source>
        <translation>Maakt de remedie ongedaan, en toont het plan ervoor</translation>
    </message>
    <message>
        <source>Hide this</source>
        <translation>Dit verbergen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ExportPanel</name>
    <message>
        <source>Replay of %1</source>
        <translation>Controlerun van %1</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Controlerun</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Kies ten minste één formaat.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Kies een map.</translation>
    </message>
    <message>
        <source>Folder for the programs</source>
        <translation>Map voor de programma&apos;s</translation>
    </message>
    <message>
        <source>Refused programs</source>
        <translation>Geweigerde programma&apos;s</translation>
    </message>
    <message>
        <source>The replay refused some of the programs. Never run them on a robot.</source>
        <translation>De controlerun heeft een deel van de programma&apos;s geweigerd. Voer ze nooit uit op een robot.</translation>
    </message>
    <message>
        <source>For inspection only, they can be saved as:</source>
        <translation>Alleen ter inspectie kunnen ze worden opgeslagen als:</translation>
    </message>
    <message>
        <source>Save them too</source>
        <translation>Ook opslaan</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Weglaten</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>Formaten</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>Programmatekst</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Bladeren…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>%1 options</source>
        <translation>Opties voor %1</translation>
    </message>
    <message>
        <source>Blocked plan</source>
        <translation>Geblokkeerd plan</translation>
    </message>
    <message>
        <source>The plan has blocking findings: %1</source>
        <translation>Het plan heeft blokkerende bevindingen: %1</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Toch exporteren</translation>
    </message>
    <message>
        <source>Not as asked</source>
        <translation>Niet zoals gevraagd</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>Veilig uit te voeren, niet zoals gevraagd: %1</translation>
    </message>
    <message>
        <source>The part will differ from the requested one there. To export without this question, accept it in the list of findings.</source>
        <translation>Het onderdeel wijkt daar af van het gevraagde. Accepteer dit in de lijst met bevindingen om zonder deze vraag te exporteren.</translation>
    </message>
    <message>
        <source>Do not run the programs before these are solved.</source>
        <translation>Voer de programma&apos;s niet uit voordat dit is opgelost.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Niet gecontroleerd</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>Veilig uit te voeren, behalve je eigen instructies: %1</translation>
    </message>
    <message>
        <source>Nothing checks what they do. Try them on the controller with the arm clear first.</source>
        <translation>Niets controleert wat ze doen. Probeer ze eerst op de besturing terwijl de arm vrij staat.</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsModel</name>
    <message>
        <source>Blocked: %1</source>
        <translation>Geblokkeerd: %1</translation>
    </message>
    <message>
        <source>Worth knowing: %1</source>
        <translation>Goed om te weten: %1</translation>
    </message>
    <message>
        <source>at %1, %2, %3 mm</source>
        <translation>bij %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>before the change</source>
        <translation>vóór de wijziging</translation>
    </message>
    <message>
        <source>Not as asked: %1</source>
        <translation>Niet zoals gevraagd: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n plaats</numerusform>
            <numerusform>%n plaatsen</numerusform>
        </translation>
    </message>
    <message>
        <source>Not checked: %1</source>
        <translation>Niet gecontroleerd: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsPanel</name>
    <message>
        <source>Findings</source>
        <translation>Bevindingen</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Bevindingen (%1)</translation>
    </message>
    <message>
        <source>%1 blocking, %2 for information</source>
        <translation>%1 blokkerend, %2 ter informatie</translation>
    </message>
    <message>
        <source>Blocked (%1)</source>
        <translation>Geblokkeerd (%1)</translation>
    </message>
    <message>
        <source>No blocking findings.</source>
        <translation>Geen blokkerende bevindingen.</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Geen problemen gevonden.</translation>
    </message>
    <message>
        <source>No findings yet.</source>
        <translation>Nog geen bevindingen.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Move the camera, the sliders and the robot there</source>
        <translation>Camera, schuifregelaars en robot daarheen bewegen</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Niet gecontroleerd: %1.</translation>
    </message>
    <message>
        <source>No problems found so far.</source>
        <translation>Tot nu toe geen problemen gevonden.</translation>
    </message>
    <message>
        <source>%1 blocking, %2 not as asked, %3 for information</source>
        <translation>%1 blokkerend, %2 niet zoals gevraagd, %3 ter informatie</translation>
    </message>
    <message>
        <source>Not as asked (%1)</source>
        <translation>Niet zoals gevraagd (%1)</translation>
    </message>
    <message>
        <source>Blocked (%1), not as asked (%2)</source>
        <translation>Geblokkeerd (%1), niet zoals gevraagd (%2)</translation>
    </message>
    <message>
        <source>Show only findings that block, or by which the part differs</source>
        <translation>Alleen bevindingen tonen die blokkeren of waardoor het onderdeel afwijkt</translation>
    </message>
    <message>
        <source>What helps: %1</source>
        <translation>Wat helpt: %1</translation>
    </message>
    <message>
        <source>Place %1 of %2</source>
        <translation>Plaats %1 van %2</translation>
    </message>
    <message>
        <source>Show next</source>
        <translation>Volgende tonen</translation>
    </message>
    <message>
        <source>Apply and plan:</source>
        <translation>Toepassen en plannen:</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FormatList</name>
    <message>
        <source>%1, foreign</source>
        <translation>%1, ander merk</translation>
    </message>
    <message>
        <source>For another maker&apos;s controller: where the nozzle goes, not how this robot moves</source>
        <translation>Voor de besturing van een andere fabrikant: waar de nozzle heen gaat, niet hoe deze robot beweegt</translation>
    </message>
    <message>
        <source>Not replayed yet</source>
        <translation>Nog geen controlerun</translation>
    </message>
    <message>
        <source>Passed: the replay found no errors</source>
        <translation>Geslaagd: de controlerun vond geen fouten</translation>
    </message>
    <message>
        <source>Refused by the replay: %1</source>
        <translation>Geweigerd door de controlerun: %1</translation>
    </message>
    <message>
        <source>Not replayed since the change</source>
        <translation>Geen controlerun sinds de wijziging</translation>
    </message>
    <message>
        <source>Not passed, the plan is blocked: %1</source>
        <translation>Niet geslaagd, het plan is geblokkeerd: %1</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>Veilig uit te voeren, niet zoals gevraagd: %1</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>Veilig uit te voeren, behalve je eigen instructies: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FrameForm</name>
    <message>
        <source>Place</source>
        <translation>Positie</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotatie</translation>
    </message>
    <message>
        <source>About the fixed X, then Y, then Z axis</source>
        <translation>Om de vaste X-, dan Y-, dan Z-as</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Randen</translation>
    </message>
    <message>
        <source>Place along %1</source>
        <translation>Plaats langs %1</translation>
    </message>
    <message>
        <source>Turn about %1</source>
        <translation>Draaiing om %1</translation>
    </message>
    <message>
        <source>Edge along %1</source>
        <translation>Rand langs %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::HeadDrawing</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Head, %1 × ⌀ %2 mm</source>
        <translation>Kop, %1 × ⌀ %2 mm</translation>
    </message>
    <message>
        <source>Bead, %1 × %2 mm</source>
        <translation>Streng, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Head, nozzle and bead, to scale</source>
        <translation>Kop, nozzle en streng, op schaal</translation>
    </message>
    <message>
        <source>Left: profile of the head, used for collision checks. Right: its tip with a bead of the usual width and height.</source>
        <translation>Links: profiel van de kop, gebruikt voor de botsingscontrole. Rechts: de punt met een streng van de gebruikelijke breedte en hoogte.</translation>
    </message>
    <message>
        <source>The head&apos;s sections do not rise from the tip.</source>
        <translation>De doorsneden van de kop lopen niet op vanaf de punt.</translation>
    </message>
</context>
<context>
    <name>voluta::panels::HeadTable</name>
    <message>
        <source>Height [mm]</source>
        <translation>Hoogte [mm]</translation>
    </message>
    <message>
        <source>Radius [mm]</source>
        <translation>Straal [mm]</translation>
    </message>
    <message>
        <source>Sections of the head from the tip up. Two rows of the same height are a step.</source>
        <translation>Doorsneden van de kop, vanaf de punt omhoog. Twee rijen met dezelfde hoogte vormen een trap.</translation>
    </message>
    <message>
        <source>Sections of the head</source>
        <translation>Doorsneden van de kop</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Rij toevoegen</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Rij verwijderen</translation>
    </message>
    <message>
        <source>Reset head</source>
        <translation>Kop herstellen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ItemForm</name>
    <message>
        <source>Choose a colour</source>
        <translation>Kies een kleur</translation>
    </message>
</context>
<context>
    <name>voluta::panels::JogPanel</name>
    <message>
        <source>Joints</source>
        <translation>Gewrichten</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Spuitmond</translation>
    </message>
    <message>
        <source>The tip on the platform, and rotations about X, Y and Z (A, B, C) from the upright nozzle</source>
        <translation>De punt op het platform, en rotaties om X, Y en Z (A, B, C) vanaf de verticale spuitmond</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>Step of X, Y and Z</source>
        <translation>Stap van X, Y en Z</translation>
    </message>
    <message>
        <source>Step of A, B and C</source>
        <translation>Stap van A, B en C</translation>
    </message>
    <message>
        <source>Back to the plan</source>
        <translation>Terug naar het plan</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>Gewricht %1</translation>
    </message>
    <message>
        <source>%1 one step less</source>
        <translation>%1 één stap minder</translation>
    </message>
    <message>
        <source>%1 one step more</source>
        <translation>%1 één stap meer</translation>
    </message>
</context>
<context>
    <name>voluta::panels::LayerInfo</name>
    <message>
        <source>Layer</source>
        <translation>Laag</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Deelvlakken</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dikte</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Baanpunten</translation>
    </message>
    <message>
        <source>Minimum, mean and maximum</source>
        <translation>Minimum, gemiddelde en maximum</translation>
    </message>
</context>
<context>
    <name>voluta::panels::MeshPanel</name>
    <message>
        <source>Repair the mesh</source>
        <translation>Mesh repareren</translation>
    </message>
    <message>
        <source>Closes holes, orients triangles and removes duplicates, as far as the shape is not in doubt</source>
        <translation>Sluit gaten, richt driehoeken en verwijdert duplicaten, voor zover de vorm niet twijfelachtig is</translation>
    </message>
    <message>
        <source>No part is open.</source>
        <translation>Geen onderdeel geopend.</translation>
    </message>
    <message>
        <source>The mesh is not watertight.</source>
        <translation>De mesh is niet waterdicht.</translation>
    </message>
    <message>
        <source>The mesh is watertight.</source>
        <translation>De mesh is waterdicht.</translation>
    </message>
    <message>
        <source>The mesh is watertight, but has defects.</source>
        <translation>De mesh is waterdicht, maar heeft gebreken.</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Driehoeken: %1</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gevonden</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Gerepareerd</translation>
    </message>
    <message>
        <source>Remains</source>
        <translation>Resterend</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ObjectTree</name>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Platform</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cel</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Nozzle</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Part and cell</source>
        <translation>Onderdeel en cel</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PaintForm</name>
    <message>
        <source>Paint with</source>
        <translation>Schilderen met</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Kwast</translation>
    </message>
    <message>
        <source>Whole faces</source>
        <translation>Hele vlakken</translation>
    </message>
    <message>
        <source>Up to edges of</source>
        <translation>Tot randen van</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Straal</translation>
    </message>
    <message>
        <source>Paint on the part. Shift or the right button erases.</source>
        <translation>Schilder op het onderdeel. Shift of de rechterknop wist.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechthoek</translation>
    </message>
    <message>
        <source>Drag a rectangle: it paints what you see in it. Shift or the right button erases.</source>
        <translation>Sleep een rechthoek: die beschildert wat je erin ziet. Shift of de rechterknop wist.</translation>
    </message>
    <message>
        <source>Layers while the brush rests</source>
        <translation>Lagen terwijl de kwast rust</translation>
    </message>
    <message>
        <source>One second after a stroke, the layers are made again in the background</source>
        <translation>Eén seconde na een streek worden de lagen op de achtergrond opnieuw gemaakt</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PartList</name>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Size [mm]</source>
        <translation>Maat [mm]</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Toevoegen…</translation>
    </message>
    <message>
        <source>Adds a part from a file beside the others</source>
        <translation>Voegt een onderdeel uit een bestand naast de andere toe</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part with its settings</source>
        <translation>Voegt een kopie van het geselecteerde onderdeel met zijn instellingen toe</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Removes the selected part; can be undone</source>
        <translation>Verwijdert het geselecteerde onderdeel; kan ongedaan worden gemaakt</translation>
    </message>
    <message>
        <source>Print order</source>
        <translation>Printvolgorde</translation>
    </message>
    <message>
        <source>One after another</source>
        <translation>Eén voor één</translation>
    </message>
    <message>
        <source>Layer by layer</source>
        <translation>Laag voor laag</translation>
    </message>
    <message>
        <source>One after another: each part is finished before the next begins. Layer by layer: all parts grow together.</source>
        <translation>Eén voor één: elk onderdeel wordt voltooid voordat het volgende begint. Laag voor laag: alle onderdelen groeien samen.</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Schikken</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>Zet alle onderdelen naast elkaar, met ruimte voor de printkop</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PiecesPanel</name>
    <message>
        <source>Printed as number %1, on piece %2</source>
        <translation>Geprint als nummer %1, op deel %2</translation>
    </message>
    <message>
        <source>Printed as number %1, on the plate</source>
        <translation>Geprint als nummer %1, op de plaat</translation>
    </message>
    <message>
        <source>Needs support: %1, uncut %2</source>
        <translation>Heeft ondersteuning nodig: %1, ongesneden %2</translation>
    </message>
    <message>
        <source>With this cut: %1 need support. Press Plan.</source>
        <translation>Met deze snede: %1 heeft ondersteuning nodig. Druk op Plannen.</translation>
    </message>
    <message>
        <source>With this cut: about %1 need support</source>
        <translation>Met deze snede: ongeveer %1 heeft ondersteuning nodig</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Deel</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Risky</source>
        <translation>Risico</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>In print order; each piece is listed below the one it is printed on</source>
        <translation>In printvolgorde; elk deel staat onder het deel waarop het wordt geprint</translation>
    </message>
    <message>
        <source>Area that needs support when the piece is printed from its base</source>
        <translation>Oppervlak dat ondersteuning nodig heeft als het deel vanaf zijn basis wordt geprint</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Uiteen</translation>
    </message>
    <message>
        <source>Moves each piece away from the one it is printed on</source>
        <translation>Verplaatst elk deel weg van het deel waarop het wordt geprint</translation>
    </message>
    <message>
        <source>Base planes</source>
        <translation>Basisvlakken</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Opnieuw zoeken</translation>
    </message>
    <message>
        <source>Keep these cuts</source>
        <translation>Deze sneden behouden</translation>
    </message>
    <message>
        <source>Discards your cuts and searches for others</source>
        <translation>Gooit je sneden weg en zoekt andere</translation>
    </message>
    <message>
        <source>Keeps these cuts: they become your own and are not searched again</source>
        <translation>Behoudt deze sneden: ze worden je eigen sneden en worden niet opnieuw gezocht</translation>
    </message>
    <message>
        <source>Pick root</source>
        <translation>Wortel kiezen</translation>
    </message>
    <message>
        <source>Then click a point on the piece to print first</source>
        <translation>Klik daarna op een punt van het deel dat eerst wordt geprint</translation>
    </message>
    <message>
        <source>Click a piece to see its base plane and to move that cut.</source>
        <translation>Klik op een deel om zijn basisvlak te zien en die snede te verplaatsen.</translation>
    </message>
    <message>
        <source>Drag the arrow to move the cut, a ring to tilt it. Esc deselects.</source>
        <translation>Sleep de pijl om de snede te verplaatsen, een ring om haar te kantelen. Esc heft de selectie op.</translation>
    </message>
    <message>
        <source>This piece is on the plate: it has no cut to move.</source>
        <translation>Dit deel staat op de plaat: het heeft geen snede om te verplaatsen.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Nummers</translation>
    </message>
    <message>
        <source>In the picture, in print order</source>
        <translation>In het beeld, in printvolgorde</translation>
    </message>
    <message>
        <source>Shows where each piece is cut</source>
        <translation>Toont waar elk deel wordt gesneden</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PlacementPanel</name>
    <message>
        <source>Drop to plate</source>
        <translation>Op plaat zetten</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centreren</translation>
    </message>
    <message>
        <source>Reset placement</source>
        <translation>Plaatsing herstellen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verplaatsen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draaien</translation>
    </message>
    <message>
        <source>About the fixed axes: first X, then Y, then Z</source>
        <translation>Om de vaste assen: eerst X, dan Y, dan Z</translation>
    </message>
    <message>
        <source>Height of the lowest point above the plate</source>
        <translation>Hoogte van het laagste punt boven de plaat</translation>
    </message>
    <message>
        <source>Centre of the part along %1</source>
        <translation>Midden van het onderdeel langs %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verplaatsen</translation>
    </message>
    <message>
        <source>Rotate about the fixed axis %1; X comes first, then Y, then Z</source>
        <translation>Draaien om de vaste as %1; X komt eerst, dan Y, dan Z</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 draaien</translation>
    </message>
    <message>
        <source>Rotate by -90° about %1, from the present orientation</source>
        <translation>-90° draaien om %1, vanuit de huidige oriëntatie</translation>
    </message>
    <message>
        <source>Rotate by 90° about %1, from the present orientation</source>
        <translation>90° draaien om %1, vanuit de huidige oriëntatie</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Schaal</translation>
    </message>
    <message>
        <source>Scale in percent</source>
        <translation>Schaal in procent</translation>
    </message>
    <message>
        <source>Scale as a factor</source>
        <translation>Schaal als factor</translation>
    </message>
    <message>
        <source>Fit to reach</source>
        <translation>Op bereik passen</translation>
    </message>
    <message>
        <source>Scale down, if necessary, to the size that the arm reaches everywhere</source>
        <translation>Zo nodig verkleinen tot de maat die de arm overal bereikt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Maat</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>Op vlak leggen</translation>
    </message>
    <message>
        <source>Then click the face to place on the plate</source>
        <translation>Klik daarna op het vlak dat op de plaat moet komen</translation>
    </message>
    <message>
        <source>Put the centre of the part over the centre of the plate</source>
        <translation>Zet het midden van het onderdeel boven het midden van de plaat</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Position and size as in the file</source>
        <translation>Positie en maat zoals in het bestand</translation>
    </message>
    <message>
        <source>Size along %1. A new size scales the part as a whole.</source>
        <translation>Maat langs %1. Een nieuwe maat schaalt het onderdeel als geheel.</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Maat langs %1</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>Millimeter of inch</translation>
    </message>
    <message>
        <source>Unit of the size</source>
        <translation>Eenheid van de maat</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ProgramFacts</name>
    <message>
        <source>Assumptions about the controller</source>
        <translation>Aannames over de besturing</translation>
    </message>
    <message>
        <source>%1 in one file</source>
        <translation>%1 in één bestand</translation>
    </message>
    <message>
        <source>%1 in %2 files</source>
        <translation>%1 in %2 bestanden</translation>
    </message>
    <message>
        <source>Time on the controller: %1, as planned</source>
        <translation>Tijd op de besturing: %1, zoals gepland</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % more than the planned time of %2</source>
        <translation>Tijd op de besturing: %1, %3 % meer dan de geplande tijd van %2</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % less than the planned time of %2</source>
        <translation>Tijd op de besturing: %1, %3 % minder dan de geplande tijd van %2</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ReachPanel</name>
    <message>
        <source>Calculating…</source>
        <translation>Berekenen…</translation>
    </message>
    <message>
        <source>No part on a plate.</source>
        <translation>Geen onderdeel op een plaat.</translation>
    </message>
    <message>
        <source>The part is off the plate.</source>
        <translation>Het onderdeel ligt niet op de plaat.</translation>
    </message>
    <message>
        <source>Fully reachable upright.</source>
        <translation>Rechtop volledig bereikbaar.</translation>
    </message>
    <message>
        <source>%1 % reachable upright.</source>
        <translation>%1 % rechtop bereikbaar.</translation>
    </message>
    <message>
        <source>With up to %1° of tilt: %2 %.</source>
        <translation>Met maximaal %1° kanteling: %2 %.</translation>
    </message>
    <message>
        <source>There %1 % is reachable upright, %2 % tilted</source>
        <translation>Daar is %1 % rechtop bereikbaar, %2 % gekanteld</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Bereik</translation>
    </message>
    <message>
        <source>Reach of the head over the whole height of the part; collisions with printed material are not checked</source>
        <translation>Bereik van de kop over de hele hoogte van het onderdeel; botsingen met geprint materiaal worden niet gecontroleerd</translation>
    </message>
    <message>
        <source>Show on plate</source>
        <translation>Op plaat tonen</translation>
    </message>
    <message>
        <source>Move to best place</source>
        <translation>Naar beste plaats verplaatsen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::RegionsPanel</name>
    <message>
        <source>Regions</source>
        <translation>Gebieden</translation>
    </message>
    <message>
        <source>Regions of %1</source>
        <translation>Gebieden van %1</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>Gebied hernoemen</translation>
    </message>
    <message>
        <source>Use of a region</source>
        <translation>Gebruik van een gebied</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Gebied wijzigen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 wijzigen</translation>
    </message>
    <message>
        <source>Delete region</source>
        <translation>Gebied verwijderen</translation>
    </message>
    <message>
        <source>Order of regions</source>
        <translation>Volgorde van gebieden</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebied</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Gebruik</translation>
    </message>
    <message>
        <source>Where regions overlap, the lower one in the list holds. Double-click renames.</source>
        <translation>Waar gebieden overlappen, geldt het onderste in de lijst. Dubbelklikken hernoemt.</translation>
    </message>
    <message>
        <source>A region is printed by settings, or in layers, of its own.</source>
        <translation>Een gebied wordt met eigen instellingen of in eigen lagen geprint.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Move down: where regions overlap, the lower one holds</source>
        <translation>Omlaag: waar gebieden overlappen, geldt het onderste</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Omlaag</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Instellingen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Only a skin or a painted surface says which faces the layers follow</source>
        <translation>Alleen een huid of een beschilderd oppervlak geeft aan welke vlakken de lagen volgen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ResumeBar</name>
    <message>
        <source>Resume from here…</source>
        <translation>Vanaf hier hervatten…</translation>
    </message>
    <message>
        <source>Opens the rest of a print that was stopped there as a new project</source>
        <translation>Opent de rest van een daar gestopte print als nieuw project</translation>
    </message>
</context>
<context>
    <name>voluta::panels::VerdictTable</name>
    <message>
        <source>Coverage</source>
        <translation>Dekking</translation>
    </message>
    <message>
        <source>Unsupported</source>
        <translation>Niet ondersteund</translation>
    </message>
    <message>
        <source>Overfill</source>
        <translation>Overvulling</translation>
    </message>
    <message>
        <source>Mass error</source>
        <translation>Massafout</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Botsingen</translation>
    </message>
    <message>
        <source>Limit violations</source>
        <translation>Grensoverschrijdingen</translation>
    </message>
    <message>
        <source>Path deviation</source>
        <translation>Baanafwijking</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Grootheid</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Waarde</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grens</translation>
    </message>
    <message>
        <source>Within limit</source>
        <translation>Binnen de grens</translation>
    </message>
    <message>
        <source>Outside limit</source>
        <translation>Buiten de grens</translation>
    </message>
    <message>
        <source>Not checked since the change</source>
        <translation>Niet gecontroleerd sinds de wijziging</translation>
    </message>
    <message>
        <source>Less than half supported</source>
        <translation>Minder dan de helft ondersteund</translation>
    </message>
    <message>
        <source>Longest unsupported run</source>
        <translation>Langste niet-ondersteunde stuk</translation>
    </message>
    <message>
        <source>Flow error</source>
        <translation>Doorvoerfout</translation>
    </message>
    <message>
        <source>Time on the controller</source>
        <translation>Tijd op de besturing</translation>
    </message>
    <message>
        <source>Differences from the plan</source>
        <translation>Verschillen met het plan</translation>
    </message>
    <message>
        <source>Outside limit, not refused</source>
        <translation>Buiten de grens, niet geweigerd</translation>
    </message>
    <message>
        <source>Thin and open</source>
        <translation>Dun en open</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WayCard</name>
    <message>
        <source>Contact %1 mm²</source>
        <translation>Contact %1 mm²</translation>
    </message>
    <message>
        <source>Missed voxels %1</source>
        <translation>Gemiste voxels %1</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Ongeveer %1</translation>
    </message>
    <message>
        <source>contact %1 mm², overhang %2 mm²
%3 mm high
%4 of %5 voxels missed in one growth pass
about %6, estimated from size, walls and infill without supports</source>
        <translation>contact %1 mm², overhang %2 mm²
%3 mm hoog
%4 van %5 voxels gemist in één groeigang
ongeveer %6, geschat uit maat, wanden en vulling zonder ondersteuning</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WaysList</name>
    <message>
        <source>Calculating…</source>
        <translation>Berekenen…</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>geen gevonden</translation>
    </message>
    <message>
        <source>custom orientation</source>
        <translation>eigen oriëntatie</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>Oriëntaties</translation>
    </message>
    <message>
        <source>Click one to orient the part that way</source>
        <translation>Klik op een oriëntatie om het onderdeel zo te draaien</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WrittenBar</name>
    <message>
        <source>Open report</source>
        <translation>Rapport openen</translation>
    </message>
    <message>
        <source>The report to hand over: verdict, margins and hashes of the program</source>
        <translation>Het rapport om te overhandigen: oordeel, marges en hashes van het programma</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Map tonen</translation>
    </message>
    <message>
        <source>Opens the folder with the programs in the file manager</source>
        <translation>Opent de map met de programma&apos;s in de bestandsbeheerder</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::JointPlots</name>
    <message>
        <source>Angle (°)</source>
        <translation>Hoek (°)</translation>
    </message>
    <message>
        <source>Speed (°/s)</source>
        <translation>Snelheid (°/s)</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tijd (s)</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Snelheid</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Show the limits of the joints as dashed lines</source>
        <translation>De grenzen van de gewrichten als streepjeslijnen tonen</translation>
    </message>
    <message>
        <source>Show joint %1</source>
        <translation>Gewricht %1 tonen</translation>
    </message>
    <message>
        <source>Preparing the curves…</source>
        <translation>Curven worden voorbereid…</translation>
    </message>
    <message>
        <source>Joint curves appear here once the motion is planned.</source>
        <translation>Hier verschijnen gewrichtscurven zodra de beweging is gepland.</translation>
    </message>
    <message>
        <source>No joint selected.</source>
        <translation>Geen gewricht geselecteerd.</translation>
    </message>
    <message>
        <source>Show axis %1</source>
        <translation>As %1 tonen</translation>
    </message>
    <message>
        <source>Angle (°), position (mm)</source>
        <translation>Hoek (°), positie (mm)</translation>
    </message>
    <message>
        <source>Speed (°/s, mm/s)</source>
        <translation>Snelheid (°/s, mm/s)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³)</source>
        <translation>Ruk (rad/s³)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³, mm/s³)</source>
        <translation>Ruk (rad/s³, mm/s³)</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruk</translation>
    </message>
    <message>
        <source>Earlier motion</source>
        <translation>Eerdere beweging</translation>
    </message>
    <message>
        <source>Show the jerk of the motion planned before, in pale colours, to compare</source>
        <translation>De ruk van de eerder geplande beweging ter vergelijking in lichte kleuren tonen</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::LayerRangeSlider</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Shown layers</source>
        <translation>Getoonde lagen</translation>
    </message>
    <message>
        <source>No layers</source>
        <translation>Geen lagen</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3</source>
        <translation>Lagen %1 tot %2 van %3</translation>
    </message>
    <message>
        <source>Layers appear here once they are planned.</source>
        <translation>Hier verschijnen lagen zodra ze zijn gepland.</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3. Up and down keys move the upper end, with Shift the lower one; a double click shows a single layer.</source>
        <translation>Lagen %1 tot %2 van %3. Pijltjes omhoog en omlaag verplaatsen het bovenste einde, met Shift het onderste; dubbelklikken toont één laag.</translation>
    </message>
    <message>
        <source>r %1 mm</source>
        <translation>r %1 mm</translation>
    </message>
    <message>
        <source>, a pause before the last</source>
        <translation>, een pauze vóór de laatste</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>Verwijder de pauze vóór laag %1</translation>
    </message>
    <message>
        <source>Pause before layer %1: the arm goes beside the part and waits, for example to put in an insert</source>
        <translation>Pauze vóór laag %1: de arm gaat naast het onderdeel staan en wacht, bijvoorbeeld om een inzetstuk te plaatsen</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::TimelineBar</name>
    <message>
        <source>Wait: %1 s</source>
        <translation>Wachten: %1 s</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>beweging %1</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Vorige laag</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Vorige beweging</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Afspelen</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Volgende beweging</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Volgende laag</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Afspeelsnelheid</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Moves of the layer</source>
        <translation>Bewegingen van de laag</translation>
    </message>
    <message>
        <source>growth step %1</source>
        <translation>groeistap %1</translation>
    </message>
    <message>
        <source>Ten steps back</source>
        <translation>Tien stappen terug</translation>
    </message>
    <message>
        <source>Previous growth step</source>
        <translation>Vorige groeistap</translation>
    </message>
    <message>
        <source>Next growth step</source>
        <translation>Volgende groeistap</translation>
    </message>
    <message>
        <source>Ten steps forward</source>
        <translation>Tien stappen vooruit</translation>
    </message>
    <message>
        <source>Growth steps</source>
        <translation>Groeistappen</translation>
    </message>
    <message>
        <source>Printing time so far / planned time</source>
        <translation>Verstreken printtijd / geplande tijd</translation>
    </message>
    <message>
        <source>Time-line</source>
        <translation>Tijdlijn</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::MachinesView</name>
    <message>
        <source>View of the machines</source>
        <translation>Weergave van de machines</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::ViewCube</name>
    <message>
        <source>Front</source>
        <translation>Voor</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Achter</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Boven</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Onder</translation>
    </message>
    <message>
        <source>Click a face to look from there, drag to turn the view</source>
        <translation>Klik op een vlak om van daaruit te kijken, sleep om de weergave te draaien</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::Viewport</name>
    <message>
        <source>View</source>
        <translation>Weergave</translation>
    </message>
</context>
<context>
    <name>voluta::window::ArmImportDialog</name>
    <message>
        <source>Six axes with a spherical wrist, solved in closed form</source>
        <translation>Zes assen met sferische pols, in gesloten vorm opgelost</translation>
    </message>
    <message>
        <source>Six axes, 2 to 4 parallel, solved in closed form</source>
        <translation>Zes assen, 2 tot 4 evenwijdig, in gesloten vorm opgelost</translation>
    </message>
    <message>
        <source>Six axes with an offset wrist, solved by a search</source>
        <translation>Zes assen met versprongen pols, opgelost met een zoekmethode</translation>
    </message>
    <message>
        <source>Six axes, solved numerically: plans take longer</source>
        <translation>Zes assen, numeriek opgelost: plannen duurt langer</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Robotarm importeren</translation>
    </message>
    <message>
        <source>Nozzle on the arm, plate on a table</source>
        <translation>Nozzle aan de arm, plaat op een tafel</translation>
    </message>
    <message>
        <source>Plate on the arm, nozzle fixed</source>
        <translation>Plaat aan de arm, nozzle vast</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flens</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cel</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programma&apos;s</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importeren</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lezen…</translation>
    </message>
    <message>
        <source>Assumed:</source>
        <translation>Aangenomen:</translation>
    </message>
    <message>
        <source>An arm named %1 exists.</source>
        <translation>Er bestaat al een arm met de naam %1.</translation>
    </message>
    <message>
        <source>Replacing it loses the frames, obstacles and other changes in these files:</source>
        <translation>Bij vervangen gaan de assenstelsels, obstakels en andere wijzigingen in deze bestanden verloren:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
    </message>
    <message>
        <source>Use another name</source>
        <translation>Andere naam gebruiken</translation>
    </message>
    <message>
        <source>Found in the file</source>
        <translation>Gevonden in het bestand</translation>
    </message>
</context>
<context>
    <name>voluta::window::BodyTree</name>
    <message>
        <source>Robot&apos;s base</source>
        <translation>Voet van de robot</translation>
    </message>
    <message>
        <source>Flange of %1</source>
        <translation>Flens van %1</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Nozzle</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>in the flange</source>
        <translation>in de flens</translation>
    </message>
    <message>
        <source>on the last axis</source>
        <translation>op de laatste as</translation>
    </message>
    <message>
        <source>on the previous axis</source>
        <translation>op de vorige as</translation>
    </message>
    <message>
        <source>in the robot&apos;s base</source>
        <translation>in de robotvoet</translation>
    </message>
    <message>
        <source>Place for purges</source>
        <translation>Spoelplaats</translation>
    </message>
</context>
<context>
    <name>voluta::window::CellEditor</name>
    <message>
        <source>in the flange</source>
        <translation>in de flens</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Cel bewerken</translation>
    </message>
    <message>
        <source>Save as my cell</source>
        <translation>Opslaan als mijn cel</translation>
    </message>
    <message>
        <source>Mass on the flange before printing: the plate and its stem, or head and extruder</source>
        <translation>Massa aan de flens vóór het printen: de plaat met haar steel, of kop en extruder</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Extruder</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>Blok toevoegen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Find home pose</source>
        <translation>Uitgangspose zoeken</translation>
    </message>
    <message>
        <source>Finds the home pose with the greatest clearance, the nozzle over the plate</source>
        <translation>Zoekt de uitgangspose met de grootste vrije afstand, met de nozzle boven de plaat</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>extruder</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>last</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>%1 verplaatsen</translation>
    </message>
    <message>
        <source>edges of %1</source>
        <translation>randen van %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Select a body to move it</source>
        <translation>Selecteer een lichaam om het te verplaatsen</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>controleren…</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Geen problemen.</translation>
    </message>
    <message>
        <source>add a box</source>
        <translation>blok toevoegen</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>home pose</source>
        <translation>uitgangspose</translation>
    </message>
    <message>
        <source>No collision-free home pose over the plate was found.</source>
        <translation>Geen botsingsvrije uitgangspose boven de plaat gevonden.</translation>
    </message>
    <message>
        <source>Replace the cell %1?</source>
        <translation>De cel %1 vervangen?</translation>
    </message>
    <message>
        <source>Add from file…</source>
        <translation>Uit bestand toevoegen…</translation>
    </message>
    <message>
        <source>An obstacle from a drawing: a mesh, approximated by boxes, cylinders and capsules</source>
        <translation>Een obstakel uit een tekening: een mesh, benaderd met blokken, cilinders en capsules</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Meten…</translation>
    </message>
    <message>
        <source>Computes the body&apos;s pose from points touched at the real cell</source>
        <translation>Berekent de pose van het lichaam uit punten die aan de echte cel zijn aangeraakt</translation>
    </message>
    <message>
        <source>Collision solids</source>
        <translation>Botsingslichamen</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wordt gelezen…</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>in the robot&apos;s base, axes at 0</source>
        <translation>in de robotvoet, assen op 0</translation>
    </message>
    <message>
        <source>measure %1</source>
        <translation>%1 meten</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>Toont over de arm heen de lichamen die voor de botsingscontrole worden gebruikt</translation>
    </message>
    <message>
        <source>searching…</source>
        <translation>zoeken…</translation>
    </message>
    <message>
        <source>Discard the changes to this cell?</source>
        <translation>De wijzigingen aan deze cel weggooien?</translation>
    </message>
    <message>
        <source>The last one is: %1.</source>
        <translation>De laatste is: %1.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>Add place for purges</source>
        <translation>Spoelplaats toevoegen</translation>
    </message>
    <message>
        <source>Only a nozzle on the arm goes to a place for purges</source>
        <translation>Alleen een nozzle aan de arm gaat naar een spoelplaats</translation>
    </message>
    <message>
        <source>The cell has a place for purges: select it to move it</source>
        <translation>De cel heeft een spoelplaats: selecteer die om haar te verplaatsen</translation>
    </message>
    <message>
        <source>Where the nozzle&apos;s tip is when tools are changed and nozzles purged, instead of a place that the plan chooses</source>
        <translation>Waar de nozzlepunt zich bevindt bij gereedschapswissels en spoelen, in plaats van op een door het plan gekozen plaats</translation>
    </message>
    <message>
        <source>add the place for purges</source>
        <translation>spoelplaats toevoegen</translation>
    </message>
    <message>
        <source>Bodies of the cell</source>
        <translation>Lichamen van de cel</translation>
    </message>
</context>
<context>
    <name>voluta::window::ChoicesEditor</name>
    <message>
        <source>growth</source>
        <translation>groei</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>platform</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cel</translation>
    </message>
    <message>
        <source>process</source>
        <translation>proces</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>startgetal</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>cel %1</translation>
    </message>
    <message>
        <source>platform %1</source>
        <translation>platform %1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>proces %1</translation>
    </message>
    <message>
        <source>scale %1</source>
        <translation>schaal %1</translation>
    </message>
    <message>
        <source>the part&apos;s orientation unchanged</source>
        <translation>de oriëntatie van het onderdeel ongewijzigd</translation>
    </message>
    <message>
        <source>rod shape</source>
        <translation>staafvorm</translation>
    </message>
    <message>
        <source>way of building</source>
        <translation>bouwwijze</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Kies het bestand…</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 gebruiken</translation>
    </message>
    <message>
        <source>Which body is printed on? If none is chosen, the plate.</source>
        <translation>Op welk lichaam wordt geprint? Zonder keuze: de plaat.</translation>
    </message>
    <message>
        <source>Choose the body…</source>
        <translation>Kies het lichaam…</translation>
    </message>
    <message>
        <source>Changed with it: %1.</source>
        <translation>Mee gewijzigd: %1.</translation>
    </message>
    <message>
        <source>choices that fit the way of building</source>
        <translation>keuzes die bij de bouwwijze passen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>The first way of building and platform without blocking findings.</source>
        <translation>De eerste bouwwijze met platform zonder blokkerende bevindingen.</translation>
    </message>
    <message>
        <source>Rejected: %1.</source>
        <translation>Afgewezen: %1.</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiaal</translation>
    </message>
    <message>
        <source>%1 g/cm³</source>
        <translation>%1 g/cm³</translation>
    </message>
    <message>
        <source>nozzle %1 °C</source>
        <translation>nozzle %1 °C</translation>
    </message>
    <message>
        <source>plate %1 °C</source>
        <translation>plaat %1 °C</translation>
    </message>
    <message>
        <source>fan %1 %</source>
        <translation>ventilator %1 %</translation>
    </message>
    <message>
        <source>up to %1 mm³/s</source>
        <translation>tot %1 mm³/s</translation>
    </message>
    <message>
        <source>tool added</source>
        <translation>gereedschap toegevoegd</translation>
    </message>
    <message>
        <source>tool removed</source>
        <translation>gereedschap verwijderd</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1/kg</source>
        <translation>%1/kg</translation>
    </message>
</context>
<context>
    <name>voluta::window::CommandPalette</name>
    <message>
        <source>Commands and settings</source>
        <translation>Opdrachten en instellingen</translation>
    </message>
    <message>
        <source>Find a command or a setting</source>
        <translation>Opdracht of instelling zoeken</translation>
    </message>
    <message>
        <source>No command and no setting has these words.</source>
        <translation>Geen opdracht en geen instelling heeft deze woorden.</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareItemsDialog</name>
    <message>
        <source>Compare</source>
        <translation>Vergelijken</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Veld</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Geen verschillen.</translation>
    </message>
    <message>
        <source>Differing fields: %1</source>
        <translation>Afwijkende velden: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePage</name>
    <message>
        <source>Nothing can be compared</source>
        <translation>Er kan niets worden vergeleken</translation>
    </message>
    <message>
        <source>Adopted: %1. Press Plan.</source>
        <translation>Overgenomen: %1. Druk op Plannen.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePresetsDialog</name>
    <message>
        <source>Compare presets</source>
        <translation>Presets vergelijken</translation>
    </message>
    <message>
        <source>First preset</source>
        <translation>Eerste preset</translation>
    </message>
    <message>
        <source>Second preset</source>
        <translation>Tweede preset</translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation>Instellingen die verschillen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Instelling</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Geen verschillen.</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>Instellingen die verschillen: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareView</name>
    <message>
        <source>way of building</source>
        <translation>bouwwijze</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Bezig met plannen</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wachtend</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Niet gepland</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Geslaagd</translation>
    </message>
    <message>
        <source>No blocking findings</source>
        <translation>Geen blokkerende bevindingen</translation>
    </message>
    <message>
        <source>Blocked: %1</source>
        <translation>Geblokkeerd: %1</translation>
    </message>
    <message>
        <source>Cannot be planned</source>
        <translation>Kan niet worden gepland</translation>
    </message>
    <message>
        <source>Planned in %1</source>
        <translation>Gepland in %1</translation>
    </message>
    <message>
        <source>Out of date: the part or its settings have changed since.</source>
        <translation>Verouderd: het onderdeel of de instellingen zijn sindsdien gewijzigd.</translation>
    </message>
    <message>
        <source>Best: %1.</source>
        <translation>Beste: %1.</translation>
    </message>
    <message>
        <source>As good: %1.</source>
        <translation>Even goed: %1.</translation>
    </message>
    <message>
        <source>None is best: all of them are blocked.</source>
        <translation>Geen is de beste: alle zijn geblokkeerd.</translation>
    </message>
    <message>
        <source>Which way of building suits this part?
Tick the ways to compare at the right, then press Compare.</source>
        <translation>Welke bouwwijze past bij dit onderdeel?
Vink rechts de te vergelijken bouwwijzen aan en druk op Vergelijken.</translation>
    </message>
    <message>
        <source>Adopt this way</source>
        <translation>Deze bouwwijze overnemen</translation>
    </message>
    <message>
        <source>Builds the part as in the selected row; can be undone</source>
        <translation>Bouwt het onderdeel zoals in de geselecteerde rij; kan ongedaan worden gemaakt</translation>
    </message>
</context>
<context>
    <name>voluta::window::CopiesDialog</name>
    <message>
        <source>Number of copies</source>
        <translation>Aantal kopieën</translation>
    </message>
    <message>
        <source>Number of these parts on the plate; all parts are arranged anew</source>
        <translation>Aantal van deze onderdelen op de plaat; alle onderdelen worden opnieuw geschikt</translation>
    </message>
    <message>
        <source>&amp;Copies on the plate</source>
        <translation>&amp;Kopieën op de plaat</translation>
    </message>
    <message>
        <source>&amp;Fill the plate</source>
        <translation>Plaat &amp;vullen</translation>
    </message>
    <message>
        <source>As many copies as the plate has room for</source>
        <translation>Zoveel kopieën als er op de plaat passen</translation>
    </message>
</context>
<context>
    <name>voluta::window::CutTool</name>
    <message>
        <source>Calculating…</source>
        <translation>Berekenen…</translation>
    </message>
    <message>
        <source>Lower half %1 cm³, upper half %2 cm³.</source>
        <translation>Onderste helft %1 cm³, bovenste helft %2 cm³.</translation>
    </message>
    <message>
        <source>Pins: %1.</source>
        <translation>Pennen: %1.</translation>
    </message>
    <message>
        <source>Cutting…</source>
        <translation>Snijden…</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Snijden</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 snijden</translation>
    </message>
    <message>
        <source>dowel</source>
        <translation>deuvel</translation>
    </message>
    <message>
        <source>Split to parts</source>
        <translation>Splitsen in onderdelen</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 splitsen</translation>
    </message>
    <message>
        <source>The mesh has more than %1 bodies.</source>
        <translation>Het net heeft meer dan %1 lichamen.</translation>
    </message>
    <message>
        <source>The part is one body.</source>
        <translation>Het onderdeel is één lichaam.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n onderdeel</numerusform>
            <numerusform>%n onderdelen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Their regions have moved with them.</source>
        <translation>%1. Hun gebieden zijn mee verplaatst.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ExportPage</name>
    <message>
        <source>Open a part first.</source>
        <translation>Open eerst een onderdeel.</translation>
    </message>
    <message>
        <source>Planning is in progress.</source>
        <translation>Er wordt gepland.</translation>
    </message>
    <message>
        <source>Nothing has been planned yet. Press Plan.</source>
        <translation>Er is nog niets gepland. Druk op Plannen.</translation>
    </message>
    <message>
        <source>Programs are not saved in a project. Press Plan to generate them.</source>
        <translation>Programma&apos;s worden niet in een project opgeslagen. Druk op Plannen om ze te genereren.</translation>
    </message>
    <message>
        <source>The programs are out of date. Press Plan.</source>
        <translation>De programma&apos;s zijn verouderd. Druk op Plannen.</translation>
    </message>
    <message>
        <source>program formats</source>
        <translation>programmaformaten</translation>
    </message>
    <message>
        <source>Files written to %1: %2</source>
        <translation>Bestanden geschreven naar %1: %2</translation>
    </message>
    <message>
        <source>; refused and not written: %1</source>
        <translation>; geweigerd en niet geschreven: %1</translation>
    </message>
    <message>
        <source>; the reports have no pictures: %1</source>
        <translation>; de rapporten hebben geen afbeeldingen: %1</translation>
    </message>
    <message>
        <source>The files are being written.</source>
        <translation>De bestanden worden geschreven.</translation>
    </message>
    <message>
        <source>Nothing was exported</source>
        <translation>Er is niets geëxporteerd</translation>
    </message>
    <message>
        <source>The replay refused all programs: %1.</source>
        <translation>De controlerun heeft alle programma&apos;s geweigerd: %1.</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>Bestanden vervangen?</translation>
    </message>
    <message>
        <source>These files already exist in %1:</source>
        <translation>Deze bestanden bestaan al in %1:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
    </message>
    <message>
        <source>This is the rest of a print made with other settings. Undo the change: Plan would plan the whole part again.</source>
        <translation>Dit is de rest van een print die met andere instellingen is gemaakt. Maak de wijziging ongedaan: Plannen zou het hele onderdeel opnieuw plannen.</translation>
    </message>
    <message>
        <source>Slower on the controller by %1 s</source>
        <translation>%1 s trager op de besturing</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>Regel %1, %2</translation>
    </message>
    <message>
        <source>Verify a program</source>
        <translation>Programma verifiëren</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Cannot open %1</source>
        <translation>Kan %1 niet openen</translation>
    </message>
    <message>
        <source>No program on this computer is set up to open it.</source>
        <translation>Op deze computer is geen programma ingesteld om het te openen.</translation>
    </message>
</context>
<context>
    <name>voluta::window::FilmDialog</name>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length of the film. The whole print is shown in it, with equal steps</source>
        <translation>Lengte van de film. De hele print is erin te zien, met gelijke stappen</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Voor</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Boven</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Lengte</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Afmetingen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Weergave</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Opslaan…</translation>
    </message>
    <message>
        <source>Save the film</source>
        <translation>De film opslaan</translation>
    </message>
    <message>
        <source>Films (*.webm)</source>
        <translation>Films (*.webm)</translation>
    </message>
</context>
<context>
    <name>voluta::window::FlowBar</name>
    <message>
        <source>nothing yet</source>
        <translation>nog niets</translation>
    </message>
    <message>
        <source>running</source>
        <translation>bezig</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klaar</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>verouderd</translation>
    </message>
    <message>
        <source>blocked: see the findings</source>
        <translation>geblokkeerd: zie de bevindingen</translation>
    </message>
    <message>
        <source>not as asked or not checked: see the findings</source>
        <translation>niet zoals gevraagd of niet gecontroleerd: zie de bevindingen</translation>
    </message>
</context>
<context>
    <name>voluta::window::HeadNumbersDialog</name>
    <message>
        <source>Head from a few numbers</source>
        <translation>Kop uit enkele getallen</translation>
    </message>
    <message>
        <source>The head contains the corners of the square block.</source>
        <translation>De kop omvat de hoeken van het vierkante blok.</translation>
    </message>
    <message>
        <source>Use this head</source>
        <translation>Deze kop gebruiken</translation>
    </message>
</context>
<context>
    <name>voluta::window::Jogging</name>
    <message>
        <source>Collision: %1 and %2</source>
        <translation>Botsing: %1 en %2</translation>
    </message>
    <message>
        <source>Free: more than %1 mm between bodies</source>
        <translation>Vrij: meer dan %1 mm tussen lichamen</translation>
    </message>
    <message>
        <source>Free: %1 mm between the nearest bodies</source>
        <translation>Vrij: %1 mm tussen de dichtstbijzijnde lichamen</translation>
    </message>
    <message>
        <source>The arm does not reach that pose within its joint limits. It stays here.</source>
        <translation>De arm bereikt die pose niet binnen zijn gewrichtslimieten. Hij blijft hier.</translation>
    </message>
    <message>
        <source>The printed part is not checked yet.</source>
        <translation>Het geprinte onderdeel is nog niet gecontroleerd.</translation>
    </message>
    <message>
        <source>Checking the pose…</source>
        <translation>Pose controleren…</translation>
    </message>
</context>
<context>
    <name>voluta::window::JoinedMachines</name>
    <message>
        <source>Machine %1</source>
        <translation>Machine %1</translation>
    </message>
    <message>
        <source>Waits %1 for machine %2</source>
        <translation>Wacht %1 op machine %2</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayerEventDialog</name>
    <message>
        <source>Event before layer %1</source>
        <translation>Gebeurtenis vóór laag %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Wachten</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Uitgang</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Gereedschap</translation>
    </message>
    <message>
        <source>Own statement</source>
        <translation>Eigen instructie</translation>
    </message>
    <message>
        <source>Shown to the operator; the arm waits until the operator continues</source>
        <translation>Wordt aan de operator getoond; de arm wacht tot de operator verdergaat</translation>
    </message>
    <message>
        <source>This line is written into programs of the format. Nothing checks it</source>
        <translation>Deze regel wordt in programma&apos;s van het formaat geschreven. Niets controleert hem</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Aan</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>&amp;Gebeurtenis</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>&amp;Tekst</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Duur</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>&amp;Nummer</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>Gereed&amp;schap</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formaat</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>&amp;Regel</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>The camera&apos;s output is on for this long; the arm waits beside the part</source>
        <translation>De uitgang van de camera is zo lang aan; de arm wacht naast het onderdeel</translation>
    </message>
    <message>
        <source>Change of filament</source>
        <translation>Filamentwissel</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayersPage</name>
    <message>
        <source>Replaying growth: all layers shown</source>
        <translation>Groei wordt afgespeeld: alle lagen zichtbaar</translation>
    </message>
    <message>
        <source>Pieces are always shown whole</source>
        <translation>Delen worden altijd volledig getoond</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>Gebeurtenis vóór deze laag…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>Een pauze, een wachttijd, een uitgang, een ander gereedschap of een eigen regel</translation>
    </message>
</context>
<context>
    <name>voluta::window::LegendView</name>
    <message>
        <source>Click to show these beads</source>
        <translation>Klik om deze strengen te tonen</translation>
    </message>
    <message>
        <source>Click to hide these beads</source>
        <translation>Klik om deze strengen te verbergen</translation>
    </message>
</context>
<context>
    <name>voluta::window::LibraryDialog</name>
    <message>
        <source>Processes and materials</source>
        <translation>Processen en materialen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Wijzigingen weggooien</translation>
    </message>
    <message>
        <source>Use in this job</source>
        <translation>In deze opdracht gebruiken</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergelijken…</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Processen</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliceren</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Naam wijzigen…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Verwijderen…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporteren…</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importeren…</translation>
    </message>
    <message>
        <source>From a few numbers…</source>
        <translation>Uit enkele getallen…</translation>
    </message>
    <message>
        <source>From a mesh…</source>
        <translation>Uit een mesh…</translation>
    </message>
    <message>
        <source>A drawing of the head with its nozzle pointing down: the largest radius at each height</source>
        <translation>Een tekening van de kop met de nozzle omlaag: de grootste straal op elke hoogte</translation>
    </message>
    <message>
        <source>%1 (in this job)</source>
        <translation>%1 (in deze opdracht)</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Meegeleverd met het programma</translation>
    </message>
    <message>
        <source>Stored in this job</source>
        <translation>Opgeslagen in deze opdracht</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Eigen</translation>
    </message>
    <message>
        <source>Comes with the program. Duplicate it to change it.</source>
        <translation>Meegeleverd met het programma. Dupliceer het om het te wijzigen.</translation>
    </message>
    <message>
        <source>Stored in this job, not in your library. Duplicate it to keep it.</source>
        <translation>Opgeslagen in deze opdracht, niet in je bibliotheek. Dupliceer het om het te bewaren.</translation>
    </message>
    <message>
        <source>Your own.</source>
        <translation>Eigen.</translation>
    </message>
    <message>
        <source>Your own, based on %1; fields that differ are marked.</source>
        <translation>Eigen, gebaseerd op %1; afwijkende velden zijn gemarkeerd.</translation>
    </message>
    <message>
        <source>Cannot be saved: %1 %2</source>
        <translation>Kan niet worden opgeslagen: %1 %2</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kop</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Nog niet opgeslagen.</translation>
    </message>
    <message>
        <source>Save and use in this job</source>
        <translation>Opslaan en in deze opdracht gebruiken</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Naam wijzigen</translation>
    </message>
    <message>
        <source>Small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;:</source>
        <translation>Kleine letters, cijfers, &apos;-&apos;, &apos;_&apos; en &apos;.&apos;:</translation>
    </message>
    <message>
        <source>There is another &apos;%1&apos;.</source>
        <translation>Er is al een andere &apos;%1&apos;.</translation>
    </message>
    <message>
        <source>Delete %1 and its file?</source>
        <translation>%1 en het bestand ervan verwijderen?</translation>
    </message>
    <message>
        <source>Import a process</source>
        <translation>Proces importeren</translation>
    </message>
    <message>
        <source>Import a material</source>
        <translation>Materiaal importeren</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON-bestanden (*.json);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Replace your own %1?</source>
        <translation>Je eigen %1 vervangen?</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exporteren</translation>
    </message>
    <message>
        <source>JSON files (*.json)</source>
        <translation>JSON-bestanden (*.json)</translation>
    </message>
    <message>
        <source>Head from a mesh</source>
        <translation>Kop uit een mesh</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>De wijzigingen opslaan?</translation>
    </message>
    <message>
        <source>The job uses another version of this process.</source>
        <translation>De opdracht gebruikt een andere versie van dit proces.</translation>
    </message>
    <message>
        <source>Sizes from a measured plate…</source>
        <translation>Maten van een gemeten plaat…</translation>
    </message>
    <message>
        <source>Corrects the sizes of flat layers by those of a printed accuracy plate</source>
        <translation>Corrigeert de maten van vlakke lagen met die van een geprinte nauwkeurigheidsplaat</translation>
    </message>
    <message>
        <source>Does the nozzle point up in the drawing?</source>
        <translation>Wijst de nozzle in de tekening omhoog?</translation>
    </message>
    <message>
        <source>Turn it over</source>
        <translation>Omkeren</translation>
    </message>
    <message>
        <source>Use it as drawn</source>
        <translation>Gebruiken zoals getekend</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Meshes (%1);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Your own. It follows %1 in all fields that are not marked.</source>
        <translation>Eigen. Volgt %1 in alle velden die niet zijn gemarkeerd.</translation>
    </message>
</context>
<context>
    <name>voluta::window::LogDialog</name>
    <message>
        <source>Log</source>
        <translation>Logboek</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kan niet worden gelezen: %2.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Map openen</translation>
    </message>
    <message>
        <source>No program on this computer opens the folder %1.</source>
        <translation>Geen programma op deze computer opent de map %1.</translation>
    </message>
</context>
<context>
    <name>voluta::window::MachineTable</name>
    <message>
        <source>Job</source>
        <translation>Opdracht</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cel</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotatie</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Machines</translation>
    </message>
</context>
<context>
    <name>voluta::window::MainWindow</name>
    <message>
        <source>Part and cell</source>
        <translation>Onderdeel en cel</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Bevindingen</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Afbeelding opslaan</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kan niet worden geschreven. Kies een andere map.</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Staaf</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 onderdelen</translation>
    </message>
    <message>
        <source>Saved the film %1</source>
        <translation>De film %1 is opgeslagen</translation>
    </message>
</context>
<context>
    <name>voluta::window::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handleiding</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Zoek in de handleiding</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhoud</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Pagina van de handleiding</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Terug</translation>
    </message>
</context>
<context>
    <name>voluta::window::MeasureDialog</name>
    <message>
        <source>One point per row, in mm, %1. Three rows x, y, z: origin, a point on X, a point in the XY plane. Or at least three rows of six: nominal point, touched point.</source>
        <translation>Eén punt per rij, in mm, %1. Drie rijen x, y, z: oorsprong, een punt op X, een punt in het XY-vlak. Of ten minste drie rijen van zes: nominaal punt, aangeraakt punt.</translation>
    </message>
    <message>
        <source>At least four poses in which the tip touches the same point, tilted to different sides, one per row: the robot&apos;s joints, or x, y, z, qw, qx, qy, qz of the flange.</source>
        <translation>Ten minste vier poses waarin de punt hetzelfde punt raakt, naar verschillende kanten gekanteld, één per rij: de gewrichten van de robot, of x, y, z, qw, qx, qy, qz van de flens.</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>%1 meten</translation>
    </message>
    <message>
        <source>Use this frame</source>
        <translation>Dit assenstelsel gebruiken</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rijen</translation>
    </message>
</context>
<context>
    <name>voluta::window::MeasureTool</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Round edge: radius %1, diameter %2</source>
        <translation>Ronde rand: straal %1, diameter %2</translation>
    </message>
    <message>
        <source>Round face: radius %1, diameter %2</source>
        <translation>Rond vlak: straal %1, diameter %2</translation>
    </message>
    <message>
        <source>Ball: radius %1, diameter %2</source>
        <translation>Bol: straal %1, diameter %2</translation>
    </message>
    <message>
        <source>Corner: X %1, Y %2, Z %3</source>
        <translation>Hoek: X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Vlak</translation>
    </message>
    <message>
        <source>Wall behind the face: %1</source>
        <translation>Wand achter het vlak: %1</translation>
    </message>
    <message>
        <source>Distance: %1</source>
        <translation>Afstand: %1</translation>
    </message>
    <message>
        <source>X %1, Y %2, Z %3</source>
        <translation>X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Distance of the parallel faces: %1</source>
        <translation>Afstand van de evenwijdige vlakken: %1</translation>
    </message>
    <message>
        <source>Angle: %1°</source>
        <translation>Hoek: %1°</translation>
    </message>
    <message>
        <source>Click a corner, an edge or a face of the part.</source>
        <translation>Klik op een hoek, een rand of een vlak van het onderdeel.</translation>
    </message>
    <message>
        <source>Click a second place for distance and angle.</source>
        <translation>Klik op een tweede plaats voor afstand en hoek.</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillDialog</name>
    <message>
        <source>Mill %1 from a block</source>
        <translation>%1 uit een blok frezen</translation>
    </message>
    <message>
        <source>Save G-code…</source>
        <translation>G-code opslaan…</translation>
    </message>
    <message>
        <source>Compute passes</source>
        <translation>Freesgangen berekenen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>Milled block</source>
        <translation>Gefreesd blok</translation>
    </message>
    <message>
        <source>Computing the passes and running them on the block…</source>
        <translation>De freesgangen worden berekend en op het blok uitgevoerd…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Geannuleerd.</translation>
    </message>
    <message>
        <source>Values have changed: compute the passes again.</source>
        <translation>Waarden zijn gewijzigd: bereken de freesgangen opnieuw.</translation>
    </message>
    <message>
        <source>Passed: the program was read back and run on the block.</source>
        <translation>Geslaagd: het programma is teruggelezen en op het blok uitgevoerd.</translation>
    </message>
    <message>
        <source>Refused: %1 (%2)</source>
        <translation>Geweigerd: %1 (%2)</translation>
    </message>
    <message>
        <source>Block %1 × %2 × %3 mm</source>
        <translation>Blok %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Time %1, %2 moves</source>
        <translation>Tijd %1, %2 bewegingen</translation>
    </message>
    <message>
        <source>Removed %1 of %2 cm³</source>
        <translation>%1 van %2 cm³ verspaand</translation>
    </message>
    <message>
        <source>Left on the part: at most %1 mm</source>
        <translation>Resterend op het onderdeel: maximaal %1 mm</translation>
    </message>
    <message>
        <source>Missing from the part: at most %1 mm</source>
        <translation>Ontbrekend aan het onderdeel: maximaal %1 mm</translation>
    </message>
    <message>
        <source>Save the G-code</source>
        <translation>G-code opslaan</translation>
    </message>
    <message>
        <source>G-code (*.nc)</source>
        <translation>G-code (*.nc)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 opgeslagen</translation>
    </message>
    <message>
        <source>Not complete: %1 (%2)</source>
        <translation>Niet volledig: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillForm</name>
    <message>
        <source>Material</source>
        <translation>Materiaal</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Tanden</translation>
    </message>
    <message>
        <source>Lay the part down</source>
        <translation>Onderdeel neerleggen</translation>
    </message>
    <message>
        <source>Turns the part so that the least material is milled away; otherwise it keeps its orientation on the plate</source>
        <translation>Draait het onderdeel zodat er zo min mogelijk materiaal wordt weggefreesd; anders behoudt het zijn oriëntatie op de plaat</translation>
    </message>
    <message>
        <source>%1 rpm, feed %2 mm/min, lines every %3 mm, fine passes of %4 mm</source>
        <translation>%1 tpm, voeding %2 mm/min, lijnen om de %3 mm, fijne gangen van %4 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObjectMenus</name>
    <message>
        <source>Show its place</source>
        <translation>Plaats tonen</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Tekst kopiëren</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Alleen dit tonen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Instellingen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporteren…</translation>
    </message>
    <message>
        <source>Select this part</source>
        <translation>Dit onderdeel kiezen</translation>
    </message>
    <message>
        <source>Show all beads</source>
        <translation>Alle strengen tonen</translation>
    </message>
    <message>
        <source>Show only layer %1</source>
        <translation>Alleen laag %1 tonen</translation>
    </message>
    <message>
        <source>Show up to layer %1</source>
        <translation>Tot en met laag %1 tonen</translation>
    </message>
    <message>
        <source>Show all layers</source>
        <translation>Alle lagen tonen</translation>
    </message>
    <message>
        <source>Go to this moment</source>
        <translation>Naar dit moment gaan</translation>
    </message>
    <message>
        <source>Hide beads of this kind</source>
        <translation>Strengen van deze soort verbergen</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Eenheid van het bestand</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>inch</translation>
    </message>
    <message>
        <source>unit of the file</source>
        <translation>eenheid van het bestand</translation>
    </message>
    <message>
        <source>Repair the mesh</source>
        <translation>Het net repareren</translation>
    </message>
    <message>
        <source>repair the mesh</source>
        <translation>het net repareren</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>net zoals gelezen</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObstacleImport</name>
    <message>
        <source>Obstacle from a file</source>
        <translation>Obstakel uit een bestand</translation>
    </message>
    <message>
        <source>%1 is %2 mm long. Was it drawn in metres?</source>
        <translation>%1 is %2 mm lang. Is het in meters getekend?</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Meshes (%1);;Alle bestanden (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::PageStack</name>
    <message>
        <source>Preview</source>
        <translation>Voorbeeld</translation>
    </message>
    <message>
        <source>Layers, paths and programs are not up to date yet: press Plan.</source>
        <translation>Lagen, banen en programma&apos;s zijn nog niet bijgewerkt: druk op Plannen.</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Verouderd</translation>
    </message>
    <message>
        <source>The settings have changed since: press Plan.</source>
        <translation>De instellingen zijn sindsdien gewijzigd: druk op Plannen.</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Laag %1</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totaal</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartHandles</name>
    <message>
        <source>drop to plate</source>
        <translation>op plaat zetten</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centreren</translation>
    </message>
    <message>
        <source>lay on face</source>
        <translation>op vlak leggen</translation>
    </message>
    <message>
        <source>place on touched points</source>
        <translation>op aangeraakte punten plaatsen</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verplaatsen</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>draaien</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartsView</name>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>Onderdelen schikken</translation>
    </message>
    <message>
        <source>Arranging the copies…</source>
        <translation>Kopieën worden geschikt…</translation>
    </message>
    <message>
        <source>Number of copies</source>
        <translation>Aantal kopieën</translation>
    </message>
    <message numerus="yes">
        <source>%n copies on the plate</source>
        <translation>
            <numerusform>%n kopie op de plaat</numerusform>
            <numerusform>%n kopieën op de plaat</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>voluta::window::PictureArea</name>
    <message>
        <source>The viewport needs OpenGL 3.2; this display offers %1. Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export work without a picture.</source>
        <translation>De weergave vereist OpenGL 3.2; dit beeldscherm biedt %1. Werk het grafische stuurprogramma bij of stel LIBGL_ALWAYS_SOFTWARE=1 in. Plannen en exporteren werken ook zonder beeld.</translation>
    </message>
</context>
<context>
    <name>voluta::window::PieceCuts</name>
    <message>
        <source>keep cuts</source>
        <translation>sneden behouden</translation>
    </message>
    <message>
        <source>search for cuts</source>
        <translation>sneden zoeken</translation>
    </message>
    <message>
        <source>move cut</source>
        <translation>snede verplaatsen</translation>
    </message>
    <message>
        <source>pick root</source>
        <translation>wortel kiezen</translation>
    </message>
</context>
<context>
    <name>voluta::window::PreparePage</name>
    <message>
        <source>repair the mesh</source>
        <translation>mesh repareren</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>mesh zoals gelezen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Instellingen</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Onderdeel</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cel</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Cel bewerken</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetBar</name>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (gewijzigd)</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Save, compare, export or import presets</source>
        <translation>Presets opslaan, vergelijken, exporteren of importeren</translation>
    </message>
    <message>
        <source>Preset menu</source>
        <translation>Presetmenu</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetEditor</name>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON-bestanden (*.json);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>In dit project</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Bij het programma</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Je eigen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Presets</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1: %2 in plaats van %3</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>en nog %n</numerusform>
            <numerusform>en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Change preset</source>
        <translation>Preset wijzigen</translation>
    </message>
    <message>
        <source>Settings of the preset were changed. Take the changes to %1?</source>
        <translation>Instellingen van de preset zijn gewijzigd. De wijzigingen meenemen naar %1?</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>&amp;Meenemen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerpen</translation>
    </message>
    <message>
        <source>&amp;Keep this preset</source>
        <translation>Deze preset &amp;houden</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Preset %1</translation>
    </message>
    <message>
        <source>Save preset %1</source>
        <translation>Preset %1 opslaan</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1, eigen</translation>
    </message>
    <message>
        <source>Save preset as</source>
        <translation>Preset opslaan als</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Preset hernoemen</translation>
    </message>
    <message>
        <source>Rename preset %1</source>
        <translation>Preset %1 hernoemen</translation>
    </message>
    <message>
        <source>Delete preset</source>
        <translation>Preset verwijderen</translation>
    </message>
    <message>
        <source>Delete the preset %1? The settings of this project stay.</source>
        <translation>De preset %1 verwijderen? De instellingen van dit project blijven.</translation>
    </message>
    <message>
        <source>Delete preset %1</source>
        <translation>Preset %1 verwijderen</translation>
    </message>
    <message>
        <source>Discard changes of the preset</source>
        <translation>Wijzigingen van de preset verwerpen</translation>
    </message>
    <message>
        <source>Present settings</source>
        <translation>Huidige instellingen</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exporteren</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Een preset importeren</translation>
    </message>
    <message>
        <source>Replace your own preset %1?</source>
        <translation>Je eigen preset %1 vervangen?</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetNameDialog</name>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
</context>
<context>
    <name>voluta::window::ProjectFiles</name>
    <message>
        <source>settings of the sample</source>
        <translation>instellingen van het voorbeeld</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wordt geopend</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Gereed. Druk op Plannen.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Geannuleerd.</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 kan niet worden geopend</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 opgeslagen</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 is niet opgeslagen</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Onlangs geopend</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geopend</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Project opslaan</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Voluta-projecten (*.voluta)</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Niet-opgeslagen werk herstellen</translation>
    </message>
    <message>
        <source>Voluta ended unexpectedly. A copy of “%1” was saved on %2.</source>
        <translation>Voluta is onverwacht afgesloten. Een kopie van “%1” is opgeslagen op %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Later</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Niet-opgeslagen wijzigingen</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>“%1” heeft niet-opgeslagen wijzigingen.</translation>
    </message>
    <message>
        <source>Resume from here?</source>
        <translation>Vanaf hier hervatten?</translation>
    </message>
    <message>
        <source>%1 % of the material counts as printed. The rest of “%2” opens as a new project.</source>
        <translation>%1 % van het materiaal geldt als geprint. De rest van “%2” wordt als nieuw project geopend.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Hervatten</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Robotarm importeren</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf *.xml);;All files (*)</source>
        <translation>Robotbeschrijvingen (*.urdf *.xml);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>No folder for your own robots: set HOME.</source>
        <translation>Geen map voor je eigen robots: stel HOME in.</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cel</translation>
    </message>
    <message>
        <source>Imported: cell %1</source>
        <translation>Geïmporteerd: cel %1</translation>
    </message>
    <message>
        <source>Add part</source>
        <translation>Onderdeel toevoegen</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>Onderdelen (%1);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>One part?</source>
        <translation>Eén onderdeel?</translation>
    </message>
    <message>
        <source>“%1” and “%2” in “%3” touch. Open the file as one part?</source>
        <translation>“%1” en “%2” in “%3” raken elkaar. Het bestand als één onderdeel openen?</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>Eén onderdeel</translation>
    </message>
    <message>
        <source>Several parts</source>
        <translation>Meerdere onderdelen</translation>
    </message>
    <message>
        <source>Add or replace?</source>
        <translation>Toevoegen of vervangen?</translation>
    </message>
    <message>
        <source>Add “%1” beside “%2”, or open it instead?</source>
        <translation>“%1” naast “%2” toevoegen, of in plaats daarvan openen?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
    </message>
    <message>
        <source>Parts and projects (%1);;All files (*)</source>
        <translation>Onderdelen en projecten (%1);;Alle bestanden (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::QuoteDialog</name>
    <message>
        <source>Quote</source>
        <translation>Offerte</translation>
    </message>
    <message>
        <source>Price of each print, whatever its size</source>
        <translation>Prijs van elke print, ongeacht de grootte</translation>
    </message>
    <message>
        <source>Added to the cost</source>
        <translation>Komt bij de kosten</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Post</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Bedrag</translation>
    </message>
    <message>
        <source>Machine, per hour</source>
        <translation>Machine, per uur</translation>
    </message>
    <message>
        <source>Set-up, per print</source>
        <translation>Instellen, per print</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Save page…</source>
        <translation>Pagina opslaan…</translation>
    </message>
    <message>
        <source>A page for the customer, as PDF or HTML</source>
        <translation>Een pagina voor de klant, als PDF of HTML</translation>
    </message>
    <message>
        <source>%1 g at %2 per kg</source>
        <translation>%1 g à %2 per kg</translation>
    </message>
    <message>
        <source>%1 g; its price is not known</source>
        <translation>%1 g; de prijs is niet bekend</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Instellen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Plan the part first.</source>
        <translation>Plan eerst het onderdeel.</translation>
    </message>
    <message>
        <source>Enter the price of the material under Processes and materials.</source>
        <translation>Vul de prijs van het materiaal in bij Processen en materialen.</translation>
    </message>
    <message>
        <source>Save page</source>
        <translation>Pagina opslaan</translation>
    </message>
    <message>
        <source>%1 quote</source>
        <translation>%1 offerte</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;HTML (*.html)</source>
        <translation>PDF (*.pdf);;HTML (*.html)</translation>
    </message>
    <message>
        <source>Drawing the part…</source>
        <translation>Onderdeel tekenen…</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Opgeslagen als %1.</translation>
    </message>
    <message>
        <source>Price of an hour of the machine, with power and operator; each cell has its own</source>
        <translation>Prijs van een machine-uur, met stroom en bediening; elke cel heeft een eigen prijs</translation>
    </message>
</context>
<context>
    <name>voluta::window::ReachView</name>
    <message>
        <source>move to best place</source>
        <translation>naar beste plaats verplaatsen</translation>
    </message>
</context>
<context>
    <name>voluta::window::RegionsTool</name>
    <message>
        <source>Move region</source>
        <translation>Gebied verplaatsen</translation>
    </message>
    <message>
        <source>Paint region</source>
        <translation>Gebied schilderen</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Gebied toevoegen</translation>
    </message>
    <message>
        <source>Body of a region</source>
        <translation>Lichaam van een gebied</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Meshes (%1);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 lezen…</translation>
    </message>
    <message>
        <source>Nothing is painted yet: the region has no effect.</source>
        <translation>Er is nog niets geschilderd: het gebied heeft geen effect.</translation>
    </message>
</context>
<context>
    <name>voluta::window::RemedyEffect</name>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Not covered</source>
        <translation>Niet bedekt</translation>
    </message>
    <message>
        <source>Printed in the air</source>
        <translation>In de lucht geprint</translation>
    </message>
    <message>
        <source>Overfilled</source>
        <translation>Overvuld</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Applied: %1</source>
        <translation>Toegepast: %1</translation>
    </message>
    <message>
        <source>It cannot be planned this way. Undo it, or try another remedy.</source>
        <translation>Zo kan het niet worden gepland. Maak het ongedaan, of probeer een andere remedie.</translation>
    </message>
    <message>
        <source>The figures follow when the plan is done.</source>
        <translation>De cijfers volgen als het plan klaar is.</translation>
    </message>
    <message>
        <source>Plan to see its effect.</source>
        <translation>Plan om het effect te zien.</translation>
    </message>
    <message>
        <source>No longer found</source>
        <translation>Niet meer gevonden</translation>
    </message>
    <message>
        <source>Unchanged: %1</source>
        <translation>Ongewijzigd: %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Ervoor: %1</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Erna: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::RunDialog</name>
    <message>
        <source>Path %1 mm over %2 mm</source>
        <translation>Baan %1 mm over %2 mm</translation>
    </message>
    <message>
        <source>Speed %1 % over %2 mm</source>
        <translation>Snelheid %1 % over %2 mm</translation>
    </message>
    <message>
        <source>Flow %1 % over %2 mm</source>
        <translation>Doorvoer %1 % over %2 mm</translation>
    </message>
    <message>
        <source>%1 mm of beads are missing</source>
        <translation>%1 mm streng ontbreekt</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>Slechtste plaatsen</translation>
    </message>
    <message>
        <source>Recorded run %1</source>
        <translation>Opgenomen run %1</translation>
    </message>
    <message>
        <source>Comparing the record with the current plan…</source>
        <translation>Opname wordt met het huidige plan vergeleken…</translation>
    </message>
    <message>
        <source>Flow, recorded: mean %1 %, from %2 to %3 %</source>
        <translation>Doorvoer, opgenomen: gemiddeld %1 %, van %2 tot %3 %</translation>
    </message>
    <message>
        <source>Flow at this speed: mean %1 %, from %2 to %3 %</source>
        <translation>Doorvoer bij deze snelheid: gemiddeld %1 %, van %2 tot %3 %</translation>
    </message>
    <message>
        <source>Path: mean %1 mm, greatest %2 mm</source>
        <translation>Baan: gemiddeld %1 mm, grootste %2 mm</translation>
    </message>
    <message>
        <source>Speed: mean %1 %, from %2 to %3 %</source>
        <translation>Snelheid: gemiddeld %1 %, van %2 tot %3 %</translation>
    </message>
    <message>
        <source>Beads recorded: %1 of %2 mm</source>
        <translation>Opgenomen strengen: %1 van %2 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::Runs</name>
    <message>
        <source>1 voxel, %1 missed</source>
        <translation>1 voxel, %1 gemist</translation>
    </message>
    <message>
        <source>%1 voxels, %2 missed</source>
        <translation>%1 voxels, %2 gemist</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 lagen</translation>
    </message>
    <message>
        <source>1 waypoint</source>
        <translation>1 baanpunt</translation>
    </message>
    <message>
        <source>%1 waypoints</source>
        <translation>%1 baanpunten</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>replay passed</source>
        <translation>controlerun geslaagd</translation>
    </message>
    <message>
        <source>replay not passed</source>
        <translation>controlerun niet geslaagd</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Gereed. Druk op Plannen.</translation>
    </message>
    <message>
        <source>Done. Blocking findings: %1.</source>
        <translation>Klaar. Blokkerende bevindingen: %1.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Klaar.</translation>
    </message>
    <message>
        <source>Pieces updated. Press Plan for layers and paths.</source>
        <translation>Delen bijgewerkt. Druk op Plannen voor lagen en banen.</translation>
    </message>
    <message>
        <source>Voxels updated. Press Plan for layers and paths.</source>
        <translation>Voxels bijgewerkt. Druk op Plannen voor lagen en banen.</translation>
    </message>
    <message>
        <source>Press Plan for layers and paths.</source>
        <translation>Druk op Plannen voor lagen en banen.</translation>
    </message>
    <message>
        <source>Compared. Select a row to adopt it.</source>
        <translation>Vergeleken. Selecteer een rij om die over te nemen.</translation>
    </message>
    <message>
        <source>Preview: %1, 1 growth step</source>
        <translation>Voorbeeld: %1, 1 groeistap</translation>
    </message>
    <message>
        <source>Preview: %1, %2 growth steps</source>
        <translation>Voorbeeld: %1, %2 groeistappen</translation>
    </message>
    <message>
        <source>Preview: %1, improving layers</source>
        <translation>Voorbeeld: %1, lagen worden verbeterd</translation>
    </message>
    <message>
        <source>Preview: %1. Press Plan.</source>
        <translation>Voorbeeld: %1. Druk op Plannen.</translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation>Verouderd: %1</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 deel</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 delen</translation>
    </message>
    <message>
        <source>%1 mm² need support</source>
        <translation>%1 mm² heeft ondersteuning nodig</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 laag</translation>
    </message>
    <message>
        <source>Cancelled. The previous results are still shown.</source>
        <translation>Geannuleerd. De vorige resultaten worden nog getoond.</translation>
    </message>
    <message>
        <source>Cancelled. Press Plan to start again.</source>
        <translation>Geannuleerd. Druk op Plannen om opnieuw te beginnen.</translation>
    </message>
    <message>
        <source>The run failed: see the findings.</source>
        <translation>De uitvoering is mislukt: zie de bevindingen.</translation>
    </message>
    <message>
        <source>Cannot plan: correct the marked setting.</source>
        <translation>Plannen niet mogelijk: corrigeer de gemarkeerde instelling.</translation>
    </message>
    <message>
        <source>planned time %1</source>
        <translation>geplande tijd %1</translation>
    </message>
    <message>
        <source>time on the controller %1</source>
        <translation>tijd op de besturing %1</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 onderdelen</translation>
    </message>
    <message>
        <source>1 tool change</source>
        <translation>1 gereedschapswissel</translation>
    </message>
    <message>
        <source>%1 tool changes</source>
        <translation>%1 gereedschapswissels</translation>
    </message>
    <message>
        <source>not passed: blocking findings</source>
        <translation>niet geslaagd: blokkerende bevindingen</translation>
    </message>
    <message>
        <source>safe to run, not as asked</source>
        <translation>veilig uit te voeren, niet zoals gevraagd</translation>
    </message>
    <message>
        <source>Done. Safe to run, not as asked: %1.</source>
        <translation>Klaar. Veilig uit te voeren, niet zoals gevraagd: %1.</translation>
    </message>
    <message>
        <source>safe to run but for your own statements</source>
        <translation>veilig uit te voeren, behalve je eigen instructies</translation>
    </message>
    <message>
        <source>Done. Safe to run but for your own statements.</source>
        <translation>Klaar. Veilig uit te voeren, behalve je eigen instructies.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ShortcutsDialog</name>
    <message>
        <source>Keys</source>
        <translation>Sneltoetsen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commando</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Toets</translation>
    </message>
    <message>
        <source>Default key</source>
        <translation>Standaardtoets</translation>
    </message>
    <message>
        <source>New key:</source>
        <translation>Nieuwe toets:</translation>
    </message>
    <message>
        <source>This key was removed from “%1”.</source>
        <translation>Deze toets is bij “%1” verwijderd.</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nieuwe toets</translation>
    </message>
</context>
<context>
    <name>voluta::window::SimulatePage</name>
    <message>
        <source>Collision solids</source>
        <translation>Botsingslichamen</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>Toont over de arm heen de lichamen die voor de botsingscontrole worden gebruikt</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>Opgenomen run</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Follow the nozzle</source>
        <translation>Spuitmond volgen</translation>
    </message>
    <message>
        <source>Keeps the nozzle in the middle of the view</source>
        <translation>Houdt de spuitmond in het midden van het beeld</translation>
    </message>
    <message>
        <source>Plan the motion before you jog the arm.</source>
        <translation>Plan de beweging voordat je de arm met de hand beweegt.</translation>
    </message>
    <message>
        <source>Kinds of beads, with statistics</source>
        <translation>Soorten rupsen, met statistiek</translation>
    </message>
    <message>
        <source>Colours the beads by kind, with time, share, length and mass of each</source>
        <translation>Kleurt de rupsen per soort, met van elke de tijd, het aandeel, de lengte en de massa</translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation>De arm met de hand bewegen</translation>
    </message>
    <message>
        <source>Moves the arm by hand, by joints or by the nozzle. The plan stays as it is</source>
        <translation>Beweegt de arm met de hand, per gewricht of via de spuitmond. Het plan blijft zoals het is</translation>
    </message>
    <message>
        <source>Trace of the nozzle</source>
        <translation>Spoor van de spuitmond</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>Last %1 s</source>
        <translation>Laatste %1 s</translation>
    </message>
    <message>
        <source>Whole print</source>
        <translation>Hele print</translation>
    </message>
    <message>
        <source>Solid where the nozzle prints, dashed where it travels</source>
        <translation>Doorgetrokken waar de spuitmond print, gestreept waar hij zich verplaatst</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>Verwijder de pauze vóór laag %1</translation>
    </message>
    <message>
        <source>Pause before layer %1</source>
        <translation>Pauze vóór laag %1</translation>
    </message>
    <message>
        <source>Event before layer %1…</source>
        <translation>Gebeurtenis vóór laag %1…</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>Gebeurtenis vóór deze laag…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>Een pauze, een wachttijd, een uitgang, een ander gereedschap of een eigen regel</translation>
    </message>
</context>
<context>
    <name>voluta::window::SizesDialog</name>
    <message>
        <source>Sizes from a measured plate</source>
        <translation>Maten van een gemeten plaat</translation>
    </message>
    <message>
        <source>Plate of %1</source>
        <translation>Plaat van %1</translation>
    </message>
    <message>
        <source>Print the sample plate (File &gt; Samples) with this process, and measure it.</source>
        <translation>Print de voorbeeldplaat (Bestand &gt; Voorbeelden) met dit proces en meet haar na.</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominaal</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemeten</translation>
    </message>
    <message>
        <source>Use these sizes</source>
        <translation>Deze maten gebruiken</translation>
    </message>
    <message>
        <source>Size factors %1 (x) and %2 (y), outlines %3, holes %4; the measured sizes fit within %5.</source>
        <translation>Maatfactoren %1 (x) en %2 (y), omtrekken %3, gaten %4; de gemeten maten kloppen tot op %5.</translation>
    </message>
</context>
<context>
    <name>voluta::window::SpacingView</name>
    <message>
        <source>%1–%2 mm: %3 % of the area</source>
        <translation>%1–%2 mm: %3 % van het oppervlak</translation>
    </message>
    <message>
        <source>Layer spacing, share of area by thickness [mm]</source>
        <translation>Laagafstand, aandeel van het oppervlak naar dikte [mm]</translation>
    </message>
    <message>
        <source>Mean %1 mm. Within %2–%3 mm: %4 %.</source>
        <translation>Gemiddeld %1 mm. Binnen %2–%3 mm: %4 %.</translation>
    </message>
    <message>
        <source>Too thin: %1 %.</source>
        <translation>Te dun: %1 %.</translation>
    </message>
    <message>
        <source>Too thick: %1 %.</source>
        <translation>Te dik: %1 %.</translation>
    </message>
</context>
<context>
    <name>voluta::window::StandChooser</name>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>change orientation</source>
        <translation>oriëntatie wijzigen</translation>
    </message>
</context>
<context>
    <name>voluta::window::StatusLine</name>
    <message>
        <source>about %1 left</source>
        <translation>nog ongeveer %1</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
</context>
<context>
    <name>voluta::window::TogetherDialog</name>
    <message>
        <source>Print together with other machines</source>
        <translation>Samen met andere machines printen</translation>
    </message>
    <message>
        <source>Add project…</source>
        <translation>Project toevoegen…</translation>
    </message>
    <message>
        <source>Add this job again</source>
        <translation>Deze opdracht nog eens toevoegen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Save programs…</source>
        <translation>Programma&apos;s opslaan…</translation>
    </message>
    <message>
        <source>Waits, and what they keep apart</source>
        <translation>Wachttijden, en wat ze uit elkaar houden</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Afspelen of pauzeren</translation>
    </message>
    <message>
        <source>The programs were saved in %1.</source>
        <translation>De programma&apos;s zijn opgeslagen in %1.</translation>
    </message>
    <message>
        <source>Project of another machine</source>
        <translation>Project van een andere machine</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Voluta-projecten (*.voluta)</translation>
    </message>
    <message>
        <source>Add the project of a machine that works beside this one.</source>
        <translation>Voeg het project toe van een machine die naast deze werkt.</translation>
    </message>
    <message>
        <source>Place the machines, then find an order of work.</source>
        <translation>Plaats de machines en zoek daarna een werkvolgorde.</translation>
    </message>
    <message>
        <source>Together %1; one after the other %2; the longest alone %3</source>
        <translation>Samen %1; na elkaar %2; de langste alleen %3</translation>
    </message>
    <message>
        <source>Start the programs in any order: each waits at its first point for the others, whatever their signals are, and ends with its signals off. If one is stopped, stop all, and start all again.</source>
        <translation>Start de programma&apos;s in willekeurige volgorde: elk wacht op zijn eerste punt op de andere, ongeacht hun signalen, en eindigt met zijn signalen uit. Stopt er één, stop dan alle en start alle opnieuw.</translation>
    </message>
    <message>
        <source>Machine %1: marks %2, waits %3, ends after %4</source>
        <translation>Machine %1: markeringen %2, wachttijden %3, eindigt na %4</translation>
    </message>
    <message>
        <source>Collision: %1 of machine %2 with %3 of machine %4</source>
        <translation>Botsing: %1 van machine %2 met %3 van machine %4</translation>
    </message>
    <message>
        <source>Machine %1 waits %2 for machine %3</source>
        <translation>Machine %1 wacht %2 op machine %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bij %2</translation>
    </message>
    <message>
        <source>Folder for all programs</source>
        <translation>Map voor alle programma&apos;s</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Opmerking: %1</translation>
    </message>
    <message>
        <source>Move %1 mm further apart</source>
        <translation>%1 mm verder uit elkaar zetten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Minimum distance %1 mm; collisions: %2</source>
        <translation>Minimale afstand %1 mm; botsingen: %2</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Minimum clearance between arms</source>
        <translation>Minimale afstand tussen armen</translation>
    </message>
</context>
<context>
    <name>voluta::window::TouchDialog</name>
    <message>
        <source>Line %1 is not a point: write y and z, or x, y and z, in mm.</source>
        <translation>Regel %1 is geen punt: schrijf y en z, of x, y en z, in mm.</translation>
    </message>
    <message>
        <source>Place on touched points</source>
        <translation>Op aangeraakte punten plaatsen</translation>
    </message>
    <message>
        <source>Touch a cylinder along x at three points or more, and enter them in the work frame: y z, or x y z, one point per line [mm].</source>
        <translation>Tast een cilinder langs x op drie of meer punten aan en voer ze in het werkassenstelsel in: y z, of x y z, één punt per regel [mm].</translation>
    </message>
    <message>
        <source>y of the axis in the model</source>
        <translation>y van de as in het model</translation>
    </message>
    <message>
        <source>z of the axis in the model</source>
        <translation>z van de as in het model</translation>
    </message>
    <message>
        <source>Axis in the model (y, z)</source>
        <translation>As in het model (y, z)</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>Onderdeel verplaatsen</translation>
    </message>
    <message>
        <source>Centre y %1, z %2 mm; radius %3 mm; points: %4, mean deviation %5 mm.</source>
        <translation>Middelpunt y %1, z %2 mm; straal %3 mm; punten: %4, gemiddelde afwijking %5 mm.</translation>
    </message>
    <message>
        <source>The part is moved by y %1, z %2 mm.</source>
        <translation>Het onderdeel wordt verplaatst met y %1, z %2 mm.</translation>
    </message>
    <message>
        <source>Touched points</source>
        <translation>Afgetaste punten</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledCanvas</name>
    <message>
        <source>→ around, ↑ along [mm]</source>
        <translation>→ rondom, ↑ langs [mm]</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledDock</name>
    <message>
        <source>Layer %1 of %2</source>
        <translation>Laag %1 van %2</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Uitgerolde laag</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledView</name>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Spleetvulling</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>Skirt of brim</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Ondersteuning</translation>
    </message>
    <message>
        <source>Around %1 mm (%2°), along %3 mm</source>
        <translation>Rondom %1 mm (%2°), langs %3 mm</translation>
    </message>
    <message>
        <source>Around %1 mm, along %2 mm</source>
        <translation>Rondom %1 mm, langs %2 mm</translation>
    </message>
    <message>
        <source>%1 %2, waypoint %3 of %4</source>
        <translation>%1 %2, baanpunt %3 van %4</translation>
    </message>
    <message>
        <source>This layer is not wound around an axis.</source>
        <translation>Deze laag is niet om een as gewikkeld.</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Uitgerolde laag</translation>
    </message>
    <message>
        <source>Click a path to find it in the 3D view. Wheel zooms, drag moves, double click shows all.</source>
        <translation>Klik op een baan om haar in de 3D-weergave te vinden. Wiel zoomt, slepen verplaatst, dubbelklikken toont alles.</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Primen</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>Open vulling</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Brug</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Tape</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Injectie</translation>
    </message>
</context>
<context>
    <name>voluta::window::VerifyDialog</name>
    <message>
        <source>Replay findings</source>
        <translation>Bevindingen van de controlerun</translation>
    </message>
    <message>
        <source>Verify %1</source>
        <translation>%1 verifiëren</translation>
    </message>
    <message>
        <source>Replaying the program against the current plan…</source>
        <translation>Controlerun van het programma tegen het huidige plan…</translation>
    </message>
    <message>
        <source>%1: passed. The program matches the plan.</source>
        <translation>%1: geslaagd. Het programma komt overeen met het plan.</translation>
    </message>
    <message>
        <source>%1: refused. Do not run it on the robot.</source>
        <translation>%1: geweigerd. Niet op de robot uitvoeren.</translation>
    </message>
    <message>
        <source>Replay findings, the first %1 of %2</source>
        <translation>Bevindingen van de controlerun, de eerste %1 van %2</translation>
    </message>
    <message>
        <source>%1: safe to run, but it does not print the part as asked.</source>
        <translation>%1: veilig uit te voeren, maar print het onderdeel niet zoals gevraagd.</translation>
    </message>
    <message>
        <source>%1: safe to run but for your own statements, which nothing checks.</source>
        <translation>%1: veilig om uit te voeren, behalve je eigen instructies, die door niets worden gecontroleerd.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ViewOptions</name>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Kleuren naar</translation>
    </message>
    <message>
        <source>Latest</source>
        <translation>Nieuwste</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxels</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Banen</translation>
    </message>
    <message>
        <source>The latest result of the plan</source>
        <translation>Het nieuwste resultaat van het plan</translation>
    </message>
    <message>
        <source>Layers drawn with their thickness</source>
        <translation>Lagen getekend met hun dikte</translation>
    </message>
    <message>
        <source>Tool-paths drawn as beads</source>
        <translation>Gereedschapsbanen getekend als strengen</translation>
    </message>
    <message>
        <source>Part surface</source>
        <translation>Onderdeeloppervlak</translation>
    </message>
    <message>
        <source>Travel moves</source>
        <translation>Verplaatsingen</translation>
    </message>
    <message>
        <source>True bead width</source>
        <translation>Werkelijke strengbreedte</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Doorsnedevlak</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Omkeren</translation>
    </message>
    <message>
        <source>Remove the other side</source>
        <translation>De andere kant wegnemen</translation>
    </message>
    <message>
        <source>Position of the section plane</source>
        <translation>Positie van het doorsnedevlak</translation>
    </message>
    <message>
        <source>Solid voxels and their growth order</source>
        <translation>Massieve voxels en hun groeivolgorde</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Convex front</translation>
    </message>
    <message>
        <source>During growth replay: the convex front; the next voxels must be outside it</source>
        <translation>Bij het afspelen van de groei: het convexe front; de volgende voxels moeten erbuiten liggen</translation>
    </message>
    <message>
        <source>Later voxels faint</source>
        <translation>Latere voxels vaag</translation>
    </message>
    <message>
        <source>During growth replay: voxels not yet printed</source>
        <translation>Bij het afspelen van de groei: nog niet geprinte voxels</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Delen</translation>
    </message>
    <message>
        <source>Pieces printable without support, and their base planes</source>
        <translation>Delen die zonder ondersteuning printbaar zijn, en hun basisvlakken</translation>
    </message>
</context>
<context>
    <name>voluta::window::Welcome</name>
    <message>
        <source>Print a part with a robot</source>
        <translation>Een onderdeel met een robot printen</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Geen beeld</translation>
    </message>
    <message>
        <source>Drop a mesh (STL, OBJ, PLY, OFF or 3MF), a slicer&apos;s G-code or a Voluta project here.</source>
        <translation>Sleep een mesh (STL, OBJ, PLY, OFF of 3MF), G-code van een slicer of een Voluta-project hierheen.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Openen…</translation>
    </message>
    <message>
        <source>Sample vase</source>
        <translation>Voorbeeldvaas</translation>
    </message>
</context>
</TS>
