<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nb_NO" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avslutt</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Lukk vinduet</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>&amp;Snarveier…</translation>
    </message>
    <message>
        <source>See and change the keys</source>
        <translation>Vis og endre snarveier</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>M&amp;ørk</translation>
    </message>
    <message>
        <source>Light text on a dark background</source>
        <translation>Lys tekst på mørk bakgrunn</translation>
    </message>
    <message>
        <source>P&amp;icture…</source>
        <translation>&amp;Bilde…</translation>
    </message>
    <message>
        <source>Save the viewport as a PNG</source>
        <translation>Lagre 3D-visningen som PNG</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Fullsk&amp;jerm</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>Hele skjermen</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Snarveier</translation>
    </message>
    <message>
        <source>All keys at a glance</source>
        <translation>Alle snarveier på ett sted</translation>
    </message>
    <message>
        <source>Show &amp;log</source>
        <translation>Vis &amp;logg</translation>
    </message>
    <message>
        <source>Files opened, plans, findings and errors</source>
        <translation>Åpnede filer, planer, funn og feil</translation>
    </message>
    <message>
        <source>&amp;About Voluta</source>
        <translation>&amp;Om Voluta</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versjon og lisens</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>Sa&amp;mmenlign</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Eksporter</translation>
    </message>
    <message>
        <source>Robot &amp;programs…</source>
        <translation>Robot&amp;programmer…</translation>
    </message>
    <message>
        <source>Write the chosen programs into a folder</source>
        <translation>Skriv de valgte programmene til en mappe</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Lag</translation>
    </message>
    <message>
        <source>Go to this page</source>
        <translation>Gå til denne siden</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Flytt</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Roter</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Skaler</translation>
    </message>
    <message>
        <source>&amp;Lay on face</source>
        <translation>&amp;Legg på flate</translation>
    </message>
    <message>
        <source>Click the face to place on the plate</source>
        <translation>Klikk flaten som skal ligge mot byggeplaten</translation>
    </message>
    <message>
        <source>&amp;Drop to plate</source>
        <translation>Senk til &amp;byggeplaten</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>Senker delen ned på byggeplaten</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>S&amp;entrer</translation>
    </message>
    <message>
        <source>Centres the part on the plate</source>
        <translation>Sentrerer delen på byggeplaten</translation>
    </message>
    <message>
        <source>Place on touched &amp;points…</source>
        <translation>Plasser på m&amp;ålte punkter…</translation>
    </message>
    <message>
        <source>Moves the part to a cylinder measured by touching</source>
        <translation>Flytter delen til en sylinder som er målt ved berøring</translation>
    </message>
    <message>
        <source>&amp;Prepare</source>
        <translation>&amp;Klargjør</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Tilbakestill alle &amp;parametere</translation>
    </message>
    <message>
        <source>Resets every parameter to its default</source>
        <translation>Setter alle parametere til standardverdi</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Simuler</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Nytt prosjekt</translation>
    </message>
    <message>
        <source>Start without a part</source>
        <translation>Start uten del</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Åpne…</translation>
    </message>
    <message>
        <source>Open a mesh or a project</source>
        <translation>Åpne en mesh eller et prosjekt</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>Vase</translation>
    </message>
    <message>
        <source>A fluted vase, 60 mm high</source>
        <translation>En riflet vase, 60 mm høy</translation>
    </message>
    <message>
        <source>Mushroom</source>
        <translation>Sopp</translation>
    </message>
    <message>
        <source>A wide cap on a stem, made of voxels</source>
        <translation>En bred hatt på en stilk, laget av voksler</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Gaffel</translation>
    </message>
    <message>
        <source>A stem with two branches, made of voxels</source>
        <translation>En stilk med to grener, laget av voksler</translation>
    </message>
    <message>
        <source>Dumb-bell for tension</source>
        <translation>Strekkprøvestav</translation>
    </message>
    <message>
        <source>A specimen of 165 × 19 × 3 mm</source>
        <translation>Et prøvestykke på 165 × 19 × 3 mm</translation>
    </message>
    <message>
        <source>Bar for bending</source>
        <translation>Bøyeprøvestav</translation>
    </message>
    <message>
        <source>A specimen of 250 × 10 × 5 mm</source>
        <translation>Et prøvestykke på 250 × 10 × 5 mm</translation>
    </message>
    <message>
        <source>Plate with a hole</source>
        <translation>Plate med hull</translation>
    </message>
    <message>
        <source>A specimen of 120 × 60 × 3 mm</source>
        <translation>Et prøvestykke på 120 × 60 × 3 mm</translation>
    </message>
    <message>
        <source>Curved bar on its mould</source>
        <translation>Krum stav på formen sin</translation>
    </message>
    <message>
        <source>Seven layers around a cylinder of 60 mm radius</source>
        <translation>Sju lag rundt en sylinder med radius 60 mm</translation>
    </message>
    <message>
        <source>Rib on a gable roof</source>
        <translation>Ribbe på saltak</translation>
    </message>
    <message>
        <source>Ten layers over both slopes; the nozzle tilts by 60°</source>
        <translation>Ti lag over begge takflatene; dysen tiltes 60°</translation>
    </message>
    <message>
        <source>Rib on a half cylinder</source>
        <translation>Ribbe på halvsylinder</translation>
    </message>
    <message>
        <source>Ten layers around it; the nozzle tilts by 87°</source>
        <translation>Ti lag rundt den; dysen tiltes 87°</translation>
    </message>
    <message>
        <source>Accuracy plate</source>
        <translation>Nøyaktighetsplate</translation>
    </message>
    <message>
        <source>Slots and a hole of known sizes, to be measured</source>
        <translation>Spor og et hull med kjente mål, til oppmåling</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Lagre</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Lagre prosjektet</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Lagre s&amp;om…</translation>
    </message>
    <message>
        <source>Save the project under a new name</source>
        <translation>Lagre prosjektet under et nytt navn</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planlegg</translation>
    </message>
    <message>
        <source>From the part to verified robot programs</source>
        <translation>Fra del til verifiserte robotprogrammer</translation>
    </message>
    <message>
        <source>Plan up to the &amp;layers</source>
        <translation>Planlegg til og med &amp;lagene</translation>
    </message>
    <message>
        <source>Stops before tool-paths and motion</source>
        <translation>Stopper før verktøybaner og bevegelse</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Avbryt</translation>
    </message>
    <message>
        <source>Stop; the last results stay visible</source>
        <translation>Stopp; de siste resultatene forblir synlige</translation>
    </message>
    <message>
        <source>&amp;Update voxels while editing</source>
        <translation>&amp;Oppdater voksler under redigering</translation>
    </message>
    <message>
        <source>After the first plan, voxels follow the settings; layers and paths wait for Plan</source>
        <translation>Etter første plan følger vokslene innstillingene; lag og baner venter på Planlegg</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Forfra</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Bakfra</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Fra &amp;høyre</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Fra &amp;venstre</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Ovenfra</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Nedenfra</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>Skr&amp;ått</translation>
    </message>
    <message>
        <source>View from this side</source>
        <translation>Se fra denne siden</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fil</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Rediger</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vis</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Kjør</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>&amp;Eksporter</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Vi&amp;ndu</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjelp</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Åpne nyli&amp;ge</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>Ekse&amp;mpler</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;pråk</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>Vis &amp;alt</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>Tilpass alt til visningen</translation>
    </message>
    <message>
        <source>&amp;Section plane</source>
        <translation>&amp;Snittplan</translation>
    </message>
    <message>
        <source>Cut the view open with a plane</source>
        <translation>Åpne visningen med et snittplan</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>For&amp;klaring</translation>
    </message>
    <message>
        <source>Meaning of the colours in the view</source>
        <translation>Hva fargene i visningen betyr</translation>
    </message>
    <message>
        <source>&amp;Unrolled layer</source>
        <translation>&amp;Utbrettet lag</translation>
    </message>
    <message>
        <source>Shows layers around an axis unrolled, next to the view</source>
        <translation>Viser lag rundt en akse utbrettet, ved siden av visningen</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Spill av eller pause</translation>
    </message>
    <message>
        <source>Play or pause the time-line</source>
        <translation>Spill av eller sett tidslinjen på pause</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Neste bevegelse</translation>
    </message>
    <message>
        <source>One move forward</source>
        <translation>Én bevegelse fram</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Forrige bevegelse</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>Én bevegelse tilbake</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Neste lag</translation>
    </message>
    <message>
        <source>One layer forward</source>
        <translation>Ett lag fram</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Forrige lag</translation>
    </message>
    <message>
        <source>One layer back</source>
        <translation>Ett lag tilbake</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Lagre bildet</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>About Voluta</source>
        <translation>Om Voluta</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;3D printing with robot arms: layers without support, tool-paths, motion checked against the growing part, and programs verified by replay.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;3D-print med robotarmer: lag uten støtte, verktøybaner, bevegelse kontrollert mot den voksende delen og programmer verifisert ved gjenspilling.&lt;/p&gt;&lt;p&gt;Fri programvare under GNU General Public License, versjon 3 eller nyere.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Angre %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Angre</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Gjør om %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Gjør om</translation>
    </message>
    <message>
        <source>&amp;Resume print from here…</source>
        <translation>&amp;Gjenoppta printen herfra…</translation>
    </message>
    <message>
        <source>Opens the rest of a print stopped at this moment as a new project</source>
        <translation>Åpner resten av en print som stoppet på dette tidspunktet, som et nytt prosjekt</translation>
    </message>
    <message>
        <source>&amp;Verify a program…</source>
        <translation>&amp;Verifiser et program…</translation>
    </message>
    <message>
        <source>Replay a program from disk against the plan shown</source>
        <translation>Gjenspill et program fra disk mot planen som vises</translation>
    </message>
    <message>
        <source>Edit &amp;cell…</source>
        <translation>Rediger &amp;celle…</translation>
    </message>
    <message>
        <source>Robot, and positions of nozzle, plate and obstacles</source>
        <translation>Robot, og plassering av dyse, byggeplate og hindringer</translation>
    </message>
    <message>
        <source>Import robot &amp;arm…</source>
        <translation>Importer robot&amp;arm…</translation>
    </message>
    <message>
        <source>Your own robot from its URDF, with a cell</source>
        <translation>Egen robot fra URDF-filen, med en celle</translation>
    </message>
    <message>
        <source>D&amp;uplicate part</source>
        <translation>D&amp;upliser del</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part beside the others</source>
        <translation>Legger en kopi av den valgte delen ved siden av de andre</translation>
    </message>
    <message>
        <source>&amp;Remove part</source>
        <translation>F&amp;jern del</translation>
    </message>
    <message>
        <source>A&amp;dd part…</source>
        <translation>Legg &amp;til del…</translation>
    </message>
    <message>
        <source>Adds a part beside the others</source>
        <translation>Legger en del ved siden av de andre</translation>
    </message>
    <message>
        <source>&amp;Arrange parts</source>
        <translation>&amp;Ordne deler</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>Flytter alle deler ved siden av hverandre, med plass til skrivehodet</translation>
    </message>
    <message>
        <source>Processes and &amp;materials…</source>
        <translation>Prosesser og &amp;materialer…</translation>
    </message>
    <message>
        <source>Nozzle, bead sizes, speeds, head; own processes and materials</source>
        <translation>Dyse, strengmål, hastigheter, hode; egne prosesser og materialer</translation>
    </message>
    <message>
        <source>Compare with a recor&amp;ded run…</source>
        <translation>Sammenlign me&amp;d en registrert kjøring…</translation>
    </message>
    <message>
        <source>Lays a run that the controller recorded beside the plan shown</source>
        <translation>Legger en kjøring som styringen har registrert, ved siden av planen som vises</translation>
    </message>
    <message>
        <source>&amp;Mill from a block…</source>
        <translation>F&amp;res fra et emne…</translation>
    </message>
    <message>
        <source>Mills the part out of a block and writes the G-code, checked on the block</source>
        <translation>Freser delen ut av et emne og skriver G-koden, kontrollert på emnet</translation>
    </message>
    <message>
        <source>Print to&amp;gether with other machines…</source>
        <translation>Print sammen med andre &amp;maskiner…</translation>
    </message>
    <message>
        <source>Places other machines beside this one and finds an order of work in which they do not meet</source>
        <translation>Plasserer andre maskiner ved siden av denne og finner en arbeidsrekkefølge der de ikke møtes</translation>
    </message>
    <message>
        <source>Moves the part: drag a handle, or type X 10 Enter</source>
        <translation>Flytter delen: dra et håndtak, eller skriv X 10 Enter</translation>
    </message>
    <message>
        <source>Rotates the part: drag a ring, or type Z 45 Enter</source>
        <translation>Roterer delen: dra en ring, eller skriv Z 45 Enter</translation>
    </message>
    <message>
        <source>Scales the part: drag a handle, or type 120 Enter for 120 %</source>
        <translation>Skalerer delen: dra et håndtak, eller skriv 120 Enter for 120 %</translation>
    </message>
    <message>
        <source>Removes the selected parts from the plate</source>
        <translation>Fjerner de valgte delene fra byggeplaten</translation>
    </message>
    <message>
        <source>&amp;Number of copies…</source>
        <translation>A&amp;ntall kopier…</translation>
    </message>
    <message>
        <source>Prints the selected part several times, or as often as the plate has room</source>
        <translation>Printer den valgte delen flere ganger, eller så mange ganger det er plass på byggeplaten</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopier</translation>
    </message>
    <message>
        <source>Copies the selected parts with their settings</source>
        <translation>Kopierer de valgte delene med innstillingene deres</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Lim &amp;inn</translation>
    </message>
    <message>
        <source>Adds the copied parts beside the others</source>
        <translation>Legger de kopierte delene ved siden av de andre</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Merk &amp;alt</translation>
    </message>
    <message>
        <source>Selects all parts, to copy or to remove them</source>
        <translation>Merker alle deler, for å kopiere eller fjerne dem</translation>
    </message>
    <message>
        <source>Show the &amp;part</source>
        <translation>Vis &amp;delen</translation>
    </message>
    <message>
        <source>Fit the selected part into the view</source>
        <translation>Tilpass den valgte delen til visningen</translation>
    </message>
    <message>
        <source>Show the &amp;arm</source>
        <translation>Vis a&amp;rmen</translation>
    </message>
    <message>
        <source>On the Prepare page, shows the arm whole instead of dimmed behind the part</source>
        <translation>Viser armen helt i stedet for nedtonet bak delen på siden Klargjør</translation>
    </message>
    <message>
        <source>&amp;Find a command or setting…</source>
        <translation>&amp;Finn en kommando eller innstilling…</translation>
    </message>
    <message>
        <source>Lists commands and settings while you type</source>
        <translation>Viser kommandoer og innstillinger mens du skriver</translation>
    </message>
    <message>
        <source>&amp;Quote…</source>
        <translation>&amp;Tilbud…</translation>
    </message>
    <message>
        <source>Cost of the print, and its page for a customer</source>
        <translation>Kostnaden for utskriften, og siden til en kunde</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Håndbok</translation>
    </message>
    <message>
        <source>The page of the manual about what is shown</source>
        <translation>Siden i håndboken om det som vises</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>&amp;Eksporter…</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Mål</translation>
    </message>
    <message>
        <source>Click places on the part: radius, wall, distance, angle</source>
        <translation>Klikk på steder på delen: radius, vegg, avstand, vinkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Lyst</translation>
    </message>
    <message>
        <source>Dark text on a light background</source>
        <translation>Mørk tekst på lys bakgrunn</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Høy kontrast</translation>
    </message>
    <message>
        <source>White text on black, with strong outlines</source>
        <translation>Hvit tekst på svart, med tydelige omriss</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>&amp;Film…</translation>
    </message>
    <message>
        <source>Save a film of the robot that prints the part (WebM)</source>
        <translation>Lagre en film av roboten som skriver ut delen (WebM)</translation>
    </message>
    <message>
        <source>C&amp;ut…</source>
        <translation>S&amp;kjær…</translation>
    </message>
    <message>
        <source>Cuts the part in two with a plane, with dowels, pegs or a dovetail</source>
        <translation>Deler delen i to med et plan, med dybler, tapper eller svalehale</translation>
    </message>
    <message>
        <source>Split to &amp;parts</source>
        <translation>Del opp i &amp;deler</translation>
    </message>
    <message>
        <source>Makes a part of each body of the mesh</source>
        <translation>Lager en del av hvert legeme i nettet</translation>
    </message>
    <message>
        <source>Re&amp;name part</source>
        <translation>Gi delen nytt &amp;navn</translation>
    </message>
    <message>
        <source>Edits the name of the part in the tree</source>
        <translation>Endrer navnet på delen i treet</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>U&amp;tseende</translation>
    </message>
    <message>
        <source>Darken cor&amp;ners</source>
        <translation>Gjør &amp;hjørner mørkere</translation>
    </message>
    <message>
        <source>Darkens corners and gaps, so that shapes are clearer; slow without a graphics card</source>
        <translation>Gjør hjørner og mellomrom mørkere, så formene blir tydeligere; tregt uten grafikkort</translation>
    </message>
    <message>
        <source>Re&amp;gions…</source>
        <translation>Re&amp;gioner…</translation>
    </message>
    <message>
        <source>Places in the part with settings, or layers, of their own</source>
        <translation>Steder i delen med egne innstillinger eller egne lag</translation>
    </message>
    <message>
        <source>Add &amp;region…</source>
        <translation>Legg til &amp;region…</translation>
    </message>
    <message>
        <source>Adds a place with settings, or layers, of its own</source>
        <translation>Legger til et sted med egne innstillinger eller egne lag</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>&quot;{text}&quot; is not a point</source>
        <translation>&quot;{text}&quot; er ikke et punkt</translation>
    </message>
    <message>
        <source>&apos;end&apos; closes no function</source>
        <translation>&apos;end&apos; avslutter ingen funksjon</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not a number</source>
        <translation>&apos;{attribute}&apos; er ikke et tall</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not an integer</source>
        <translation>&apos;{attribute}&apos; er ikke et heltall</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex</source>
        <translation>&apos;{corner}&apos; er ikke indeksen til et hjørnepunkt</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex read so far</source>
        <translation>&apos;{corner}&apos; er ikke indeksen til et hjørnepunkt som er lest så langt</translation>
    </message>
    <message>
        <source>&apos;{loaded}&apos; is not unloaded</source>
        <translation>&apos;{loaded}&apos; blir ikke lastet ut</translation>
    </message>
    <message>
        <source>&apos;{member}&apos; in it {what}</source>
        <translation>&apos;{member}&apos; i den {what}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is called outside the function</source>
        <translation>&apos;{name}&apos; kalles utenfor funksjonen</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not of type {type}</source>
        <translation>&apos;{name}&apos; er ikke av typen {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not declared as {type}</source>
        <translation>&apos;{name}&apos; er ikke deklarert som {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not known to the reader</source>
        <translation>&apos;{name}&apos; er ukjent for leseren</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a weight</source>
        <translation>&apos;{text}&apos; er ikke en vekt</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a number</source>
        <translation>&apos;{text}&apos; er ikke et tall</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not expected here</source>
        <translation>&apos;{text}&apos; er ikke ventet her</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not key=value</source>
        <translation>&apos;{text}&apos; er ikke nøkkel=verdi</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is neither true nor false</source>
        <translation>&apos;{value}&apos; er verken true eller false</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a number</source>
        <translation>&apos;{value}&apos; er ikke et tall</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a whole number</source>
        <translation>&apos;{value}&apos; er ikke et heltall</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not one of {choices}</source>
        <translation>&apos;{value}&apos; er ikke blant {choices}</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is out of range</source>
        <translation>&apos;{value}&apos; er utenfor området</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not known to the reader</source>
        <translation>&apos;{word}&apos; er ukjent for leseren</translation>
    </message>
    <message>
        <source>--ik: the quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>--ik: kvaternionens lengde er {length:.4g}, ikke 1</translation>
    </message>
    <message>
        <source>0: round rod. 3 or more: prism; its diameter is measured across the corners.</source>
        <translation>0: rund stang. 3 eller mer: prisme; diameteren måles over hjørnene.</translation>
    </message>
    <message>
        <source>Adaptive layers: largest distance between the edges of layers and the surface.</source>
        <translation>Adaptive lag: største avstand mellom lagkantene og overflaten.</translation>
    </message>
    <message>
        <source>Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp and trajectory.csv.</source>
        <translation>Legger til voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp og trajectory.csv.</translation>
    </message>
    <message>
        <source>Also writes programs that the replay refused, as refused-NAME. For inspection only: never run them.</source>
        <translation>Skriver også programmer som gjenspillingen avviste, som refused-NAME. Kun til inspeksjon: kjør dem aldri.</translation>
    </message>
    <message>
        <source>Beads along circles are written as arcs (G2 and G3, movec, MoveC, CIRC), within the resolution or 0.02 mm.</source>
        <translation>Strenger langs sirkler skrives som buer (G2 og G3, movec, MoveC, CIRC), innenfor oppløsningen eller 0,02 mm.</translation>
    </message>
    <message>
        <source>Layers at constant radius around the axis, or at constant distance from the rod&apos;s profile.</source>
        <translation>Lag med konstant radius rundt aksen, eller med konstant avstand fra stangens profil.</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>Strenger</translation>
    </message>
    <message>
        <source>an arc on a table that tilts is not understood</source>
        <translation>en bue på et bord som tilter, støttes ikke</translation>
    </message>
    <message>
        <source>export straight lines</source>
        <translation>eksporter rette linjer</translation>
    </message>
    <message>
        <source>Number of beads along the outline of each layer.</source>
        <translation>Antall strenger langs omrisset av hvert lag.</translation>
    </message>
    <message>
        <source>Colli-
sions</source>
        <translation>Kolli-
sjoner</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Konveks front</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Oppdeling</translation>
    </message>
    <message>
        <source>Direction of straight lines on the first layer, measured from x to y.</source>
        <translation>Retning for rette linjer på første lag, målt fra x mot y.</translation>
    </message>
    <message>
        <source>Minimum distance of everything but the print head from printed material.</source>
        <translation>Minste avstand fra printet materiale for alt unntatt skrivehodet.</translation>
    </message>
    <message>
        <source>Minimum distance between links, plate, nozzle holder and obstacles.</source>
        <translation>Minste avstand mellom armsegmenter, byggeplate, dyseholder og hindringer.</translation>
    </message>
    <message>
        <source>ENDMODULE is missing: the file was cut short</source>
        <translation>ENDMODULE mangler: filen er avkortet</translation>
    </message>
    <message>
        <source>ENDPROC without a procedure</source>
        <translation>ENDPROC uten prosedyre</translation>
    </message>
    <message>
        <source>Fermat spiral</source>
        <translation>Fermat-spiral</translation>
    </message>
    <message>
        <source>Field rounds</source>
        <translation>Feltrunder</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Spaltefyll</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Veksttrinn</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>Largest overhang, measured from the vertical, that prints without support; in all modes except curved.</source>
        <translation>Største overheng, målt fra loddlinjen, som kan printes uten støtte; i alle modi unntatt curved.</translation>
    </message>
    <message>
        <source>Minimum distance by which the nozzle lifts off the part before it travels.</source>
        <translation>Minste avstand dysen løftes fra delen før tomkjøring.</translation>
    </message>
    <message>
        <source>How many rotations of the part about the nozzle&apos;s axis are tried at each point.</source>
        <translation>Hvor mange rotasjoner av delen om dysens akse som prøves i hvert punkt.</translation>
    </message>
    <message>
        <source>Points of beads are omitted if the path, the nozzle&apos;s direction, the bead&apos;s section and the speed stay within tolerance without them; this is the tolerance of the path. 0: all points are written. Cells with external axes keep all points.</source>
        <translation>Punkter i strenger utelates hvis banen, dysens retning, strengens tverrsnitt og hastigheten holder seg innenfor toleransen uten dem; dette er toleransen for banen. 0: alle punkter skrives. Celler med eksterne akser beholder alle punkter.</translation>
    </message>
    <message>
        <source>Rotation of straight lines from layer to layer; 0: the same direction throughout.</source>
        <translation>Rotasjon av rette linjer fra lag til lag; 0: samme retning overalt.</translation>
    </message>
    <message>
        <source>Maximum number of rounds that fit the growth order and the smooth field to each other. 0: layers follow the growth order.</source>
        <translation>Største antall runder som tilpasser vekstrekkefølgen og det glatte feltet til hverandre. 0: lagene følger vekstrekkefølgen.</translation>
    </message>
    <message>
        <source>Pattern that fills the interior of each layer.</source>
        <translation>Mønster som fyller det indre av hvert lag.</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Fyll</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Lag</translation>
    </message>
    <message>
        <source>Layer spacing</source>
        <translation>Lagavstand</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lag</translation>
    </message>
    <message>
        <source>Surface on which flattening layers end: flat (at the part&apos;s top), flat:Z, radius:R (a larger cylinder) or mesh:FILE, placed together with the platform&apos;s mesh.</source>
        <translation>Flate der utflatende lag slutter: flat (ved delens topp), flat:Z, radius:R (en større sylinder) eller mesh:FILE, plassert sammen med plattformens mesh.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Innlasting</translation>
    </message>
    <message>
        <source>Missed, cascade</source>
        <translation>Tapt, kaskade</translation>
    </message>
    <message>
        <source>Missed, shadowed</source>
        <translation>Tapt, skygget</translation>
    </message>
    <message>
        <source>Missed, unreached</source>
        <translation>Tapt, ikke nådd</translation>
    </message>
    <message>
        <source>Mode flat: a JSON file or JSON text with the plane or quadrilateral of each layer. Empty: horizontal layers.</source>
        <translation>Modus flat: en JSON-fil eller JSON-tekst med planet eller firkanten til hvert lag. Tom: horisontale lag.</translation>
    </message>
    <message>
        <source>Mode planar: a JSON file or JSON text with a point and a normal for each cutting plane, in cutting order. Empty: automatic.</source>
        <translation>Modus planar: en JSON-fil eller JSON-tekst med et punkt og en normal for hvert snittplan, i kutterekkefølge. Tom: automatisk.</translation>
    </message>
    <message>
        <source>Mode planar: materials or filaments of the pieces, separated by commas. The list starts over if there are more pieces. Empty: the process&apos;s material.</source>
        <translation>Modus planar: materialer eller filamenter for stykkene, atskilt med komma. Listen begynner på nytt hvis det er flere stykker. Tom: prosessens materiale.</translation>
    </message>
    <message>
        <source>Mode planar: beam is a beam search that checks the true shape of the head; greedy is the published scheme, based on the part&apos;s skeleton.</source>
        <translation>Modus planar: beam er et strålesøk som kontrollerer hodets virkelige form; greedy er den publiserte metoden, basert på delens skjelett.</translation>
    </message>
    <message>
        <source>Mode substrate: layers at constant distance from the surface, on spheres, on cylinders along x, or flattening from the surface to an end surface with varying thickness.</source>
        <translation>Modus substrate: lag med konstant avstand fra overflaten, på kuler, på sylindre langs x, eller utflatende fra overflaten til en sluttflate med varierende tykkelse.</translation>
    </message>
    <message>
        <source>Height of the first layer; in all modes except curved. 0: same as the other layers.</source>
        <translation>Høyden på første lag; i alle modi unntatt curved. 0: som de andre lagene.</translation>
    </message>
    <message>
        <source>Modes planar and flat: thinner layers where the surface is inclined, within the process&apos;s limits.</source>
        <translation>Modi planar og flat: tynnere lag der overflaten heller, innenfor prosessens grenser.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bevegelse</translation>
    </message>
    <message>
        <source>Needs support</source>
        <translation>Trenger støtte</translation>
    </message>
    <message>
        <source>For helical infill: 0 winds around the axis, 90 runs along it.</source>
        <translation>For helisk fyll: 0 går rundt aksen, 90 går langs den.</translation>
    </message>
    <message>
        <source>Centre of spheres and cylinders: x,y,z in mm. Empty: that of the sphere or cylinder below the part, or a point below the part.</source>
        <translation>Sentrum for kuler og sylindre: x,y,z i mm. Tom: sentrum for kulen eller sylinderen under delen, eller et punkt under delen.</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Utdata</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with such pairs. A step needs two pairs at the same x. Beyond the pairs the rod keeps its own diameter. Empty: straight.</source>
        <translation>Par av x og radius i mm, for eksempel -20,2.5 0,2.5 0,3.5 20,3.5, eller en fil med slike par. Et trinn krever to par med samme x. Utenfor parene beholder stangen sin egen diameter. Tom: rett.</translation>
    </message>
    <message>
        <source>Peeling rank</source>
        <translation>Avskallingsrang</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Stykke</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stykker</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Plassering</translation>
    </message>
    <message>
        <source>RAPID (ABB)</source>
        <translation>RAPID (ABB)</translation>
    </message>
    <message>
        <source>Reach
%</source>
        <translation>Rekke-
vidde %</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Gjenspilling</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stang</translation>
    </message>
    <message>
        <source>Scheme greedy: number of thickness classes that distinguish the part&apos;s branches. 0: automatic.</source>
        <translation>Metode greedy: antall tykkelsesklasser som skiller delens grener. 0: automatisk.</translation>
    </message>
    <message>
        <source>Scheme greedy: a point x,y,z (mm) on the piece to print first; that piece must touch the plate. Empty: the piece with the largest contact area.</source>
        <translation>Metode greedy: et punkt x,y,z (mm) på stykket som skal printes først; det stykket må berøre byggeplaten. Tom: stykket med størst kontaktflate.</translation>
    </message>
    <message>
        <source>Head shape that must clear the part printed so far. flat: a plate of unlimited width. nozzle: the real head where voxels would be lost otherwise, and under wide roofs. auto: the real head only under wide roofs.</source>
        <translation>Hodeform som må gå klar av delen som er printet så langt. flat: en plate med ubegrenset bredde. nozzle: det virkelige hodet der voksler ellers ville gå tapt, og under brede tak. auto: det virkelige hodet bare under brede tak.</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>Skjørt eller brem</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>Current growth step</source>
        <translation>Gjeldende veksttrinn</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Støtte</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Støtter</translation>
    </message>
    <message>
        <source>Supports
mm³</source>
        <translation>Støtter
mm³</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Overflate</translation>
    </message>
    <message>
        <source>Tilt of the nozzle</source>
        <translation>Tilt av dysen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Too thick to print</source>
        <translation>For tykk til å printes</translation>
    </message>
    <message>
        <source>Too thin to print</source>
        <translation>For tynn til å printes</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>Verktøybaner</translation>
    </message>
    <message>
        <source>URScript (Universal Robots)</source>
        <translation>URScript (Universal Robots)</translation>
    </message>
    <message>
        <source>Use voxel width {fits}</source>
        <translation>Bruk vokselbredde {fits}</translation>
    </message>
    <message>
        <source>Voxel width</source>
        <translation>Vokselbredde</translation>
    </message>
    <message>
        <source>WaitTime without a time in seconds</source>
        <translation>WaitTime uten tid i sekunder</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Vegg</translation>
    </message>
    <message>
        <source>Nominal layer height; limited by the process.</source>
        <translation>Nominell laghøyde; begrenset av prosessen.</translation>
    </message>
    <message>
        <source>Nominal bead width; limited by the process.</source>
        <translation>Nominell strengbredde; begrenset av prosessen.</translation>
    </message>
    <message>
        <source>The axis of the part that is aligned with the rod. auto: the axis parallel to its sides.</source>
        <translation>Aksen i delen som rettes inn etter stangen. auto: aksen som er parallell med sidene.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Voxel width used for growth; the layer height is independent of it.</source>
        <translation>Vokselbredden som brukes for veksten; laghøyden er uavhengig av den.</translation>
    </message>
    <message>
        <source>an arc from a position that is not known</source>
        <translation>en bue fra en ukjent posisjon</translation>
    </message>
    <message>
        <source>an arc that changes its height is not understood</source>
        <translation>en bue som endrer høyde, støttes ikke</translation>
    </message>
    <message>
        <source>an arc without its centre, I and J</source>
        <translation>en bue uten sentrum, I og J</translation>
    </message>
    <message>
        <source>arc fitting</source>
        <translation>buetilpasning</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for, or slice it with beads of this process</source>
        <translation>velg prosessen som filen ble slicet for, eller slice den med strenger for denne prosessen</translation>
    </message>
    <message>
        <source>movec needs two poses</source>
        <translation>movec krever to positurer</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>oppløsning</translation>
    </message>
    <message>
        <source>the end of an arc is not at the distance of its start from the centre</source>
        <translation>slutten på en bue har ikke samme avstand fra sentrum som starten</translation>
    </message>
    <message>
        <source>the file heats {heat}: programs heat as the material states, choose one that fits</source>
        <translation>filen varmer til {heat}: programmer varmer som materialet angir, velg et som passer</translation>
    </message>
    <message>
        <source>the three points of an arc are on a line</source>
        <translation>de tre punktene i en bue ligger på en linje</translation>
    </message>
    <message>
        <source>unknown G command</source>
        <translation>ukjent G-kommando</translation>
    </message>
    <message>
        <source>a PLY file begins with &quot;ply&quot;</source>
        <translation>en PLY-fil begynner med &quot;ply&quot;</translation>
    </message>
    <message>
        <source>a call of a module that is not loaded</source>
        <translation>et kall til en modul som ikke er lastet</translation>
    </message>
    <message>
        <source>support column of {voxels} from {foot}: it carries {carried} that would be missed</source>
        <translation>støttesøyle av {voxels} fra {foot}: den bærer {carried} som ellers ville gå tapt</translation>
    </message>
    <message>
        <source>a configuration that is not in whole quarter turns</source>
        <translation>en konfigurasjon som ikke er i hele kvarte omdreininger</translation>
    </message>
    <message>
        <source>a digital output must be 0 or 1</source>
        <translation>en digital utgang må være 0 eller 1</translation>
    </message>
    <message>
        <source>a direction needs nX, nY and nZ</source>
        <translation>en retning krever nX, nY og nZ</translation>
    </message>
    <message>
        <source>a direction is not a unit vector</source>
        <translation>en retning er ikke en enhetsvektor</translation>
    </message>
    <message>
        <source>a face refers to vertex {vertex} of {vertices}</source>
        <translation>en flate viser til hjørnepunkt {vertex} av {vertices}</translation>
    </message>
    <message>
        <source>a face needs its number of corners, then the corners</source>
        <translation>en flate krever antall hjørner, deretter hjørnene</translation>
    </message>
    <message>
        <source>a face needs at least three corners</source>
        <translation>en flate krever minst tre hjørner</translation>
    </message>
    <message>
        <source>a facet with fewer than three vertices</source>
        <translation>en fasett med færre enn tre hjørnepunkter</translation>
    </message>
    <message>
        <source>flow of {flow:.1f}, above the extruder&apos;s limit of {limit:.1f#}</source>
        <translation>materialstrøm på {flow:.1f}, over ekstruderens grense på {limit:.1f#}</translation>
    </message>
    <message>
        <source>a joint value far outside any limit</source>
        <translation>en leddverdi langt utenfor enhver grense</translation>
    </message>
    <message>
        <source>use a larger platform, or turn the part</source>
        <translation>bruk en større plattform, eller roter delen</translation>
    </message>
    <message>
        <source>use a larger platform or supports, or join this piece to the part</source>
        <translation>bruk en større plattform eller støtter, eller føy dette stykket til delen</translation>
    </message>
    <message>
        <source>a line does not end with CR LF</source>
        <translation>en linje slutter ikke med CR LF</translation>
    </message>
    <message>
        <source>a line without a command</source>
        <translation>en linje uten kommando</translation>
    </message>
    <message>
        <source>a list has an invalid length</source>
        <translation>en liste har ugyldig lengde</translation>
    </message>
    <message>
        <source>triangles with missing vertices</source>
        <translation>trekanter med manglende hjørnepunkter</translation>
    </message>
    <message>
        <source>a module must begin with MODULE and its name</source>
        <translation>en modul må begynne med MODULE og navnet sitt</translation>
    </message>
    <message>
        <source>a motion before X, Y and Z are all known</source>
        <translation>en bevegelse før X, Y og Z alle er kjent</translation>
    </message>
    <message>
        <source>a motion before any speed (F)</source>
        <translation>en bevegelse før noen hastighet (F)</translation>
    </message>
    <message>
        <source>the motion never arrives: no speed or acceleration</source>
        <translation>bevegelsen når aldri fram: ingen hastighet eller akselerasjon</translation>
    </message>
    <message>
        <source>a motion with a word {letter} is not understood</source>
        <translation>en bevegelse med ordet {letter} støttes ikke</translation>
    </message>
    <message>
        <source>a motion without a target</source>
        <translation>en bevegelse uten mål</translation>
    </message>
    <message>
        <source>a name is declared twice</source>
        <translation>et navn er deklarert to ganger</translation>
    </message>
    <message>
        <source>use a narrower bead or a lower layer height for fine detail, supports for areas that begin in the air</source>
        <translation>bruk en smalere streng eller lavere laghøyde for fine detaljer, støtter for områder som begynner i løse luften</translation>
    </message>
    <message>
        <source>a picture of {width} x {height} pixels cannot be drawn</source>
        <translation>et bilde på {width} x {height} piksler kan ikke tegnes</translation>
    </message>
    <message>
        <source>a platform must be a mesh, not a voxel object</source>
        <translation>en plattform må være en mesh, ikke et vokselobjekt</translation>
    </message>
    <message>
        <source>a point has NaN or infinite coordinates</source>
        <translation>et punkt har NaN eller uendelige koordinater</translation>
    </message>
    <message>
        <source>a point needs three numbers</source>
        <translation>et punkt krever tre tall</translation>
    </message>
    <message>
        <source>point too far from the origin</source>
        <translation>punkt for langt fra origo</translation>
    </message>
    <message>
        <source>a pose before set_tcp: its TCP is unknown</source>
        <translation>en positur før set_tcp: TCP-en er ukjent</translation>
    </message>
    <message>
        <source>a pose far outside any robot&apos;s reach</source>
        <translation>en positur langt utenfor enhver robots rekkevidde</translation>
    </message>
    <message>
        <source>a pose p[x,y,z,rx,ry,rz] is needed</source>
        <translation>en positur p[x,y,z,rx,ry,rz] kreves</translation>
    </message>
    <message>
        <source>a position far outside any robot&apos;s reach</source>
        <translation>en posisjon langt utenfor enhver robots rekkevidde</translation>
    </message>
    <message>
        <source>a property of unknown type</source>
        <translation>en egenskap av ukjent type</translation>
    </message>
    <message>
        <source>a quadrilateral cannot cut a part</source>
        <translation>en firkant kan ikke kutte en del</translation>
    </message>
    <message>
        <source>a quadrilateral needs four corners</source>
        <translation>en firkant krever fire hjørner</translation>
    </message>
    <message>
        <source>a quaternion that is not normalised</source>
        <translation>en kvaternion som ikke er normalisert</translation>
    </message>
    <message>
        <source>a rod is round or has at least three sides</source>
        <translation>en stang er rund eller har minst tre sider</translation>
    </message>
    <message>
        <source>a rod needs at least two points</source>
        <translation>en stang krever minst to punkter</translation>
    </message>
    <message>
        <source>row beyond the end of its array</source>
        <translation>rad utenfor slutten av tabellen</translation>
    </message>
    <message>
        <source>a second, different TCP</source>
        <translation>en annen, avvikende TCP</translation>
    </message>
    <message>
        <source>a second, different tool</source>
        <translation>et annet, avvikende verktøy</translation>
    </message>
    <message>
        <source>a shifted origin is not understood</source>
        <translation>et forskjøvet origo støttes ikke</translation>
    </message>
    <message>
        <source>a space</source>
        <translation>et mellomrom</translation>
    </message>
    <message>
        <source>an invalid speed</source>
        <translation>en ugyldig hastighet</translation>
    </message>
    <message>
        <source>a speed that is not positive</source>
        <translation>en hastighet som ikke er positiv</translation>
    </message>
    <message>
        <source>a statement outside the procedure</source>
        <translation>en setning utenfor prosedyren</translation>
    </message>
    <message>
        <source>a step at the end of the rod</source>
        <translation>et trinn ved enden av stangen</translation>
    </message>
    <message>
        <source>target with fewer than six joints</source>
        <translation>mål med færre enn seks ledd</translation>
    </message>
    <message>
        <source>an invalid time</source>
        <translation>en ugyldig tid</translation>
    </message>
    <message>
        <source>a transform does not have twelve numbers</source>
        <translation>en transformasjon har ikke tolv tall</translation>
    </message>
    <message>
        <source>a transform contains a value that is not a number</source>
        <translation>en transformasjon inneholder en verdi som ikke er et tall</translation>
    </message>
    <message>
        <source>a triangle refers to the missing vertex {vertex}</source>
        <translation>en trekant viser til hjørnepunkt {vertex}, som mangler</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>et hjørnepunkt krever tre tall</translation>
    </message>
    <message>
        <source>use a voxel width of at most {fits}</source>
        <translation>bruk en vokselbredde på høyst {fits}</translation>
    </message>
    <message>
        <source>wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}</source>
        <translation>vegg med tykkelse {usual:.2f} ({thinnest:.2f} på det tynneste), tynnere enn en voksel på {voxel}</translation>
    </message>
    <message>
        <source>a waypoint number has to be an integer of at least -1</source>
        <translation>et banepunktnummer må være et heltall på minst -1</translation>
    </message>
    <message>
        <source>a work object must name the mechanical unit that moves it, or be stationary</source>
        <translation>et arbeidsobjekt må angi den mekaniske enheten som beveger det, eller stå stille</translation>
    </message>
    <message>
        <source>an invalid zone</source>
        <translation>en ugyldig sone</translation>
    </message>
    <message>
        <source>a zone for orientation or external axes smaller than the TCP&apos;s</source>
        <translation>en sone for orientering eller eksterne akser som er mindre enn TCP-ens</translation>
    </message>
    <message>
        <source>a {type} must have other components</source>
        <translation>en {type} må ha andre komponenter</translation>
    </message>
    <message>
        <source>adaptive layers</source>
        <translation>adaptive lag</translation>
    </message>
    <message>
        <source>add a row of - under the part, where it should be placed</source>
        <translation>legg til en rad med - under delen, der den skal plasseres</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), cut there, or use curved mode</source>
        <translation>legg til støtter (`supports=auto`), kutt der, eller bruk modus curved</translation>
    </message>
    <message>
        <source>along</source>
        <translation>langs</translation>
    </message>
    <message>
        <source>unknown M command</source>
        <translation>ukjent M-kommando</translation>
    </message>
    <message>
        <source>an OFF file begins with &quot;OFF&quot;</source>
        <translation>en OFF-fil begynner med &quot;OFF&quot;</translation>
    </message>
    <message>
        <source>an analogue output outside 0..1</source>
        <translation>en analog utgang utenfor 0..1</translation>
    </message>
    <message>
        <source>an argument of {name} is unknown or given twice</source>
        <translation>et argument til {name} er ukjent eller oppgitt to ganger</translation>
    </message>
    <message>
        <source>an element needs its count</source>
        <translation>et element krever antallet sitt</translation>
    </message>
    <message>
        <source>an external axis far outside any limit</source>
        <translation>en ekstern akse langt utenfor enhver grense</translation>
    </message>
    <message>
        <source>an external axis that moves no work object is not supported</source>
        <translation>en ekstern akse som ikke beveger noe arbeidsobjekt, støttes ikke</translation>
    </message>
    <message>
        <source>an output needs a number and a value</source>
        <translation>en utgang krever et nummer og en verdi</translation>
    </message>
    <message>
        <source>an unknown PLY format</source>
        <translation>et ukjent PLY-format</translation>
    </message>
    <message>
        <source>an unknown line in the header</source>
        <translation>en ukjent linje i filhodet</translation>
    </message>
    <message>
        <source>further defects from here on are not listed</source>
        <translation>flere feil fra dette punktet listes ikke opp</translation>
    </message>
    <message numerus="yes">
        <source>{count} more collisions</source>
        <translation>
            <numerusform>én kollisjon til</numerusform>
            <numerusform>{count} kollisjoner til</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more violations</source>
        <translation>
            <numerusform>ett brudd til</numerusform>
            <numerusform>{count} brudd til</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more waypoints, the first: {what}</source>
        <translation>
            <numerusform>ett banepunkt til: {what}</numerusform>
            <numerusform>{count} banepunkter til, det første: {what}</numerusform>
        </translation>
    </message>
    <message>
        <source>{length:.0f} of the file&apos;s beads are outside the limits of process {process} (width {widthMin:.3g} to {widthMax:.3g}, height {heightMin:.3g} to {heightMax:.3g}): the worst is {width:.2f} wide and {height:.2f} high</source>
        <translation>{length:.0f} av filens strenger er utenfor grensene for prosessen {process} (bredde {widthMin:.3g} til {widthMax:.3g}, høyde {heightMin:.3g} til {heightMax:.3g}): den verste er {width:.2f} bred og {height:.2f} høy</translation>
    </message>
    <message numerus="yes">
        <source>{what}; {more} more voxels depend on this</source>
        <translation>
            <numerusform>{what}; én voksel til avhenger av dette</numerusform>
            <numerusform>{what}; {more} voksler til avhenger av dette</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part or add supports</source>
        <translation>roter delen eller legg til støtter</translation>
    </message>
    <message>
        <source>another column</source>
        <translation>en annen søyle</translation>
    </message>
    <message>
        <source>argument {key} is not a valid number</source>
        <translation>argumentet {key} er ikke et gyldig tall</translation>
    </message>
    <message>
        <source>around</source>
        <translation>rundt</translation>
    </message>
    <message>
        <source>at {point:.1f}</source>
        <translation>ved {point:.1f}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>akse</translation>
    </message>
    <message>
        <source>part axis</source>
        <translation>delens akse</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>strengbredde</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>strålesøk</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; of the job file is damaged</source>
        <translation>blokken &apos;{name}&apos; i jobbfilen er skadet</translation>
    </message>
    <message>
        <source>break it off after printing</source>
        <translation>brekk den av etter printing</translation>
    </message>
    <message>
        <source>broken precondition: {what}</source>
        <translation>brutt forutsetning: {what}</translation>
    </message>
    <message>
        <source>byte {code}</source>
        <translation>byte {code}</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>kan ikke leses til slutten</translation>
    </message>
    <message>
        <source>cannot be read: {why}</source>
        <translation>kan ikke leses: {why}</translation>
    </message>
    <message>
        <source>cannot be written: {why}</source>
        <translation>kan ikke skrives: {why}</translation>
    </message>
    <message>
        <source>cell {cell}</source>
        <translation>celle {cell}</translation>
    </message>
    <message>
        <source>cell {cell} has a rod, but mode {mode} prints on a plate</source>
        <translation>cellen {cell} har en stang, men modus {mode} printer på en byggeplate</translation>
    </message>
    <message>
        <source>cell {id} has no rod to print on</source>
        <translation>cellen {id} har ingen stang å printe på</translation>
    </message>
    <message>
        <source>layer centre</source>
        <translation>lagsentrum</translation>
    </message>
    <message>
        <source>check the flow and the infill density</source>
        <translation>kontroller materialstrømmen og fylltettheten</translation>
    </message>
    <message>
        <source>checking layers</source>
        <translation>kontrollerer lag</translation>
    </message>
    <message>
        <source>checking the motion</source>
        <translation>kontrollerer bevegelsen</translation>
    </message>
    <message>
        <source>choose a smaller `voxelMm` or `beadWidthMm`</source>
        <translation>velg mindre `voxelMm` eller `beadWidthMm`</translation>
    </message>
    <message>
        <source>choose layers that reach all of it (`layerShape`, `layerCentre`, `endSurface`)</source>
        <translation>velg lag som når hele den (`layerShape`, `layerCentre`, `endSurface`)</translation>
    </message>
    <message>
        <source>choose {least} to {most} pixels per side</source>
        <translation>velg {least} til {most} piksler per side</translation>
    </message>
    <message>
        <source>arm clearance</source>
        <translation>armklaring</translation>
    </message>
    <message>
        <source>clearance to the part</source>
        <translation>klaring til delen</translation>
    </message>
    <message numerus="yes">
        <source>closed {count} holes, the largest of {edges} edges at {at:.2f}</source>
        <translation>
            <numerusform>lukket {count} hull, med {edges} kanter ved {at:.2f}</numerusform>
            <numerusform>lukket {count} hull, det største med {edges} kanter ved {at:.2f}</numerusform>
        </translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>kollisjoner</translation>
    </message>
    <message>
        <source>comparing with the plan</source>
        <translation>sammenligner med planen</translation>
    </message>
    <message>
        <source>concentric</source>
        <translation>konsentrisk</translation>
    </message>
    <message>
        <source>contact area + {sizes} mm</source>
        <translation>kontaktflate + {sizes} mm</translation>
    </message>
    <message numerus="yes">
        <source>cut it off after printing: it touches the part at {faces} more faces</source>
        <translation>
            <numerusform>skjær den av etter printing: den berører delen på én flate til</numerusform>
            <numerusform>skjær den av etter printing: den berører delen på {faces} flater til</numerusform>
        </translation>
    </message>
    <message>
        <source>truncated</source>
        <translation>avkortet</translation>
    </message>
    <message>
        <source>truncated within a facet</source>
        <translation>avkortet inne i en fasett</translation>
    </message>
    <message>
        <source>truncated, or not a mesh: {what}</source>
        <translation>avkortet, eller ikke en mesh: {what}</translation>
    </message>
    <message>
        <source>truncated: {bytes} bytes are too few for an STL file</source>
        <translation>avkortet: {bytes} byte er for lite for en STL-fil</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} faces</source>
        <translation>avkortet: {there} av {wanted} flater</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} vertices</source>
        <translation>avkortet: {there} av {wanted} hjørnepunkter</translation>
    </message>
    <message>
        <source>cut {number}</source>
        <translation>kutt {number}</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>kutter</translation>
    </message>
    <message>
        <source>cutting layers</source>
        <translation>skjærer lag</translation>
    </message>
    <message>
        <source>cutting layers from the field</source>
        <translation>skjærer lag fra feltet</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>snittplan</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>sylinder</translation>
    </message>
    <message>
        <source>damaged STL: {what}</source>
        <translation>skadet STL: {what}</translation>
    </message>
    <message>
        <source>data of the type {type} is not known to the reader</source>
        <translation>data av typen {type} er ukjent for leseren</translation>
    </message>
    <message>
        <source>did you mean &apos;{name}&apos;?</source>
        <translation>mente du &apos;{name}&apos;?</translation>
    </message>
    <message>
        <source>did you mean {name}?</source>
        <translation>mente du {name}?</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>retninger</translation>
    </message>
    <message>
        <source>disc, {sizes} mm</source>
        <translation>skive, {sizes} mm</translation>
    </message>
    <message>
        <source>is {height} by default, more than the default of beadWidthMm, {width}: beads are no higher than wide</source>
        <translation>er {height} som standard, mer enn standardverdien for beadWidthMm, {width}: strenger er ikke høyere enn brede</translation>
    </message>
    <message>
        <source>is {tolerance}, not less than the maximum of layerHeightMm, {height}: the head would pass through a layer</source>
        <translation>er {tolerance}, ikke mindre enn maksimum for layerHeightMm, {height}: hodet ville gå gjennom et lag</translation>
    </message>
    <message>
        <source>is {most:.3g} mm3/s, less than the smallest bead needs at speedMmPerS, {flow:.3g} mm3/s</source>
        <translation>er {most:.3g} mm3/s, mindre enn den minste strengen trenger ved speedMmPerS, {flow:.3g} mm3/s</translation>
    </message>
    <message>
        <source>does not rise from z = 0</source>
        <translation>stiger ikke fra z = 0</translation>
    </message>
    <message>
        <source>drop it to the plate</source>
        <translation>senk den til byggeplaten</translation>
    </message>
    <message>
        <source>drop it to the plate, or choose a platform below it</source>
        <translation>senk den til byggeplaten, eller velg en plattform under den</translation>
    </message>
    <message>
        <source>move the part down to the plate</source>
        <translation>flytt delen ned til byggeplaten</translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} duplicate triangles</source>
        <translation>
            <numerusform>fjernet {count} dobbel trekant</numerusform>
            <numerusform>fjernet {count} doble trekanter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles of sheets without volume</source>
        <translation>
            <numerusform>fjernet {count} trekant i flak uten volum</numerusform>
            <numerusform>fjernet {count} trekanter i flak uten volum</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles without area</source>
        <translation>
            <numerusform>fjernet {count} trekant uten areal</numerusform>
            <numerusform>fjernet {count} trekanter uten areal</numerusform>
        </translation>
    </message>
    <message>
        <source>eax_a is missing: an external axis moves the work object</source>
        <translation>eax_a mangler: en ekstern akse beveger arbeidsobjektet</translation>
    </message>
    <message>
        <source>end surface</source>
        <translation>sluttflate</translation>
    </message>
    <message>
        <source>`endSurface` &apos;{text}&apos; is not an end surface</source>
        <translation>`endSurface` &apos;{text}&apos; er ikke en sluttflate</translation>
    </message>
    <message>
        <source>`endSurface` mesh:FILE requires a platform that is a body</source>
        <translation>`endSurface` mesh:FILE krever en plattform som er et legeme</translation>
    </message>
    <message>
        <source>ending layers on the surface</source>
        <translation>avslutter lag på overflaten</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>eksporter eller kopier filen på nytt</translation>
    </message>
    <message>
        <source>the extruded volume decreases</source>
        <translation>det ekstruderte volumet avtar</translation>
    </message>
    <message>
        <source>fewest missed voxels</source>
        <translation>færrest tapte voksler</translation>
    </message>
    <message>
        <source>field</source>
        <translation>felt</translation>
    </message>
    <message>
        <source>file {file}, line {line}</source>
        <translation>fil {file}, linje {line}</translation>
    </message>
    <message>
        <source>file {file}, line {line}: {what}</source>
        <translation>fil {file}, linje {line}: {what}</translation>
    </message>
    <message>
        <source>fill the hollow first, or use `layerShape=offset`</source>
        <translation>fyll hulrommet først, eller bruk `layerShape=offset`</translation>
    </message>
    <message>
        <source>first layer</source>
        <translation>første lag</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flat</translation>
    </message>
    <message>
        <source>flatten</source>
        <translation>flat ut</translation>
    </message>
    <message>
        <source>flattening</source>
        <translation>utflating</translation>
    </message>
    <message>
        <source>front</source>
        <translation>front</translation>
    </message>
    <message>
        <source>give `--cell lathe`</source>
        <translation>oppgi `--cell lathe`</translation>
    </message>
    <message>
        <source>give `--mode {modes}`, or another cell</source>
        <translation>oppgi `--mode {modes}`, eller en annen celle</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`</source>
        <translation>oppgi `--platform {platforms}`</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`, or `endSurface` flat:Z</source>
        <translation>oppgi `--platform {platforms}`, eller `endSurface` flat:Z</translation>
    </message>
    <message>
        <source>give 0, or {least#} to {most}</source>
        <translation>oppgi 0, eller {least#} til {most}</translation>
    </message>
    <message>
        <source>choose a higher end surface (`endSurface`)</source>
        <translation>velg en høyere sluttflate (`endSurface`)</translation>
    </message>
    <message>
        <source>give a list of {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} or {&quot;corners&quot;: [four points]}, in mm</source>
        <translation>oppgi en liste med {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} eller {&quot;corners&quot;: [four points]}, i mm</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>oppgi et tall</translation>
    </message>
    <message>
        <source>give a number from 0.0001 to 10000, or fit</source>
        <translation>oppgi et tall fra 0.0001 til 10000, eller fit</translation>
    </message>
    <message>
        <source>give all slices the same number of rows</source>
        <translation>gi alle skiver samme antall rader</translation>
    </message>
    <message>
        <source>give an STL, OBJ, PLY, OFF or 3MF file</source>
        <translation>oppgi en STL-, OBJ-, PLY-, OFF- eller 3MF-fil</translation>
    </message>
    <message>
        <source>choose an end surface over the part&apos;s foot</source>
        <translation>velg en sluttflate over delens fot</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a narrower part</source>
        <translation>velg en sluttflate med mer lik form, eller en smalere del</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a smaller part</source>
        <translation>velg en sluttflate med mer lik form, eller en mindre del</translation>
    </message>
    <message>
        <source>give `endSurface=flat:Z` or mesh:FILE</source>
        <translation>oppgi `endSurface=flat:Z` eller mesh:FILE</translation>
    </message>
    <message>
        <source>give `orient=none`</source>
        <translation>oppgi `orient=none`</translation>
    </message>
    <message>
        <source>use other cutting planes (`cutPlanes`), turn the part, or use curved mode</source>
        <translation>bruk andre snittplan (`cutPlanes`), roter delen, eller bruk modus curved</translation>
    </message>
    <message>
        <source>give pairs of x and radius in mm, x ascending</source>
        <translation>oppgi par av x og radius i mm, x stigende</translation>
    </message>
    <message>
        <source>give planes: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</source>
        <translation>oppgi plan: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</translation>
    </message>
    <message>
        <source>verify it against the job it was written from</source>
        <translation>verifiser det mot jobben det ble skrevet fra</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>oppgi true eller false</translation>
    </message>
    <message>
        <source>give {field} from {least#} to {most}</source>
        <translation>oppgi {field} fra {least#} til {most}</translation>
    </message>
    <message>
        <source>give {forms}</source>
        <translation>oppgi {forms}</translation>
    </message>
    <message>
        <source>give {key}=NUMBER, 0 or more</source>
        <translation>oppgi {key}=TALL, 0 eller mer</translation>
    </message>
    <message>
        <source>give {least#} to {most}</source>
        <translation>oppgi {least#} til {most}</translation>
    </message>
    <message>
        <source>give {least} to {most}</source>
        <translation>oppgi {least} til {most}</translation>
    </message>
    <message>
        <source>give {least} to {most} {unit}</source>
        <translation>oppgi {least} til {most} {unit}</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>grådig</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>vekst</translation>
    </message>
    <message>
        <source>must have minDeg below maxDeg</source>
        <translation>må ha minDeg under maxDeg</translation>
    </message>
    <message>
        <source>must not have zero length</source>
        <translation>må ikke ha lengde null</translation>
    </message>
    <message>
        <source>head</source>
        <translation>hode</translation>
    </message>
    <message>
        <source>helical</source>
        <translation>helisk</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>holder</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>tommer</translation>
    </message>
    <message>
        <source>inches are not understood</source>
        <translation>tommer støttes ikke</translation>
    </message>
    <message>
        <source>infill</source>
        <translation>fyll</translation>
    </message>
    <message>
        <source>infill &apos;{infill}&apos; needs an axis to wind around, but layer {layer} has none</source>
        <translation>fyllet &apos;{infill}&apos; trenger en akse å gå rundt, men lag {layer} har ingen</translation>
    </message>
    <message>
        <source>infill density</source>
        <translation>fylltetthet</translation>
    </message>
    <message>
        <source>infill direction</source>
        <translation>fyllretning</translation>
    </message>
    <message>
        <source>install Mesa (libegl1, libgl1-mesa-dri)</source>
        <translation>installer Mesa (libegl1, libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>is &apos;{id}&apos;, but the file is named &apos;{file}&apos;</source>
        <translation>er &apos;{id}&apos;, men filen heter &apos;{file}&apos;</translation>
    </message>
    <message>
        <source>is a directory, not a file</source>
        <translation>er en mappe, ikke en fil</translation>
    </message>
    <message>
        <source>is truncated</source>
        <translation>er avkortet</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>er skadet</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>er kryptert</translation>
    </message>
    <message>
        <source>is larger than 1 GB</source>
        <translation>er større enn 1 GB</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>mangler</translation>
    </message>
    <message>
        <source>is outside the joint&apos;s limits</source>
        <translation>er utenfor leddets grenser</translation>
    </message>
    <message>
        <source>is compressed with an unsupported method</source>
        <translation>er komprimert med en metode som ikke støttes</translation>
    </message>
    <message>
        <source>is already used: &apos;{name}&apos;</source>
        <translation>er allerede i bruk: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>it is a file, not a folder</source>
        <translation>det er en fil, ikke en mappe</translation>
    </message>
    <message>
        <source>two blends overlap, {blend:.3f} in all on a motion of {way:.3f}: the controller skips the waypoint</source>
        <translation>to overganger overlapper, {blend:.3f} til sammen på en bevegelse på {way:.3f}: styringen hopper over banepunktet</translation>
    </message>
    <message>
        <source>joint {number}</source>
        <translation>ledd {number}</translation>
    </message>
    <message>
        <source>place the part on a larger face, or use other cutting planes (`cutPlanes`)</source>
        <translation>plasser delen på en større flate, eller bruk andre snittplan (`cutPlanes`)</translation>
    </message>
    <message>
        <source>layer height</source>
        <translation>laghøyde</translation>
    </message>
    <message>
        <source>layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</source>
        <translation>lag {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</translation>
    </message>
    <message>
        <source>`layerCentre` &apos;{text}&apos; is not a point</source>
        <translation>`layerCentre` &apos;{text}&apos; er ikke et punkt</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>lag</translation>
    </message>
    <message>
        <source>layers are 1 to {count}</source>
        <translation>lagene er 1 til {count}</translation>
    </message>
    <message>
        <source>layers around the rod</source>
        <translation>lag rundt stangen</translation>
    </message>
    <message>
        <source>layers on this surface would fold from layer {layer} on: its normals cross before the end surface</source>
        <translation>lag på denne overflaten ville folde seg fra og med lag {layer}: normalene krysser hverandre før sluttflaten</translation>
    </message>
    <message>
        <source>depositing beads</source>
        <translation>legger strenger</translation>
    </message>
    <message>
        <source>minimum overhang</source>
        <translation>minst overheng</translation>
    </message>
    <message>
        <source>least overhang of pieces</source>
        <translation>minst overheng for stykkene</translation>
    </message>
    <message>
        <source>least residual area</source>
        <translation>minst restareal</translation>
    </message>
    <message>
        <source>leaves a piece without a base</source>
        <translation>etterlater et stykke uten underlag</translation>
    </message>
    <message>
        <source>leaves a piece only {thickness:.2g} thick, thinner than a bead ({least})</source>
        <translation>etterlater et stykke som bare er {thickness:.2g} tykt, tynnere enn en streng ({least})</translation>
    </message>
    <message>
        <source>omitted: {what}</source>
        <translation>utelatt: {what}</translation>
    </message>
    <message>
        <source>left to the controller</source>
        <translation>overlatt til styringen</translation>
    </message>
    <message>
        <source>lengths taken as mm: unknown unit &apos;{unit}&apos;</source>
        <translation>lengder tolket som mm: ukjent enhet &apos;{unit}&apos;</translation>
    </message>
    <message>
        <source>lengths converted from {unit} to mm</source>
        <translation>lengder regnet om fra {unit} til mm</translation>
    </message>
    <message>
        <source>reduce the flow, or space the beads further apart</source>
        <translation>reduser materialstrømmen, eller legg strengene lenger fra hverandre</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the rod there</source>
        <translation>gi delen en slakere skråning fra stangen der</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the surface there</source>
        <translation>gi delen en slakere skråning fra overflaten der</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>løft</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>grense</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>linje {line}</translation>
    </message>
    <message>
        <source>line {line}: {what}</source>
        <translation>linje {line}: {what}</translation>
    </message>
    <message>
        <source>load</source>
        <translation>innlasting</translation>
    </message>
    <message>
        <source>longest side {longest:.4g}: the file may be in {unit} (scale {scale})</source>
        <translation>lengste side {longest:.4g}: filen er kanskje i {unit} (skala {scale})</translation>
    </message>
    <message>
        <source>checking support below the beads</source>
        <translation>kontrollerer støtte under strengene</translation>
    </message>
    <message>
        <source>checking for collisions</source>
        <translation>kontrollerer kollisjoner</translation>
    </message>
    <message>
        <source>saved by a newer version of Voluta (format {format}; this version reads up to {newest})</source>
        <translation>lagret av en nyere versjon av Voluta (format {format}; denne versjonen leser opp til {newest})</translation>
    </message>
    <message>
        <source>make all rows equally long</source>
        <translation>gjør alle rader like lange</translation>
    </message>
    <message>
        <source>make the feature narrower</source>
        <translation>gjør detaljen smalere</translation>
    </message>
    <message>
        <source>make the object from fewer and larger cells</source>
        <translation>lag objektet av færre og større celler</translation>
    </message>
    <message>
        <source>make the part narrower, or use `layerShape=offset`</source>
        <translation>gjør delen smalere, eller bruk `layerShape=offset`</translation>
    </message>
    <message>
        <source>piece materials</source>
        <translation>stykkematerialer</translation>
    </message>
    <message>
        <source>measuring the beads</source>
        <translation>måler strengene</translation>
    </message>
    <message>
        <source>repair it in a modelling program</source>
        <translation>reparer den i et modelleringsprogram</translation>
    </message>
    <message>
        <source>repair the mesh in a modelling program if the result looks wrong</source>
        <translation>reparer meshen i et modelleringsprogram hvis resultatet ser feil ut</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} duplicate points</source>
        <translation>
            <numerusform>slo sammen {count} dobbelt punkt</numerusform>
            <numerusform>slo sammen {count} doble punkter</numerusform>
        </translation>
    </message>
    <message>
        <source>metres</source>
        <translation>meter</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>mikrometer</translation>
    </message>
    <message>
        <source>missed voxels</source>
        <translation>tapte voksler</translation>
    </message>
    <message>
        <source>mode {mode} does not print on platform {platform}</source>
        <translation>modus {mode} printer ikke på plattformen {platform}</translation>
    </message>
    <message>
        <source>mode {mode} prints around a rod, but cell {cell} has none</source>
        <translation>modus {mode} printer rundt en stang, men cellen {cell} har ingen</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>bevegelse</translation>
    </message>
    <message>
        <source>move it so that it crosses the part</source>
        <translation>flytt det slik at det krysser delen</translation>
    </message>
    <message>
        <source>move or tilt the plane slightly</source>
        <translation>flytt eller tilt planet litt</translation>
    </message>
    <message>
        <source>move the part along the rod, or use a longer rod</source>
        <translation>flytt delen langs stangen, eller bruk en lengre stang</translation>
    </message>
    <message>
        <source>move the part on the rod, or extend it down to the rod there</source>
        <translation>flytt delen på stangen, eller forleng den ned til stangen der</translation>
    </message>
    <message>
        <source>move the part on the surface, or extend it down to the surface there</source>
        <translation>flytt delen på overflaten, eller forleng den ned til overflaten der</translation>
    </message>
    <message>
        <source>move the part onto the rod</source>
        <translation>flytt delen inn på stangen</translation>
    </message>
    <message>
        <source>move the part onto the surface</source>
        <translation>flytt delen inn på overflaten</translation>
    </message>
    <message>
        <source>move the part out of the surface, or print it larger</source>
        <translation>flytt delen ut av overflaten, eller print den større</translation>
    </message>
    <message>
        <source>move the plane or remove it</source>
        <translation>flytt planet eller fjern det</translation>
    </message>
    <message>
        <source>move the plane, or point its normal to the side to cut off</source>
        <translation>flytt planet, eller rett normalen mot siden som skal kuttes av</translation>
    </message>
    <message>
        <source>move the planes, or add planes between them</source>
        <translation>flytt planene, eller legg til plan mellom dem</translation>
    </message>
    <message>
        <source>move or remove them</source>
        <translation>flytt eller fjern dem</translation>
    </message>
    <message>
        <source>must be a capsule, a box or a frustum</source>
        <translation>må være en kapsel, en boks eller en avkortet kjegle</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>må være et endelig tall</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>må være en liste</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>må være et tall</translation>
    </message>
    <message>
        <source>must be a pair of height and radius</source>
        <translation>må være et par av høyde og radius</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>må være en tekst</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>må være et heltall</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>må være et objekt</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>må være større enn 0</translation>
    </message>
    <message>
        <source>must be in 0..{dof}</source>
        <translation>må være i 0..{dof}</translation>
    </message>
    <message>
        <source>must be greater than the rod&apos;s radius</source>
        <translation>må være større enn stangens radius</translation>
    </message>
    <message>
        <source>must be unwinds or runsOn, is &apos;{end}&apos;</source>
        <translation>må være unwinds eller runsOn, er &apos;{end}&apos;</translation>
    </message>
    <message>
        <source>must be world or flange, is &apos;{mount}&apos;</source>
        <translation>må være world eller flange, er &apos;{mount}&apos;</translation>
    </message>
    <message>
        <source>must be world: a rod is held at both ends</source>
        <translation>må være world: en stang holdes i begge ender</translation>
    </message>
    <message>
        <source>must include the home position 0 in its limits</source>
        <translation>må ha hjemposisjonen 0 innenfor grensene</translation>
    </message>
    <message>
        <source>must have three numbers</source>
        <translation>må ha tre tall</translation>
    </message>
    <message>
        <source>must have two names</source>
        <translation>må ha to navn</translation>
    </message>
    <message>
        <source>must have at least two sections</source>
        <translation>må ha minst to tverrsnitt</translation>
    </message>
    <message>
        <source>must have 6 joints, has {found}</source>
        <translation>må ha 6 ledd, har {found}</translation>
    </message>
    <message>
        <source>must have at least one shape</source>
        <translation>må ha minst én form</translation>
    </message>
    <message>
        <source>must have exactly one axis, which turns the rod</source>
        <translation>må ha nøyaktig én akse, som dreier stangen</translation>
    </message>
    <message>
        <source>must have {wanted} joints, has {found}</source>
        <translation>må ha {wanted} ledd, har {found}</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>må ikke være 0</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>må ikke være negativ</translation>
    </message>
    <message>
        <source>must differ from the nozzle&apos;s: one of them moves, the other is fixed</source>
        <translation>må være ulik dysens: en av dem beveger seg, den andre står fast</translation>
    </message>
    <message>
        <source>set its axis (`rodAxis`), or rotate the part onto the rod manually</source>
        <translation>angi aksen (`rodAxis`), eller roter delen på stangen manuelt</translation>
    </message>
    <message>
        <source>names an unknown body: &apos;{name}&apos;; did you mean &apos;{nearest}&apos;?</source>
        <translation>angir et ukjent legeme: &apos;{name}&apos;; mente du &apos;{nearest}&apos;?</translation>
    </message>
    <message>
        <source>names an unknown kinematic family: &apos;{id}&apos;</source>
        <translation>angir en ukjent kinematisk familie: &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>names no model</source>
        <translation>angir ingen modell</translation>
    </message>
    <message>
        <source>needs radii that are not negative, one of them greater than 0</source>
        <translation>krever radier som ikke er negative, og én av dem større enn 0</translation>
    </message>
    <message>
        <source>neither a plane nor a quadrilateral</source>
        <translation>verken et plan eller en firkant</translation>
    </message>
    <message numerus="yes">
        <source>no support column from the platform reaches {voxels} voxels that would be missed</source>
        <translation>
            <numerusform>ingen støttesøyle fra plattformen når {voxels} voksel som ville gå tapt</numerusform>
            <numerusform>ingen støttesøyle fra plattformen når {voxels} voksler som ville gå tapt</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown figure &apos;{key}&apos;</source>
        <translation>ukjent måltall &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>no function is defined</source>
        <translation>ingen funksjon er definert</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: their distance is {shortest:.3g} to {longest:.3g} mm</source>
        <translation>intet antall lag mellom overflaten og sluttflaten holder laghøyden innenfor {least} til {most} mm: avstanden mellom dem er {shortest:.3g} til {longest:.3g} mm</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: {layers} layers would be {thinnest:.3g} to {thickest:.3g} mm high</source>
        <translation>intet antall lag mellom overflaten og sluttflaten holder laghøyden innenfor {least} til {most} mm: {layers} lag ville bli {thinnest:.3g} til {thickest:.3g} mm høye</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>filen finnes ikke</translation>
    </message>
    <message>
        <source>no tool-paths left</source>
        <translation>ingen verktøybaner igjen</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominell</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>not JSON: {why}</source>
        <translation>ikke JSON: {why}</translation>
    </message>
    <message>
        <source>not a Voluta job</source>
        <translation>ikke en Voluta-jobb</translation>
    </message>
    <message>
        <source>invalid filament diameter</source>
        <translation>ugyldig filamentdiameter</translation>
    </message>
    <message>
        <source>not a mesh file</source>
        <translation>ikke en mesh-fil</translation>
    </message>
    <message>
        <source>invalid module attributes</source>
        <translation>ugyldige modulattributter</translation>
    </message>
    <message>
        <source>not a program in any known format</source>
        <translation>ikke et program i noe kjent format</translation>
    </message>
    <message>
        <source>not a row of the table</source>
        <translation>ikke en rad i tabellen</translation>
    </message>
    <message>
        <source>not a zip file, or truncated</source>
        <translation>ikke en zip-fil, eller avkortet</translation>
    </message>
    <message>
        <source>not a valid procedure header</source>
        <translation>ikke et gyldig prosedyrehode</translation>
    </message>
    <message>
        <source>not the header of a joint table</source>
        <translation>ikke hodet til en leddtabell</translation>
    </message>
    <message>
        <source>not understood: &apos;{code}&apos;</source>
        <translation>ikke forstått: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing is left of the mesh after repair</source>
        <translation>ingenting er igjen av meshen etter reparasjon</translation>
    </message>
    <message>
        <source>no normal of the surface below the part hits the end surface</source>
        <translation>ingen normal fra overflaten under delen treffer sluttflaten</translation>
    </message>
    <message>
        <source>nothing is on the platform</source>
        <translation>ingenting står på plattformen</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>dyse</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is missing</source>
        <translation>objektet &apos;{id}&apos; mangler</translation>
    </message>
    <message>
        <source>objects contain each other, or there are too many to read</source>
        <translation>objekter inneholder hverandre, eller det er for mange til å leses</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>forskyvning</translation>
    </message>
    <message>
        <source>on the plate</source>
        <translation>på byggeplaten</translation>
    </message>
    <message>
        <source>a stop that ends by itself or is skipped</source>
        <translation>en stopp som avsluttes av seg selv eller hoppes over</translation>
    </message>
    <message>
        <source>a stop that the operator ends</source>
        <translation>en stopp som operatøren avslutter</translation>
    </message>
    <message>
        <source>only three-dimensional OFF files can be read</source>
        <translation>bare tredimensjonale OFF-filer kan leses</translation>
    </message>
    <message>
        <source>open</source>
        <translation>åpning</translation>
    </message>
    <message>
        <source>open it with the version that saved it</source>
        <translation>åpne den med versjonen som lagret den</translation>
    </message>
    <message>
        <source>ordering layers</source>
        <translation>ordner lag</translation>
    </message>
    <message>
        <source>to keep the orientation as given, use `orient=none`</source>
        <translation>for å beholde oppgitt orientering, bruk `orient=none`</translation>
    </message>
    <message>
        <source>`orient={orient}` is for parts on a plate; mode {mode} places them itself</source>
        <translation>`orient={orient}` er for deler på en byggeplate; modus {mode} plasserer dem selv</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>orientering</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>ikke nok minne</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>utenfor rekkevidde</translation>
    </message>
    <message>
        <source>overhang angle</source>
        <translation>overhengsvinkel</translation>
    </message>
    <message>
        <source>pair {number}</source>
        <translation>par {number}</translation>
    </message>
    <message>
        <source>pairs a body with itself</source>
        <translation>parer et legeme med seg selv</translation>
    </message>
    <message>
        <source>peeling</source>
        <translation>avskalling</translation>
    </message>
    <message>
        <source>pick a point on a piece that touches the plate, or place the part on the face to start from</source>
        <translation>velg et punkt på et stykke som berører byggeplaten, eller plasser delen på flaten det skal startes fra</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>stykker</translation>
    </message>
    <message>
        <source>some areas are narrower than half a bead and stay empty</source>
        <translation>noen områder er smalere enn en halv streng og forblir tomme</translation>
    </message>
    <message>
        <source>placed part</source>
        <translation>plassert del</translation>
    </message>
    <message>
        <source>plan again with more clearance, or place the part elsewhere</source>
        <translation>planlegg på nytt med større klaring, eller plasser delen et annet sted</translation>
    </message>
    <message>
        <source>plan it without --until</source>
        <translation>planlegg den uten --until</translation>
    </message>
    <message>
        <source>plan the part again</source>
        <translation>planlegg delen på nytt</translation>
    </message>
    <message>
        <source>plan the part further: voluta-cli plan PART -o DIR</source>
        <translation>planlegg delen videre: voluta-cli plan DEL -o MAPPE</translation>
    </message>
    <message>
        <source>layer planes</source>
        <translation>lagplan</translation>
    </message>
    <message>
        <source>layer planes miss the part: {planes}</source>
        <translation>lagplan bommer på delen: {planes}</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>plattform</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; has no valid size</source>
        <translation>plattformen &apos;{platform}&apos; har ingen gyldig størrelse</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; is not a plate</source>
        <translation>plattformen &apos;{platform}&apos; er ikke en byggeplate</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; names no file</source>
        <translation>plattformen &apos;{platform}&apos; angir ingen fil</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos;: {field} {size} is out of range</source>
        <translation>plattformen &apos;{platform}&apos;: {field} {size} er utenfor området</translation>
    </message>
    <message>
        <source>point {i} is the third one at x = {x:.6g} mm</source>
        <translation>punkt {i} er det tredje ved x = {x:.6g} mm</translation>
    </message>
    <message>
        <source>print the part larger, or with a finer process</source>
        <translation>print delen større, eller med en finere prosess</translation>
    </message>
    <message>
        <source>print the part smaller (scale)</source>
        <translation>print delen mindre (scale)</translation>
    </message>
    <message>
        <source>printed part</source>
        <translation>printet del</translation>
    </message>
    <message>
        <source>rod profile</source>
        <translation>stangprofil</translation>
    </message>
    <message>
        <source>put - only under the part or beside its lowest row</source>
        <translation>sett - bare under delen eller ved siden av den nederste raden</translation>
    </message>
    <message>
        <source>put - directly under the part</source>
        <translation>sett - rett under delen</translation>
    </message>
    <message>
        <source>orient it by hand</source>
        <translation>orienter den for hånd</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>radius</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>nåbar</translation>
    </message>
    <message>
        <source>relative positions are not understood</source>
        <translation>relative posisjoner støttes ikke</translation>
    </message>
    <message>
        <source>repair</source>
        <translation>reparasjon</translation>
    </message>
    <message>
        <source>repair it, or use curved mode, which takes any mesh</source>
        <translation>reparer den, eller bruk modus curved, som tar enhver mesh</translation>
    </message>
    <message>
        <source>repair the part first</source>
        <translation>reparer delen først</translation>
    </message>
    <message>
        <source>repair: check</source>
        <translation>reparasjon: kontroll</translation>
    </message>
    <message>
        <source>repair: diagnosis</source>
        <translation>reparasjon: diagnose</translation>
    </message>
    <message>
        <source>repair: holes</source>
        <translation>reparasjon: hull</translation>
    </message>
    <message>
        <source>repair: orientation</source>
        <translation>reparasjon: orientering</translation>
    </message>
    <message>
        <source>repair: self-intersections</source>
        <translation>reparasjon: selvskjæringer</translation>
    </message>
    <message>
        <source>replaying {format}</source>
        <translation>gjenspiller {format}</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>gjenspilt</translation>
    </message>
    <message>
        <source>risky area</source>
        <translation>risikoareal</translation>
    </message>
    <message>
        <source>robot motion</source>
        <translation>robotbevegelse</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>stang</translation>
    </message>
    <message>
        <source>rod, {sizes} mm</source>
        <translation>stang, {sizes} mm</translation>
    </message>
    <message>
        <source>`rodProfile`: &apos;{text}&apos; is neither a pair x,radius nor a file</source>
        <translation>`rodProfile`: &apos;{text}&apos; er verken et par x,radius eller en fil</translation>
    </message>
    <message>
        <source>root</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>size of the table of patches</source>
        <translation>størrelsen på tabellen over lagflater</translation>
    </message>
    <message>
        <source>size of the table of pieces</source>
        <translation>størrelsen på tabellen over stykker</translation>
    </message>
    <message>
        <source>running the program</source>
        <translation>kjører programmet</translation>
    </message>
    <message>
        <source>invalid scale &apos;{scale}&apos;</source>
        <translation>ugyldig skala &apos;{scale}&apos;</translation>
    </message>
    <message>
        <source>scale fit would scale the platform&apos;s mesh with the part</source>
        <translation>skala fit ville skalere plattformens mesh sammen med delen</translation>
    </message>
    <message>
        <source>scale the part down</source>
        <translation>skaler ned delen</translation>
    </message>
    <message>
        <source>scale the part down (`--scale fit`), turn it, or use a larger robot</source>
        <translation>skaler ned delen (`--scale fit`), roter den, eller bruk en større robot</translation>
    </message>
    <message>
        <source>scale the part down, or move it along the rod</source>
        <translation>skaler ned delen, eller flytt den langs stangen</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>metode</translation>
    </message>
    <message>
        <source>see the findings before this one</source>
        <translation>se funnene før dette</translation>
    </message>
    <message>
        <source>see: list formats</source>
        <translation>se: list formats</translation>
    </message>
    <message numerus="yes">
        <source>separated non-manifold edges at {count} points</source>
        <translation>
            <numerusform>skilte ikke-manifolde kanter i {count} punkt</numerusform>
            <numerusform>skilte ikke-manifolde kanter i {count} punkter</numerusform>
        </translation>
    </message>
    <message>
        <source>set {variable}</source>
        <translation>sett {variable}</translation>
    </message>
    <message>
        <source>set_tcp needs a pose</source>
        <translation>set_tcp krever en positur</translation>
    </message>
    <message>
        <source>layer shape</source>
        <translation>lagform</translation>
    </message>
    <message>
        <source>use shorter motions or smaller blends</source>
        <translation>bruk kortere bevegelser eller mindre overganger</translation>
    </message>
    <message>
        <source>rod sides</source>
        <translation>stangens sider</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>skjelett</translation>
    </message>
    <message>
        <source>sleep needs a time in seconds</source>
        <translation>sleep krever en tid i sekunder</translation>
    </message>
    <message>
        <source>slice {slice} ends after {rows} rows, the first one after {first}</source>
        <translation>skive {slice} slutter etter {rows} rader, den første etter {first}</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>slicing</translation>
    </message>
    <message>
        <source>print slower there, or place the part elsewhere in the cell</source>
        <translation>print langsommere der, eller plasser delen et annet sted i cellen</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>kule</translation>
    </message>
    <message numerus="yes">
        <source>split edges at {count} T-junctions</source>
        <translation>
            <numerusform>delte kanter ved {count} T-knutepunkt</numerusform>
            <numerusform>delte kanter ved {count} T-knutepunkter</numerusform>
        </translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angitt</translation>
    </message>
    <message>
        <source>step</source>
        <translation>trinn</translation>
    </message>
    <message>
        <source>step height</source>
        <translation>trinnhøyde</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>støtter</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>overflate</translation>
    </message>
    <message>
        <source>choose a cell with a rod: `--cell lathe`</source>
        <translation>velg en celle med stang: `--cell lathe`</translation>
    </message>
    <message>
        <source>choose a shorter rod</source>
        <translation>velg en kortere stang</translation>
    </message>
    <message>
        <source>choose a thinner rod</source>
        <translation>velg en tynnere stang</translation>
    </message>
    <message>
        <source>subtract the rod from the part</source>
        <translation>trekk stangen fra delen</translation>
    </message>
    <message>
        <source>subtract the surface from the part</source>
        <translation>trekk overflaten fra delen</translation>
    </message>
    <message>
        <source>use {formats}</source>
        <translation>bruk {formats}</translation>
    </message>
    <message>
        <source>text after ENDMODULE</source>
        <translation>tekst etter ENDMODULE</translation>
    </message>
    <message>
        <source>text after the end</source>
        <translation>tekst etter slutten</translation>
    </message>
    <message>
        <source>the arm cannot reach this target</source>
        <translation>armen når ikke dette målet</translation>
    </message>
    <message>
        <source>the arm&apos;s configuration is not the planned one: a joint differs by {angle:.1f}</source>
        <translation>armens konfigurasjon er ikke den planlagte: et ledd avviker med {angle:.1f}</translation>
    </message>
    <message>
        <source>the arm would have to change its configuration: {joint} would jump by {angle:.1f}</source>
        <translation>armen måtte skifte konfigurasjon: {joint} ville hoppe {angle:.1f}</translation>
    </message>
    <message>
        <source>configuration supervision is on: ConfL\Off, ConfJ\Off</source>
        <translation>konfigurasjonsovervåking er på: ConfL\Off, ConfJ\Off</translation>
    </message>
    <message>
        <source>the end sequence (M104 S0, M84, &apos;; end&apos;) is missing: the file is truncated</source>
        <translation>sluttsekvensen (M104 S0, M84, &apos;; end&apos;) mangler: filen er avkortet</translation>
    </message>
    <message>
        <source>the end sequence is missing</source>
        <translation>sluttsekvensen mangler</translation>
    </message>
    <message>
        <source>the end surface is {rise:.3g} mm above the top of the starting surface</source>
        <translation>sluttflaten er {rise:.3g} mm over toppen av startflaten</translation>
    </message>
    <message>
        <source>external axis {angle:.3f} off its planned position</source>
        <translation>ekstern akse {angle:.3f} fra planlagt posisjon</translation>
    </message>
    <message>
        <source>the extruder is not switched off after the last motion</source>
        <translation>ekstruderen slås ikke av etter siste bevegelse</translation>
    </message>
    <message>
        <source>the extruder is off during a bead</source>
        <translation>ekstruderen er av under en streng</translation>
    </message>
    <message>
        <source>the extruder is on during a travel</source>
        <translation>ekstruderen er på under en tomkjøring</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not set before this motion</source>
        <translation>ekstruderens utganger er ikke satt før denne bevegelsen</translation>
    </message>
    <message>
        <source>the feature is {width:.3g} mm wide, wider than its cylinder of {cylinder:.3g} mm</source>
        <translation>detaljen er {width:.3g} mm bred, bredere enn sylinderen på {cylinder:.3g} mm</translation>
    </message>
    <message>
        <source>the file ends without &quot;endsolid&quot;: it may be truncated</source>
        <translation>filen slutter uten &quot;endsolid&quot;: den er kanskje avkortet</translation>
    </message>
    <message>
        <source>the file contains no cells</source>
        <translation>filen inneholder ingen celler</translation>
    </message>
    <message>
        <source>the file is truncated: {what}</source>
        <translation>filen er avkortet: {what}</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>filen er tom</translation>
    </message>
    <message>
        <source>the file&apos;s top {what}</source>
        <translation>filens øverste nivå {what}</translation>
    </message>
    <message>
        <source>the first module has no procedure main</source>
        <translation>den første modulen har ingen prosedyre main</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; has no end</source>
        <translation>funksjonen &apos;{defined}&apos; har ingen slutt</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is never called</source>
        <translation>funksjonen &apos;{defined}&apos; kalles aldri</translation>
    </message>
    <message>
        <source>the function is never called</source>
        <translation>funksjonen kalles aldri</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>filhodet har ingen slutt</translation>
    </message>
    <message>
        <source>the header line is missing</source>
        <translation>hodelinjen mangler</translation>
    </message>
    <message>
        <source>the header states no format</source>
        <translation>filhodet angir ikke noe format</translation>
    </message>
    <message>
        <source>the header states no facets; {facets} read</source>
        <translation>filhodet angir ingen fasetter; {facets} lest</translation>
    </message>
    <message>
        <source>the job file is inconsistent</source>
        <translation>jobbfilen er inkonsistent</translation>
    </message>
    <message>
        <source>the job file is inconsistent: {what}</source>
        <translation>jobbfilen er inkonsistent: {what}</translation>
    </message>
    <message>
        <source>the job file is truncated</source>
        <translation>jobbfilen er avkortet</translation>
    </message>
    <message>
        <source>the first line of the job file is damaged or truncated</source>
        <translation>den første linjen i jobbfilen er skadet eller avkortet</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; is missing in the job file</source>
        <translation>blokken &apos;{name}&apos; mangler i jobbfilen</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged</source>
        <translation>jobbfilens hode er skadet</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged: {why}</source>
        <translation>jobbfilens hode er skadet: {why}</translation>
    </message>
    <message>
        <source>the job has no motion to verify against</source>
        <translation>jobben har ingen bevegelse å verifisere mot</translation>
    </message>
    <message>
        <source>the job contains no {result}</source>
        <translation>jobben inneholder ikke {result}</translation>
    </message>
    <message>
        <source>the letter {letter} has no number</source>
        <translation>bokstaven {letter} mangler tall</translation>
    </message>
    <message>
        <source>the line &apos;# end&apos; is missing: the file is truncated</source>
        <translation>linjen &apos;# end&apos; mangler: filen er avkortet</translation>
    </message>
    <message>
        <source>the list of modules has no end</source>
        <translation>modullisten har ingen slutt</translation>
    </message>
    <message>
        <source>deposited volume: {share:.2f} of the part&apos;s</source>
        <translation>avsatt volum: {share:.2f} av delens</translation>
    </message>
    <message>
        <source>mechanical unit &apos;{text}&apos; is not active: ActUnit</source>
        <translation>den mekaniske enheten &apos;{text}&apos; er ikke aktiv: ActUnit</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>meshen har ingen trekanter</translation>
    </message>
    <message>
        <source>the mesh is empty: no facet has valid coordinates</source>
        <translation>meshen er tom: ingen fasett har gyldige koordinater</translation>
    </message>
    <message>
        <source>the mesh is empty: the file has no triangles</source>
        <translation>meshen er tom: filen har ingen trekanter</translation>
    </message>
    <message>
        <source>the mesh is not closed</source>
        <translation>meshen er ikke lukket</translation>
    </message>
    <message>
        <source>the module has no procedure</source>
        <translation>modulen har ingen prosedyre</translation>
    </message>
    <message>
        <source>the module with {procedure} is missing</source>
        <translation>modulen med {procedure} mangler</translation>
    </message>
    <message>
        <source>module {name} is missing</source>
        <translation>modulen {name} mangler</translation>
    </message>
    <message>
        <source>the normal has zero length</source>
        <translation>normalen har lengde null</translation>
    </message>
    <message>
        <source>nozzle {distance:.3f} off the planned path</source>
        <translation>dysen er {distance:.3f} fra planlagt bane</translation>
    </message>
    <message>
        <source>nozzle axis {angle:.2f} off the planned direction</source>
        <translation>dyseaksen er {angle:.2f} fra planlagt retning</translation>
    </message>
    <message>
        <source>the numbers of vertices and faces are expected here</source>
        <translation>antall hjørnepunkter og flater ventes her</translation>
    </message>
    <message>
        <source>no part: no 1 above the platform</source>
        <translation>ingen del: ingen 1 over plattformen</translation>
    </message>
    <message>
        <source>the object is too large</source>
        <translation>objektet er for stort</translation>
    </message>
    <message>
        <source>the part below</source>
        <translation>delen under</translation>
    </message>
    <message>
        <source>the part does not touch the plate</source>
        <translation>delen berører ikke byggeplaten</translation>
    </message>
    <message>
        <source>the part does not touch the platform</source>
        <translation>delen berører ikke plattformen</translation>
    </message>
    <message>
        <source>the part has no clear axis: its surface normals have no preferred direction</source>
        <translation>delen har ingen tydelig akse: overflatenormalene har ingen foretrukket retning</translation>
    </message>
    <message>
        <source>the part has no surface</source>
        <translation>delen har ingen overflate</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the rod is subtracted</source>
        <translation>delen er ikke lukket, eller skjærer seg selv der stangen trekkes fra</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the surface&apos;s body is subtracted</source>
        <translation>delen er ikke lukket, eller skjærer seg selv der overflatens legeme trekkes fra</translation>
    </message>
    <message>
        <source>the part is too large for a collision grid of this resolution</source>
        <translation>delen er for stor for et kollisjonsrutenett med denne oppløsningen</translation>
    </message>
    <message numerus="yes">
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxels ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>
            <numerusform>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): {missed} tapt voksel ({voxel:.2f} bred) i stedet for {missedBefore}, overheng {overhang:.0f} i stedet for {overhangBefore:.0f#}</numerusform>
            <numerusform>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): {missed} tapte voksler ({voxel:.2f} brede) i stedet for {missedBefore}, overheng {overhang:.0f} i stedet for {overhangBefore:.0f#}</numerusform>
        </translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): estimated overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): anslått overheng etter kutting {left:.0f} (stykker: {pieces}) i stedet for {leftBefore:.0f#} (stykker: {piecesBefore}); ukuttet {overhang:.0f} i stedet for {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): overheng {overhang:.0f} i stedet for {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): residual area on XY {xy:.0f} instead of {xyBefore:.0f#}, on XZ {xz:.0f} instead of {xzBefore:.0f#}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): restareal på XY {xy:.0f} i stedet for {xyBefore:.0f#}, på XZ {xz:.0f} i stedet for {xzBefore:.0f#}, overheng {overhang:.0f} i stedet for {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part is {width:.3g} mm wide, at least as wide as the cylinder below it</source>
        <translation>delen er {width:.3g} mm bred, minst like bred som sylinderen under den</translation>
    </message>
    <message>
        <source>the part misses the rod: no layer of it rests on the rod</source>
        <translation>delen bommer på stangen: ingen av lagene hviler på stangen</translation>
    </message>
    <message>
        <source>the part misses the surface: no layer of it rests on the surface</source>
        <translation>delen bommer på overflaten: ingen av lagene hviler på overflaten</translation>
    </message>
    <message>
        <source>the part reaches below the platform</source>
        <translation>delen går ned under plattformen</translation>
    </message>
    <message>
        <source>the part extends from x = {from:.4g} to {to:.4g} mm, beyond an end of the rod at {firstEnd:.4g} or {lastEnd:.4g} mm</source>
        <translation>delen går fra x = {from:.4g} til {to:.4g} mm, utover en ende av stangen ved {firstEnd:.4g} eller {lastEnd:.4g} mm</translation>
    </message>
    <message>
        <source>the part extends {height:.3g} mm beyond the rod, less than a layer of {least:.3g} mm</source>
        <translation>delen går {height:.3g} mm utenfor stangen, mindre enn et lag på {least:.3g} mm</translation>
    </message>
    <message>
        <source>the part extends to {reach:.4g} from the rod&apos;s axis; the cell prints up to {limit}</source>
        <translation>delen når ut til {reach:.4g} fra stangens akse; cellen printer opptil {limit}</translation>
    </message>
    <message>
        <source>the part rises {height:.3g} mm above the surface, less than a layer of {least:.3g} mm</source>
        <translation>delen stiger {height:.3g} mm over overflaten, mindre enn et lag på {least:.3g} mm</translation>
    </message>
    <message>
        <source>an end surface radius:R requires a cylinder along x below the part</source>
        <translation>en sluttflate radius:R krever en sylinder langs x under delen</translation>
    </message>
    <message numerus="yes">
        <source>the part keeps its orientation: none of {ways} stable ones is better</source>
        <translation>
            <numerusform>delen beholder orienteringen: den eneste andre stabile er ikke bedre</numerusform>
            <numerusform>delen beholder orienteringen: ingen av {ways} stabile er bedre</numerusform>
        </translation>
    </message>
    <message>
        <source>the placement is not a rotation and a position in mm</source>
        <translation>plasseringen er ikke en rotasjon og en posisjon i mm</translation>
    </message>
    <message>
        <source>the plane misses the part</source>
        <translation>planet bommer på delen</translation>
    </message>
    <message>
        <source>the planes are not a JSON list</source>
        <translation>planene er ikke en JSON-liste</translation>
    </message>
    <message>
        <source>the platform</source>
        <translation>plattformen</translation>
    </message>
    <message>
        <source>the platform&apos;s mesh is not closed</source>
        <translation>plattformens mesh er ikke lukket</translation>
    </message>
    <message>
        <source>the points are collinear</source>
        <translation>punktene ligger på linje</translation>
    </message>
    <message>
        <source>the print head would cut into printed material, however it is tilted</source>
        <translation>skrivehodet ville skjære inn i printet materiale uansett hvordan det tiltes</translation>
    </message>
    <message>
        <source>the procedure has no ENDPROC</source>
        <translation>prosedyren har ingen ENDPROC</translation>
    </message>
    <message numerus="yes">
        <source>the program ends here; {motions} planned motions are missing</source>
        <translation>
            <numerusform>programmet slutter her; {motions} planlagt bevegelse mangler</numerusform>
            <numerusform>programmet slutter her; {motions} planlagte bevegelser mangler</numerusform>
        </translation>
    </message>
    <message>
        <source>the program has no motions</source>
        <translation>programmet har ingen bevegelser</translation>
    </message>
    <message>
        <source>the program runs from 0 to {end:.1f}</source>
        <translation>programmet går fra 0 til {end:.1f}</translation>
    </message>
    <message>
        <source>the program&apos;s data folder is missing</source>
        <translation>programmets datamappe mangler</translation>
    </message>
    <message>
        <source>the program&apos;s motions do not match this plan</source>
        <translation>programmets bevegelser stemmer ikke med denne planen</translation>
    </message>
    <message>
        <source>the quadrilateral has no area</source>
        <translation>firkanten har ikke noe areal</translation>
    </message>
    <message>
        <source>the quadrilateral is not convex</source>
        <translation>firkanten er ikke konveks</translation>
    </message>
    <message>
        <source>the quadrilateral is not flat</source>
        <translation>firkanten er ikke plan</translation>
    </message>
    <message>
        <source>the radius at point {i} is not positive</source>
        <translation>radiusen i punkt {i} er ikke positiv</translation>
    </message>
    <message>
        <source>not a plan&apos;s report: {why}</source>
        <translation>ikke en planrapport: {why}</translation>
    </message>
    <message>
        <source>the robot motion is empty</source>
        <translation>robotbevegelsen er tom</translation>
    </message>
    <message>
        <source>the rod is thicker than the part and contains all of it</source>
        <translation>stangen er tykkere enn delen og inneholder hele delen</translation>
    </message>
    <message>
        <source>the rod extends {reach} mm from its middle; the cell has room for {room} mm</source>
        <translation>stangen strekker seg {reach} mm fra midten; cellen har plass til {room} mm</translation>
    </message>
    <message>
        <source>the rod&apos;s radius is {radius} mm; the cell prints up to {most} mm</source>
        <translation>stangens radius er {radius} mm; cellen printer opptil {most} mm</translation>
    </message>
    <message>
        <source>the root at {x:.1f}, {y:.1f}, {z:.1f} mm is not on the plate</source>
        <translation>roten ved {x:.1f}, {y:.1f}, {z:.1f} mm er ikke på byggeplaten</translation>
    </message>
    <message>
        <source>the row has {cells} cells, the first one {first}</source>
        <translation>raden har {cells} celler, den første har {first}</translation>
    </message>
    <message>
        <source>the body of the surface contains the whole part</source>
        <translation>overflatens legeme inneholder hele delen</translation>
    </message>
    <message>
        <source>the voxel object is lifted by a fraction of a voxel: it is cut into new voxels</source>
        <translation>vokselobjektet er løftet en brøkdel av en voksel: det deles i nye voksler</translation>
    </message>
    <message>
        <source>the voxel object is not rotated by a multiple of 90°: it is cut into new voxels</source>
        <translation>vokselobjektet er ikke rotert et multiplum av 90°: det deles i nye voksler</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>vokslene er for små for en del av denne størrelsen</translation>
    </message>
    <message>
        <source>the {format} program is not released: {failed}</source>
        <translation>{format}-programmet frigis ikke: {failed}</translation>
    </message>
    <message>
        <source>there is no layer {layer}</source>
        <translation>lag {layer} finnes ikke</translation>
    </message>
    <message>
        <source>no module</source>
        <translation>ingen modul</translation>
    </message>
    <message>
        <source>there is no platform: no - in any row</source>
        <translation>det er ingen plattform: ingen - i noen rad</translation>
    </message>
    <message>
        <source>there is no time {time}</source>
        <translation>tidspunktet {time} finnes ikke</translation>
    </message>
    <message>
        <source>thicken the wall to {least} or more</source>
        <translation>gjør veggen {least} tykk eller mer</translation>
    </message>
    <message>
        <source>thickness classes</source>
        <translation>tykkelsesklasser</translation>
    </message>
    <message>
        <source>OpenGL 3.2 without a display is not available: {why}</source>
        <translation>OpenGL 3.2 uten skjerm er ikke tilgjengelig: {why}</translation>
    </message>
    <message>
        <source>this is not the module that main runs next</source>
        <translation>dette er ikke modulen som main kjører som neste</translation>
    </message>
    <message>
        <source>this motion and the one at {other} are swapped</source>
        <translation>denne bevegelsen og den ved {other} er byttet om</translation>
    </message>
    <message>
        <source>this motion deposits {volume:.3f} instead of {planned:.3f}</source>
        <translation>denne bevegelsen avsetter {volume:.3f} i stedet for {planned:.3f}</translation>
    </message>
    <message>
        <source>this motion takes {time:.3f} instead of {planned:.3f}</source>
        <translation>denne bevegelsen tar {time:.3f} i stedet for {planned:.3f}</translation>
    </message>
    <message>
        <source>time decreases</source>
        <translation>tiden avtar</translation>
    </message>
    <message>
        <source>too many triangles for an STL file</source>
        <translation>for mange trekanter for en STL-fil</translation>
    </message>
    <message>
        <source>tool-paths</source>
        <translation>verktøybaner</translation>
    </message>
    <message>
        <source>touch points farther apart around the cylinder</source>
        <translation>berør punkter som ligger lenger fra hverandre rundt sylinderen</translation>
    </message>
    <message>
        <source>touched points</source>
        <translation>målte punkter</translation>
    </message>
    <message>
        <source>trimming layers on the part</source>
        <translation>beskjærer lag på delen</translation>
    </message>
    <message>
        <source>try a larger `voxelMm` or a smaller part</source>
        <translation>prøv en større `voxelMm` eller en mindre del</translation>
    </message>
    <message>
        <source>to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels</source>
        <translation>for å beholde vokslene, roter det i multipler av 90° og løft det hele voksler</translation>
    </message>
    <message>
        <source>infill rotation per layer</source>
        <translation>fyllrotasjon per lag</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), add supports, or use planar or curved mode</source>
        <translation>roter delen (`orient=leastRisky`), legg til støtter, eller bruk modus planar eller curved</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), or use planar or curved mode</source>
        <translation>roter delen (`orient=leastRisky`), eller bruk modus planar eller curved</translation>
    </message>
    <message>
        <source>turn the part about the vertical, or try more rotations (`redundancySamples`)</source>
        <translation>roter delen om loddaksen, eller prøv flere rotasjoner (`redundancySamples`)</translation>
    </message>
    <message>
        <source>turn the part, enlarge the platform or add supports</source>
        <translation>roter delen, gjør plattformen større eller legg til støtter</translation>
    </message>
    <message>
        <source>turn the part, make the platform smaller or add supports</source>
        <translation>roter delen, gjør plattformen mindre eller legg til støtter</translation>
    </message>
    <message>
        <source>turn the part, or allow less clearance</source>
        <translation>roter delen, eller tillat mindre klaring</translation>
    </message>
    <message>
        <source>turn the part, use a smaller platform, or allow less clearance</source>
        <translation>roter delen, bruk en mindre plattform, eller tillat mindre klaring</translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} inside-out components</source>
        <translation>
            <numerusform>snudde {count} komponent med innsiden ut</numerusform>
            <numerusform>snudde {count} komponenter med innsiden ut</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} triangles to match their neighbours</source>
        <translation>
            <numerusform>snudde {count} trekant etter naboene</numerusform>
            <numerusform>snudde {count} trekanter etter naboene</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part: other orientations may need fewer</source>
        <translation>roter delen: andre orienteringer trenger kanskje færre</translation>
    </message>
    <message>
        <source>rotations tried per point</source>
        <translation>rotasjoner prøvd per punkt</translation>
    </message>
    <message>
        <source>two commands in one line</source>
        <translation>to kommandoer på én linje</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} overlapping components</source>
        <translation>
            <numerusform>slo sammen {count} overlappende komponent</numerusform>
            <numerusform>slo sammen {count} overlappende komponenter</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown cell &apos;{id}&apos;</source>
        <translation>ukjent celle &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown cell &apos;{name}&apos;</source>
        <translation>ukjent celle &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown colour &apos;{name}&apos;</source>
        <translation>ukjent farge &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown failure</source>
        <translation>ukjent feil</translation>
    </message>
    <message>
        <source>unknown format &apos;{id}&apos;</source>
        <translation>ukjent format &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown format &apos;{name}&apos;</source>
        <translation>ukjent format &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown growth &apos;{name}&apos;</source>
        <translation>ukjent vekst &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown infill &apos;{id}&apos;</source>
        <translation>ukjent fyll &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown key &apos;{key}&apos;</source>
        <translation>ukjent nøkkel &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>unknown mode &apos;{name}&apos;</source>
        <translation>ukjent modus &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown parameter &apos;{key}&apos;</source>
        <translation>ukjent parameter &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>unknown picture &apos;{name}&apos;</source>
        <translation>ukjent bilde &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown platform &apos;{name}&apos;</source>
        <translation>ukjent plattform &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown process &apos;{id}&apos;</source>
        <translation>ukjent prosess &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown process &apos;{name}&apos;</source>
        <translation>ukjent prosess &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown robot &apos;{id}&apos;</source>
        <translation>ukjent robot &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown sample &apos;{name}&apos;</source>
        <translation>ukjent eksempel &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown stage &apos;{name}&apos;</source>
        <translation>ukjent trinn &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown view &apos;{name}&apos;</source>
        <translation>ukjent visning &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print the part larger</source>
        <translation>bruk en finere dyse, eller print delen større</translation>
    </message>
    <message>
        <source>use a larger platform (fit:MARGIN), or turn the part</source>
        <translation>bruk en større plattform (fit:MARGIN), eller roter delen</translation>
    </message>
    <message>
        <source>use a slimmer print head, turn the part, or print it larger</source>
        <translation>bruk et slankere skrivehode, roter delen, eller print den større</translation>
    </message>
    <message>
        <source>use a slimmer print head or thinner layers</source>
        <translation>bruk et slankere skrivehode eller tynnere lag</translation>
    </message>
    <message>
        <source>use a smaller platform or place the part higher</source>
        <translation>bruk en mindre plattform eller plasser delen høyere</translation>
    </message>
    <message>
        <source>use a thinner rod, or print the part larger</source>
        <translation>bruk en tynnere stang, eller print delen større</translation>
    </message>
    <message>
        <source>use at least {least}</source>
        <translation>bruk minst {least}</translation>
    </message>
    <message>
        <source>use at most {side} cells a side and {millions} million in all</source>
        <translation>bruk høyst {side} celler per side og {millions} millioner i alt</translation>
    </message>
    <message>
        <source>use infill zigzag or concentric, or mode lathe</source>
        <translation>bruk fyllet zigzag eller concentric, eller modus lathe</translation>
    </message>
    <message>
        <source>use lower layers or a finer nozzle, or print the part larger</source>
        <translation>bruk lavere lag eller en finere dyse, eller print delen større</translation>
    </message>
    <message>
        <source>voxelise</source>
        <translation>vokselisering</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>voksler</translation>
    </message>
    <message>
        <source>voxels of {width} need about {needed} of memory; {available} are free</source>
        <translation>voksler på {width} trenger omtrent {needed} minne; {available} er ledig</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>vegger</translation>
    </message>
    <message>
        <source>UnLoad of a module that was not loaded and run</source>
        <translation>UnLoad av en modul som ikke er lastet og kjørt</translation>
    </message>
    <message>
        <source>winding angle</source>
        <translation>viklingsvinkel</translation>
    </message>
    <message>
        <source>woven</source>
        <translation>vevd</translation>
    </message>
    <message>
        <source>write 1 for the part, 0 for air, - for the platform</source>
        <translation>skriv 1 for delen, 0 for luft, - for plattformen</translation>
    </message>
    <message>
        <source>write 1 where the part is</source>
        <translation>skriv 1 der delen er</translation>
    </message>
    <message>
        <source>write files</source>
        <translation>skriving av filer</translation>
    </message>
    <message>
        <source>write flat, flat:Z, radius:R or mesh:FILE, in mm</source>
        <translation>skriv flat, flat:Z, radius:R eller mesh:FILE, i mm</translation>
    </message>
    <message>
        <source>write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm</source>
        <translation>skriv par som -20,2.5 0,2.5 0,3.5 20,3.5 i mm</translation>
    </message>
    <message>
        <source>write refused programs</source>
        <translation>skriv avviste programmer</translation>
    </message>
    <message>
        <source>write rows of 0 and 1, and - for the platform</source>
        <translation>skriv rader av 0 og 1, og - for plattformen</translation>
    </message>
    <message>
        <source>write the program again; to keep this change, make it in the plan</source>
        <translation>skriv programmet på nytt; for å beholde denne endringen, gjør den i planen</translation>
    </message>
    <message>
        <source>write intermediate results</source>
        <translation>skriv mellomresultater</translation>
    </message>
    <message>
        <source>write x,y,z in mm</source>
        <translation>skriv x,y,z i mm</translation>
    </message>
    <message>
        <source>write x,y,z in mm, such as 10,0,5</source>
        <translation>skriv x,y,z i mm, for eksempel 10,0,5</translation>
    </message>
    <message>
        <source>writing {format}</source>
        <translation>skriver {format}</translation>
    </message>
    <message>
        <source>write {form}</source>
        <translation>skriv {form}</translation>
    </message>
    <message>
        <source>write {form}, in mm</source>
        <translation>skriv {form}, i mm</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x decreases at point {i}</source>
        <translation>x avtar i punkt {i}</translation>
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
        <translation>sikksakk</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle}</source>
        <translation>{area:.3g} henger over med mer enn {angle}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at x = {x:.4g}, radius {radius:.4g}</source>
        <translation>{area:.3g} henger ut over lavere lag med mer enn {angle:.3g}, mest ved x = {x:.4g}, radius {radius:.4g}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at {at:.4g}</source>
        <translation>{area:.3g} henger ut over lavere lag med mer enn {angle:.3g}, mest ved {at:.4g}</translation>
    </message>
    <message numerus="yes">
        <source>{bad} of {facets} facets have NaN or out-of-range coordinates, first at facet {first}</source>
        <translation>
            <numerusform>{bad} av {facets} fasetter har NaN-koordinater eller koordinater utenfor området, først ved fasett {first}</numerusform>
            <numerusform>{bad} av {facets} fasetter har NaN-koordinater eller koordinater utenfor området, først ved fasett {first}</numerusform>
        </translation>
    </message>
    <message>
        <source>blocked pieces: {blocked} of {pieces}; earlier pieces are in the print head&apos;s way</source>
        <translation>blokkerte stykker: {blocked} av {pieces}; tidligere stykker er i veien for skrivehodet</translation>
    </message>
    <message numerus="yes">
        <source>{columns} more support columns under voxels that would be missed</source>
        <translation>
            <numerusform>én støttesøyle til under voksler som ellers ville gå tapt</numerusform>
            <numerusform>{columns} støttesøyler til under voksler som ellers ville gå tapt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} inside-out components, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} komponent med innsiden ut, ved {first:.2f}</numerusform>
            <numerusform>{count} komponenter med innsiden ut, den første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} duplicate triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} dobbel trekant, ved {first:.2f}</numerusform>
            <numerusform>{count} doble trekanter, den første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with inconsistently oriented triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} kant med ulikt orienterte trekanter, ved {first:.2f}</numerusform>
            <numerusform>{count} kanter med ulikt orienterte trekanter, den første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with more than two triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} kant med mer enn to trekanter, ved {first:.2f}</numerusform>
            <numerusform>{count} kanter med mer enn to trekanter, den første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} open edges in {loops} loops, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} åpen kant i {loops} sløyfer, ved {first:.2f}</numerusform>
            <numerusform>{count} åpne kanter i {loops} sløyfer, den første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} pairs of intersecting triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} par trekanter som skjærer hverandre, ved {first:.2f}</numerusform>
            <numerusform>{count} par trekanter som skjærer hverandre, det første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} triangles without area, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} trekant uten areal, ved {first:.2f}</numerusform>
            <numerusform>{count} trekanter uten areal, den første ved {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} voxels</source>
        <translation>
            <numerusform>{count} voksel</numerusform>
            <numerusform>{count} voksler</numerusform>
        </translation>
    </message>
    <message>
        <source>{file}, byte {byte}</source>
        <translation>{file}, byte {byte}</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, linje {line}</translation>
    </message>
    <message>
        <source>{file}, line {line}, column {column}</source>
        <translation>{file}, linje {line}, kolonne {column}</translation>
    </message>
    <message>
        <source>{first} and {second} collide</source>
        <translation>{first} og {second} kolliderer</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the finished motion</source>
        <translation>{first} kolliderer med {second} i den ferdige bevegelsen</translation>
    </message>
    <message>
        <source>{found} is none of 0, 1 and -</source>
        <translation>{found} er verken 0, 1 eller -</translation>
    </message>
    <message>
        <source>{joint} at {angle:.1f}, beyond its limit of {limit:.1f#}</source>
        <translation>{joint} på {angle:.1f}, over grensen på {limit:.1f#}</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}, above its limit of {limit:.1f#}</source>
        <translation>{joint} med {speed:.1f}, over grensen på {limit:.1f#}</translation>
    </message>
    <message>
        <source>not covered by layers: {left:.3g#} of {whole:.4g} of the part</source>
        <translation>ikke dekket av lag: {left:.3g#} av {whole:.4g} av delen</translation>
    </message>
    <message numerus="yes">
        <source>{motions} motions from here on are not in the plan</source>
        <translation>
            <numerusform>{motions} bevegelse herfra er ikke i planen</numerusform>
            <numerusform>{motions} bevegelser herfra er ikke i planen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing before this one</source>
        <translation>
            <numerusform>{motions} planlagt bevegelse mangler før denne</numerusform>
            <numerusform>{motions} planlagte bevegelser mangler før denne</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing between {before} and this one</source>
        <translation>
            <numerusform>{motions} planlagt bevegelse mangler mellom {before} og denne</numerusform>
            <numerusform>{motions} planlagte bevegelser mangler mellom {before} og denne</numerusform>
        </translation>
    </message>
    <message>
        <source>{option}: a value is not finite</source>
        <translation>{option}: en verdi er ikke endelig</translation>
    </message>
    <message>
        <source>{option}: {wanted} numbers expected, {given} given</source>
        <translation>{option}: {wanted} tall ventet, {given} oppgitt</translation>
    </message>
    <message>
        <source>{outside:.2f} of the part&apos;s volume is deposited outside it, {noRoom:.2f} does not fit</source>
        <translation>{outside:.2f} av delens volum avsettes utenfor den, {noRoom:.2f} får ikke plass</translation>
    </message>
    <message numerus="yes">
        <source>{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is below them</source>
        <translation>
            <numerusform>{patches} lagflate ({area:.1f}) begynner i løse luften: verken byggeplaten eller et tidligere lag er under den</numerusform>
            <numerusform>{patches} lagflater ({area:.1f}) begynner i løse luften: verken byggeplaten eller et tidligere lag er under dem</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out: too small for a bead, or they would begin in the air ({volume:.1f} in all, the largest {largest:.1f})</source>
        <translation>
            <numerusform>{pieces} lagstykke er utelatt: for lite for en streng, eller det ville begynne i løse luften ({volume:.1f})</numerusform>
            <numerusform>{pieces} lagstykker er utelatt: for små for en streng, eller de ville begynne i løse luften ({volume:.1f} i alt, det største {largest:.1f})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or they would begin in the air</source>
        <translation>
            <numerusform>{pieces} lagstykke er utelatt, {volume:.3g} av {whole:.3g#}: for lite for en streng, eller det ville begynne i løse luften</numerusform>
            <numerusform>{pieces} lagstykker er utelatt, {volume:.3g} av {whole:.3g#}: for små for en streng, eller de ville begynne i løse luften</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the rod nor an earlier layer</source>
        <translation>
            <numerusform>ett lagstykke begynner i løse luften, verken over stangen eller et tidligere lag</numerusform>
            <numerusform>{pieces} lagstykker begynner i løse luften, verken over stangen eller et tidligere lag</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the surface nor an earlier layer</source>
        <translation>
            <numerusform>ett lagstykke begynner i løse luften, verken over overflaten eller et tidligere lag</numerusform>
            <numerusform>{pieces} lagstykker begynner i løse luften, verken over overflaten eller et tidligere lag</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air</source>
        <translation>
            <numerusform>{pieces} lagstykke begynner i løse luften</numerusform>
            <numerusform>{pieces} lagstykker begynner i løse luften</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} places where the program differs from the plan</source>
        <translation>
            <numerusform>{places} sted der programmet avviker fra planen</numerusform>
            <numerusform>{places} steder der programmet avviker fra planen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the thinnest is {thinnest:.2f} thick</source>
        <translation>
            <numerusform>{places} mindre sted er tynnere enn en voksel på {voxel}; det er {thinnest:.2f} tykt</numerusform>
            <numerusform>{places} mindre steder er tynnere enn en voksel på {voxel}; dette er det største, det tynneste er {thinnest:.2f} tykt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places overhang too far, {area:.3g} in all; this is the largest</source>
        <translation>
            <numerusform>{places} mindre sted henger for langt over, {area:.3g}</numerusform>
            <numerusform>{places} mindre steder henger for langt over, {area:.3g} i alt; dette er det største</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer to {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}: ingen kollisjonsfri forflytning til {pieces} banestykke</numerusform>
            <numerusform>{place}: ingen kollisjonsfri forflytning til {pieces} banestykker</numerusform>
        </translation>
    </message>
    <message>
        <source>{place}: too far from the rod: the cell prints up to {radius} from its axis and {along} from its middle</source>
        <translation>{place}: for langt fra stangen: cellen printer opptil {radius} fra aksen og {along} fra midten</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into the platform</source>
        <translation>{place}: skrivehodet ville skjære inn i plattformen</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into printed material</source>
        <translation>{place}: skrivehodet ville skjære inn i printet materiale</translation>
    </message>
    <message>
        <source>{place}: reachable, but the robot cannot move from or to a neighbouring point without lifting</source>
        <translation>{place}: nåbart, men roboten kan ikke bevege seg fra eller til et nabopunkt uten å løfte</translation>
    </message>
    <message>
        <source>{place}: out of the robot&apos;s reach, or beyond a joint limit, at every rotation tried about the nozzle</source>
        <translation>{place}: utenfor robotens rekkevidde, eller forbi en leddgrense, ved hver prøvd rotasjon om dysen</translation>
    </message>
    <message>
        <source>{place}: {first} would collide with {second} at every rotation tried about the nozzle</source>
        <translation>{place}: {first} ville kollidere med {second} ved hver prøvd rotasjon om dysen</translation>
    </message>
    <message>
        <source>{points} points do not define a circle: at least three are needed</source>
        <translation>{points} punkter definerer ikke en sirkel: minst tre trengs</translation>
    </message>
    <message>
        <source>{share:.0f} of the layers&apos; area is thinner than {least} or thicker than {most}</source>
        <translation>{share:.0f} av lagenes areal er tynnere enn {least} eller tykkere enn {most}</translation>
    </message>
    <message>
        <source>{share:.2f} of the part is not covered by beads, mostly around this point</source>
        <translation>{share:.2f} av delen er ikke dekket av strenger, mest rundt dette punktet</translation>
    </message>
    <message>
        <source>{sizes} mm</source>
        <translation>{sizes} mm</translation>
    </message>
    <message>
        <source>{there} of the {promised} facets stated in the header are present</source>
        <translation>{there} av de {promised} fasettene filhodet angir, finnes</translation>
    </message>
    <message>
        <source>{threshold} {value:.4g} (limit {limit:.4g})</source>
        <translation>{threshold} {value:.4g} (grense {limit:.4g})</translation>
    </message>
    <message>
        <source>{value} is outside the limits of process {process}</source>
        <translation>{value} er utenfor grensene for prosessen {process}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} more voxels are missed in smaller groups ({groups}); this is the largest</source>
        <translation>
            <numerusform>én voksel til går tapt; dette er den</numerusform>
            <numerusform>{voxels} voksler til går tapt i mindre grupper ({groups}); dette er den største</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm</source>
        <translation>
            <numerusform>{voxels} voksel er skygget: dekket av den konvekse fronten fra trinn {step}, under fasetten mellom {a:.0f}, {b:.0f} og {c:.0f} mm</numerusform>
            <numerusform>{voxels} voksler er skygget: dekket av den konvekse fronten fra trinn {step}, under fasetten mellom {a:.0f}, {b:.0f} og {c:.0f} mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front before growth reached them</source>
        <translation>
            <numerusform>{voxels} voksel er skygget: dekket av den konvekse fronten før veksten nådde den</numerusform>
            <numerusform>{voxels} voksler er skygget: dekket av den konvekse fronten før veksten nådde dem</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are unreached: no path through the part from the platform</source>
        <translation>
            <numerusform>{voxels} voksel er ikke nådd: ingen vei gjennom delen fra plattformen</numerusform>
            <numerusform>{voxels} voksler er ikke nådd: ingen vei gjennom delen fra plattformen</numerusform>
        </translation>
    </message>
    <message>
        <source>{voxels} voxels in a grid of {cells} cells need about {needed} of memory; {available} are free</source>
        <translation>{voxels} voksler i et rutenett på {cells} celler trenger omtrent {needed} minne; {available} er ledig</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are below the plate</source>
        <translation>
            <numerusform>{voxels} voksel er under byggeplaten</numerusform>
            <numerusform>{voxels} voksler er under byggeplaten</numerusform>
        </translation>
    </message>
    <message>
        <source>{where}, entry {number}</source>
        <translation>{where}, oppføring {number}</translation>
    </message>
    <message>
        <source>Contact area, margin</source>
        <translation>Kontaktflate, marg</translation>
    </message>
    <message>
        <source>Rod of the cell</source>
        <translation>Cellens stang</translation>
    </message>
    <message>
        <source>Disc, diameter</source>
        <translation>Skive, diameter</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rektangel</translation>
    </message>
    <message>
        <source>Rod, diameter × length</source>
        <translation>Stang, diameter × lengde</translation>
    </message>
    <message>
        <source>Body from a file</source>
        <translation>Legeme fra fil</translation>
    </message>
    <message>
        <source>Margin around the contact area</source>
        <translation>Marg rundt kontaktflaten</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>Bredde (X)</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>Dybde (Y)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Curved layers</source>
        <translation>Krumme lag</translation>
    </message>
    <message>
        <source>Extended G-code (nozzle direction as nX nY nZ)</source>
        <translation>Utvidet G-kode (dyseretning som nX nY nZ)</translation>
    </message>
    <message>
        <source>Joint table (CSV)</source>
        <translation>Leddtabell (CSV)</translation>
    </message>
    <message>
        <source>contact area</source>
        <translation>kontaktflate</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Peels the part and keeps the best of several passes</source>
        <translation>Skaller av delen og beholder det beste av flere forsøk</translation>
    </message>
    <message>
        <source>Reverse peeling</source>
        <translation>Omvendt avskalling</translation>
    </message>
    <message>
        <source>Removes voxels from outside while the rest stays supported; printed in the opposite order</source>
        <translation>Fjerner voksler utenfra så lenge resten er støttet; printes i motsatt rekkefølge</translation>
    </message>
    <message>
        <source>Guided by peeling</source>
        <translation>Styrt av avskalling</translation>
    </message>
    <message>
        <source>Grows from the platform, held back by the peeling field</source>
        <translation>Vokser fra plattformen, holdt tilbake av avskallingsfeltet</translation>
    </message>
    <message>
        <source>Halved layers</source>
        <translation>Halverte lag</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer that would shadow voxels is halved until it does not</source>
        <translation>Vokser fra plattformen; et lag som ville skygge voksler, halveres til det ikke lenger gjør det</translation>
    </message>
    <message>
        <source>Voxel by voxel</source>
        <translation>Voksel for voksel</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer takes each voxel that shadows no other</source>
        <translation>Vokser fra plattformen; et lag tar hver voksel som ikke skygger noen annen</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Grådig</translation>
    </message>
    <message>
        <source>Grows from the platform by whole layers, whatever they shadow</source>
        <translation>Vokser fra plattformen i hele lag, uansett hva de skygger</translation>
    </message>
    <message>
        <source>Drop to plate</source>
        <translation>Senk til byggeplaten</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>Senker delen ned på byggeplaten</translation>
    </message>
    <message>
        <source>Shrink platform</source>
        <translation>Krymp plattformen</translation>
    </message>
    <message>
        <source>To the part&apos;s contact area, which narrows the front</source>
        <translation>Til delens kontaktflate, noe som gjør fronten smalere</translation>
    </message>
    <message>
        <source>Add supports</source>
        <translation>Legg til støtter</translation>
    </message>
    <message>
        <source>As few thin break-away columns as possible</source>
        <translation>Så få tynne, avbrekkbare søyler som mulig</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Roter delen</translation>
    </message>
    <message>
        <source>Searches the orientation with the fewest missed voxels</source>
        <translation>Søker orienteringen med færrest tapte voksler</translation>
    </message>
    <message>
        <source>Narrow enough for this wall; narrower voxels take longer</source>
        <translation>Smale nok for denne veggen; smalere voksler tar lengre tid</translation>
    </message>
    <message>
        <source>Planar pieces</source>
        <translation>Plane stykker</translation>
    </message>
    <message>
        <source>Flat layers</source>
        <translation>Flate lag</translation>
    </message>
    <message>
        <source>Widen the platform</source>
        <translation>Gjør plattformen bredere</translation>
    </message>
    <message>
        <source>By 20 mm on all sides, to give supports a base</source>
        <translation>Med 20 mm på alle sider, for å gi støtter et underlag</translation>
    </message>
    <message>
        <source>Adapt the layers</source>
        <translation>Tilpass lagene</translation>
    </message>
    <message>
        <source>Thinner layers on sloping surfaces, to reduce the gaps at steps</source>
        <translation>Tynnere lag på skrå overflater, for å redusere hullene ved trinn</translation>
    </message>
    <message>
        <source>Searches the orientation with the smallest area to support</source>
        <translation>Søker orienteringen med minst areal å støtte</translation>
    </message>
    <message>
        <source>Around a rod</source>
        <translation>Rundt en stang</translation>
    </message>
    <message>
        <source>On a given surface</source>
        <translation>På en gitt overflate</translation>
    </message>
    <message>
        <source>repair the mesh, or use curved mode, which takes any mesh</source>
        <translation>reparer meshen, eller bruk modus curved, som tar enhver mesh</translation>
    </message>
    <message>
        <source>a planar section of the mesh crosses itself</source>
        <translation>et plant snitt av meshen krysser seg selv</translation>
    </message>
    <message>
        <source>EGL cannot be initialized</source>
        <translation>EGL kan ikke initialiseres</translation>
    </message>
    <message>
        <source>EGL does not support platform displays</source>
        <translation>EGL støtter ikke plattformskjermer</translation>
    </message>
    <message>
        <source>its functions were not found</source>
        <translation>funksjonene ble ikke funnet</translation>
    </message>
    <message>
        <source>no context can be made</source>
        <translation>ingen kontekst kan opprettes</translation>
    </message>
    <message>
        <source>the context cannot be used</source>
        <translation>konteksten kan ikke brukes</translation>
    </message>
    <message>
        <source>Plate of the cell</source>
        <translation>Cellens byggeplate</translation>
    </message>
    <message>
        <source>cell {cell} has no plates</source>
        <translation>cellen {cell} har ingen byggeplater</translation>
    </message>
    <message>
        <source>choose another platform, or another cell</source>
        <translation>velg en annen plattform, eller en annen celle</translation>
    </message>
    <message>
        <source>copy it to a file first</source>
        <translation>kopier den til en fil først</translation>
    </message>
    <message>
        <source>give `--platform disc:DIAMETER`, or another platform</source>
        <translation>oppgi `--platform disc:DIAMETER`, eller en annen plattform</translation>
    </message>
    <message>
        <source>is not a regular file, but a device or a pipe</source>
        <translation>er ikke en vanlig fil, men en enhet eller et rør</translation>
    </message>
    <message>
        <source>check these places in the view; turn the part if they matter</source>
        <translation>kontroller disse stedene i visningen; roter delen hvis de betyr noe</translation>
    </message>
    <message>
        <source>no way of building supports platform {platform} in cell {cell}</source>
        <translation>ingen byggemåte støtter plattformen {platform} i cellen {cell}</translation>
    </message>
    <message>
        <source>plate of the cell</source>
        <translation>cellens byggeplate</translation>
    </message>
    <message>
        <source>transfers</source>
        <translation>forflytninger</translation>
    </message>
    <message>
        <source>{place}: skipped, because of a collision on the way to it</source>
        <translation>{place}: hoppet over på grunn av en kollisjon på veien dit</translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer away from the ends of {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}: ingen kollisjonsfri forflytning fra enden av {pieces} banestykke</numerusform>
            <numerusform>{place}: ingen kollisjonsfri forflytning fra endene av {pieces} banestykker</numerusform>
        </translation>
    </message>
    <message>
        <source>a mesh with defects cannot be cut into pieces</source>
        <translation>en mesh med feil kan ikke kuttes i stykker</translation>
    </message>
    <message>
        <source>&apos;{units}&apos; is not a unit of length</source>
        <translation>&apos;{units}&apos; er ikke en lengdeenhet</translation>
    </message>
    <message>
        <source>Scales it by 25.4</source>
        <translation>Skalerer den med 25,4</translation>
    </message>
    <message>
        <source>Scales it by 1000</source>
        <translation>Skalerer den med 1000</translation>
    </message>
    <message>
        <source>Scales it by 0.001</source>
        <translation>Skalerer den med 0,001</translation>
    </message>
    <message>
        <source>Large enough for the narrowest bead</source>
        <translation>Stor nok for den smaleste strengen</translation>
    </message>
    <message>
        <source>The largest scale within the robot&apos;s reach</source>
        <translation>Den største skalaen innenfor robotens rekkevidde</translation>
    </message>
    <message>
        <source>Centre the part</source>
        <translation>Sentrer delen</translation>
    </message>
    <message>
        <source>The file is in inches</source>
        <translation>Filen er i tommer</translation>
    </message>
    <message>
        <source>The file is in metres</source>
        <translation>Filen er i meter</translation>
    </message>
    <message>
        <source>The file is in micrometres</source>
        <translation>Filen er i mikrometer</translation>
    </message>
    <message>
        <source>On the platform&apos;s position</source>
        <translation>På plattformens posisjon</translation>
    </message>
    <message>
        <source>Print at scale {scale}</source>
        <translation>Print i skala {scale}</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Skaler til å passe</translation>
    </message>
    <message>
        <source>Use a finer process</source>
        <translation>Bruk en finere prosess</translation>
    </message>
    <message>
        <source>With the widest bead that fits these walls</source>
        <translation>Med den bredeste strengen som får plass i disse veggene</translation>
    </message>
    <message>
        <source>give one of {known}</source>
        <translation>oppgi en av {known}</translation>
    </message>
    <message>
        <source>give the units it was drawn in (`--units`)</source>
        <translation>oppgi enheten den ble tegnet i (`--units`)</translation>
    </message>
    <message>
        <source>centre the part, or use a platform that reaches its support</source>
        <translation>sentrer delen, eller bruk en plattform som når fram til underlaget sitt</translation>
    </message>
    <message>
        <source>print it at scale {scale}, or use a process with narrower beads</source>
        <translation>print den i skala {scale}, eller bruk en prosess med smalere strenger</translation>
    </message>
    <message>
        <source>print it smaller (`--scale fit`), or give the units it was drawn in (`--units`)</source>
        <translation>print den mindre (`--scale fit`), eller oppgi enheten den ble tegnet i (`--units`)</translation>
    </message>
    <message>
        <source>the part is very small: {size:.3g} long if its file is in millimetres</source>
        <translation>delen er svært liten: {size:.3g} lang hvis filen er i millimeter</translation>
    </message>
    <message>
        <source>the part is very large: {size:.4g} long if its file is in millimetres</source>
        <translation>delen er svært stor: {size:.4g} lang hvis filen er i millimeter</translation>
    </message>
    <message>
        <source>platform {distance:.0f} beside its support: it would float</source>
        <translation>plattformen er {distance:.0f} ved siden av underlaget sitt: den ville sveve</translation>
    </message>
    <message>
        <source>use a process with narrower beads; scaled up enough, the part is out of the robot&apos;s reach</source>
        <translation>bruk en prosess med smalere strenger; skalert opp nok er delen utenfor robotens rekkevidde</translation>
    </message>
    <message>
        <source>{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick</source>
        <translation>{share:.3g} av delen er tynnere enn den smaleste strengen ({least}); det meste er {usual:.2f} tykt</translation>
    </message>
    <message>
        <source>Use best orientation</source>
        <translation>Bruk beste orientering</translation>
    </message>
    <message>
        <source>Most contact relative to the overhang, and fewest missed voxels</source>
        <translation>Mest kontakt i forhold til overhenget, og færrest tapte voksler</translation>
    </message>
    <message>
        <source>give degrees about x, y and z: 90,0,0</source>
        <translation>oppgi grader om x, y og z: 90,0,0</translation>
    </message>
    <message>
        <source>use that orientation, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another one</source>
        <translation>bruk den orienteringen, rotert {x:.3g} om x, {y:.3g} om y og {z:.3g} om z, eller velg en annen</translation>
    </message>
    <message>
        <source>poor orientation: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} of the voxels missed; another orientation has contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} missed</source>
        <translation>dårlig orientering: kontakt {contact:.0f}, overheng {overhang:.0f}, {missed:.2g} av vokslene tapt; en annen orientering har kontakt {bestContact:.0f}, overheng {bestOverhang:.0f}, {bestMissed:.2g} tapt</translation>
    </message>
    <message>
        <source>turn &apos;{turn}&apos; is not three angles</source>
        <translation>rotasjonen &apos;{turn}&apos; er ikke tre vinkler</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>orienteringer</translation>
    </message>
    <message>
        <source>{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}</source>
        <translation>{length:.1f} av en streng er uten støtte; dette materialet bygger bro over {bridge:.1f}</translation>
    </message>
    <message>
        <source>use a pedestal made for the part: it leaves room for the print head; a drawing of it is written</source>
        <translation>bruk en sokkel laget for delen: den gir plass til skrivehodet; en tegning av den skrives</translation>
    </message>
    <message numerus="yes">
        <source>without columns, {here} voxels would be missed on this plate, {there} on a pedestal as wide as the part&apos;s footprint</source>
        <translation>
            <numerusform>uten søyler ville {here} voksel gå tapt på denne byggeplaten, {there} på en sokkel så bred som delens fotavtrykk</numerusform>
            <numerusform>uten søyler ville {here} voksler gå tapt på denne byggeplaten, {there} på en sokkel så bred som delens fotavtrykk</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;unitfactor&apos; is not above 0</source>
        <translation>&apos;unitfactor&apos; er ikke over 0</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not above 0, or too large</source>
        <translation>&apos;{attribute}&apos; er ikke over 0, eller for stor</translation>
    </message>
    <message>
        <source>&apos;{element}&apos; outside tool-paths</source>
        <translation>&apos;{element}&apos; utenfor verktøybaner</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; calls itself</source>
        <translation>&apos;{name}&apos; kaller seg selv</translation>
    </message>
    <message>
        <source>invalid call of &apos;{name}&apos;</source>
        <translation>ugyldig kall av &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; needs a mass</source>
        <translation>&apos;{name}&apos; krever en masse</translation>
    </message>
    <message>
        <source>&apos;{path}&apos; is not the name of a part in the package</source>
        <translation>&apos;{path}&apos; er ikke navnet på en del i pakken</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not allowed here: it changes the machine during the print</source>
        <translation>&apos;{word}&apos; er ikke tillatt her: det endrer maskinen under printen</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; slows the arm: the flow would not follow</source>
        <translation>&apos;{word}&apos; bremser armen: materialstrømmen ville ikke følge med</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; sets a different load</source>
        <translation>&apos;{word}&apos; angir en annen last</translation>
    </message>
    <message>
        <source>Prints a file along its own tool-paths (.build.3mf, .gcode). Off: plans new ones for its object.</source>
        <translation>Printer en fil langs filens egne verktøybaner (.build.3mf, .gcode). Av: planlegger nye for objektet.</translation>
    </message>
    <message>
        <source>Adds NAME.build.3mf: the plan&apos;s 6-axis tool-paths for other programs (3MF Toolpath Extension).</source>
        <translation>Legger til NAME.build.3mf: planens 6-aksede verktøybaner for andre programmer (3MF Toolpath Extension).</translation>
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
        <translation>Programmer</translation>
    </message>
    <message>
        <source>RAPID modules</source>
        <translation>RAPID-moduler</translation>
    </message>
    <message>
        <source>URScript for</source>
        <translation>URScript for</translation>
    </message>
    <message>
        <source>a TriggL before its TriggEquip</source>
        <translation>en TriggL før sin TriggEquip</translation>
    </message>
    <message>
        <source>a bead is printed by a joint motion instead of a straight one</source>
        <translation>en streng printes med en leddbevegelse i stedet for en rett bevegelse</translation>
    </message>
    <message>
        <source>unexpected control character: is this a binary file?</source>
        <translation>uventet kontrolltegn: er dette en binærfil?</translation>
    </message>
    <message>
        <source>use a larger nozzle, or slower tool-paths</source>
        <translation>bruk en større dyse, eller langsommere verktøybaner</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos; without a range above 0 or without a factor of e, f, g and h</source>
        <translation>en modifikator for &apos;{attribute}&apos; uten et område over 0 eller uten en faktor av e, f, g og h</translation>
    </message>
    <message>
        <source>an unsupported modifier of &apos;{attribute}&apos;</source>
        <translation>en modifikator for &apos;{attribute}&apos; som ikke støttes</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos;, which its profile lacks</source>
        <translation>en modifikator for &apos;{attribute}&apos;, som profilen mangler</translation>
    </message>
    <message>
        <source>a modifier of unknown type &apos;{type}&apos;</source>
        <translation>en modifikator av ukjent type &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>a modifier outside a profile</source>
        <translation>en modifikator utenfor en profil</translation>
    </message>
    <message>
        <source>a point more than a kilometre away</source>
        <translation>et punkt mer enn en kilometer unna</translation>
    </message>
    <message>
        <source>a point&apos;s frame has no direction</source>
        <translation>et punkts koordinatsystem har ingen retning</translation>
    </message>
    <message>
        <source>a second call outside the functions</source>
        <translation>et andre kall utenfor funksjonene</translation>
    </message>
    <message>
        <source>a segment of fewer than two points</source>
        <translation>et segment med færre enn to punkter</translation>
    </message>
    <message>
        <source>a segment of type &apos;{type}&apos; among tool-paths of {axes} axes</source>
        <translation>et segment av typen &apos;{type}&apos; blant verktøybaner med {axes} akser</translation>
    </message>
    <message>
        <source>a modifier&apos;s support point outside a point</source>
        <translation>en modifikators støttepunkt utenfor et punkt</translation>
    </message>
    <message>
        <source>threads are not supported</source>
        <translation>tråder støttes ikke</translation>
    </message>
    <message>
        <source>a tool-path is beyond the range of a build file</source>
        <translation>en verktøybane er utenfor området til en build-fil</translation>
    </message>
    <message>
        <source>a work object moved by both robot and external axis is not supported</source>
        <translation>et arbeidsobjekt som beveges av både robot og ekstern akse, støttes ikke</translation>
    </message>
    <message>
        <source>an unexpected {point}</source>
        <translation>et uventet {point}</translation>
    </message>
    <message>
        <source>a tool other than the printing one</source>
        <translation>et annet verktøy enn det som printer</translation>
    </message>
    <message>
        <source>requires the unknown extension &apos;{name}&apos;</source>
        <translation>krever den ukjente utvidelsen &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>at the controller&apos;s speeds, {share:.2f} of the bead length gets over 5 % too much or too little material</source>
        <translation>ved styringens hastigheter får {share:.2f} av strenglengden over 5 % for mye eller for lite materiale</translation>
    </message>
    <message>
        <source>bead {bead}</source>
        <translation>streng {bead}</translation>
    </message>
    <message>
        <source>choose an earlier or a later bead</source>
        <translation>velg en tidligere eller senere streng</translation>
    </message>
    <message>
        <source>choose an earlier place</source>
        <translation>velg et tidligere sted</translation>
    </message>
    <message>
        <source>factors of &apos;{attribute}&apos; are finer than its modifier&apos;s type allows</source>
        <translation>faktorene til &apos;{attribute}&apos; er finere enn modifikatorens type tillater</translation>
    </message>
    <message>
        <source>from the front (x to the right, z up)</source>
        <translation>forfra (x mot høyre, z opp)</translation>
    </message>
    <message>
        <source>from the side (y to the right, z up)</source>
        <translation>fra siden (y mot høyre, z opp)</translation>
    </message>
    <message>
        <source>give --program</source>
        <translation>oppgi --program</translation>
    </message>
    <message>
        <source>give --program, a file from {first} to {last}</source>
        <translation>oppgi --program, en fil fra {first} til {last}</translation>
    </message>
    <message>
        <source>choose the process that the tool-paths were made for</source>
        <translation>velg prosessen som verktøybanene ble laget for</translation>
    </message>
    <message>
        <source>gravity of an arm that is not upright</source>
        <translation>tyngdekraft for en arm som ikke står oppreist</translation>
    </message>
    <message>
        <source>has a document type, which is not accepted</source>
        <translation>har en dokumenttype, noe som ikke godtas</translation>
    </message>
    <message>
        <source>contains neither an object nor beads with width and height</source>
        <translation>inneholder verken et objekt eller strenger med bredde og høyde</translation>
    </message>
    <message>
        <source>contains no tool-paths</source>
        <translation>inneholder ingen verktøybaner</translation>
    </message>
    <message>
        <source>exceeds the limit of a joint of the robot</source>
        <translation>overskrider grensen for et av robotens ledd</translation>
    </message>
    <message>
        <source>is not a layer of tool-paths</source>
        <translation>er ikke et lag med verktøybaner</translation>
    </message>
    <message>
        <source>leave scale and units as they are, or give `givenToolPaths=false`</source>
        <translation>la skala og enhet være som de er, eller oppgi `givenToolPaths=false`</translation>
    </message>
    <message>
        <source>line {line} is ambiguous: the program has {count} files</source>
        <translation>linje {line} er tvetydig: programmet har {count} filer</translation>
    </message>
    <message>
        <source>mixed line ends: they differ from here on</source>
        <translation>blandede linjeslutt: de er ulike fra dette punktet</translation>
    </message>
    <message>
        <source>too much for a zip file</source>
        <translation>for mye for en zip-fil</translation>
    </message>
    <message>
        <source>more tool-path points than can be planned</source>
        <translation>flere verktøybanepunkter enn det kan planlegges</translation>
    </message>
    <message>
        <source>motions per file</source>
        <translation>bevegelser per fil</translation>
    </message>
    <message>
        <source>near singular poses the arm would deviate from the planned orientation</source>
        <translation>nær singulære positurer ville armen avvike fra planlagt orientering</translation>
    </message>
    <message>
        <source>no motion at or after line {line}</source>
        <translation>ingen bevegelse på eller etter linje {line}</translation>
    </message>
    <message>
        <source>no object in the file: the part is made from its beads</source>
        <translation>ikke noe objekt i filen: delen lages av strengene</translation>
    </message>
    <message>
        <source>not a program of this job</source>
        <translation>ikke et program fra denne jobben</translation>
    </message>
    <message>
        <source>not the definition of a function without arguments</source>
        <translation>ikke definisjonen av en funksjon uten argumenter</translation>
    </message>
    <message>
        <source>nothing is printed after that place</source>
        <translation>ingenting printes etter det stedet</translation>
    </message>
    <message>
        <source>the first of {count} sets of tool-paths was taken</source>
        <translation>det første av {count} sett med verktøybaner ble brukt</translation>
    </message>
    <message>
        <source>flow changes are only supported at the start of a motion</source>
        <translation>endringer i materialstrømmen støttes bare ved starten av en bevegelse</translation>
    </message>
    <message>
        <source>use the program for the cell&apos;s own controller</source>
        <translation>bruk programmet for cellens egen styring</translation>
    </message>
    <message>
        <source>stated payload {mass:.2f} kg, planned about {planned:.2f} kg</source>
        <translation>angitt nyttelast {mass:.2f} kg, planlagt ca. {planned:.2f} kg</translation>
    </message>
    <message>
        <source>the beads are too thin to be filled with cells</source>
        <translation>strengene er for tynne til å fylles med celler</translation>
    </message>
    <message>
        <source>the beads extend too far to be filled with cells</source>
        <translation>strengene strekker seg for langt til å fylles med celler</translation>
    </message>
    <message>
        <source>the build&apos;s tool-paths {id} are missing</source>
        <translation>verktøybanene {id} i build mangler</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is given twice</source>
        <translation>faktoren &apos;{factor}&apos; er oppgitt to ganger</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is not within 0 and 1</source>
        <translation>faktoren &apos;{factor}&apos; er ikke mellom 0 og 1</translation>
    </message>
    <message>
        <source>the file begins with a byte-order mark: save it as plain text</source>
        <translation>filen begynner med et BOM: lagre den som ren tekst</translation>
    </message>
    <message numerus="yes">
        <source>the file gives no width, height or speed for {points} points of its tool-paths: taken from process {process}</source>
        <translation>
            <numerusform>filen angir ikke bredde, høyde eller hastighet for {points} punkt i verktøybanene: hentet fra prosessen {process}</numerusform>
            <numerusform>filen angir ikke bredde, høyde eller hastighet for {points} punkter i verktøybanene: hentet fra prosessen {process}</numerusform>
        </translation>
    </message>
    <message>
        <source>the first motion is too fast: it begins at an unknown pose of the arm</source>
        <translation>den første bevegelsen er for rask: den begynner i en ukjent positur av armen</translation>
    </message>
    <message>
        <source>the frames of tool-paths point into the part; they were reversed</source>
        <translation>verktøybanenes koordinatsystemer peker inn i delen; de ble snudd</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is defined twice</source>
        <translation>funksjonen &apos;{defined}&apos; er definert to ganger</translation>
    </message>
    <message>
        <source>the job has no program to take the line from</source>
        <translation>jobben har ikke noe program linjen kan hentes fra</translation>
    </message>
    <message>
        <source>the job has no motion to resume</source>
        <translation>jobben har ingen bevegelse å gjenoppta</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; is not related to the model</source>
        <translation>laget &apos;{path}&apos; hører ikke til modellen</translation>
    </message>
    <message>
        <source>duplicate layer &apos;{path}&apos;</source>
        <translation>dobbelt lag &apos;{path}&apos;</translation>
    </message>
    <message>
        <source>computing the part printed so far</source>
        <translation>beregner delen som er printet så langt</translation>
    </message>
    <message>
        <source>the part {id} of a segment is not in its layer</source>
        <translation>del {id} i et segment finnes ikke i laget</translation>
    </message>
    <message>
        <source>the profile &apos;{uuid}&apos; is not in the model</source>
        <translation>profilen &apos;{uuid}&apos; finnes ikke i modellen</translation>
    </message>
    <message>
        <source>duplicate profile &apos;{uuid}&apos;</source>
        <translation>dobbel profil &apos;{uuid}&apos;</translation>
    </message>
    <message>
        <source>the profile {id} of a segment is not in its layer</source>
        <translation>profil {id} i et segment finnes ikke i laget</translation>
    </message>
    <message>
        <source>the robot must hold either the tool or the work object</source>
        <translation>roboten må holde enten verktøyet eller arbeidsobjektet</translation>
    </message>
    <message>
        <source>a modifier&apos;s support points do not increase between 0 and 1</source>
        <translation>en modifikators støttepunkter øker ikke mellom 0 og 1</translation>
    </message>
    <message>
        <source>the tool-paths of the part&apos;s file are damaged</source>
        <translation>verktøybanene i delens fil er skadet</translation>
    </message>
    <message>
        <source>unknown unit &apos;{unit}&apos;</source>
        <translation>ukjent enhet &apos;{unit}&apos;</translation>
    </message>
    <message>
        <source>the {format} program, for another controller, is not released: {failed}</source>
        <translation>{format}-programmet, for en annen styring, frigis ikke: {failed}</translation>
    </message>
    <message>
        <source>no bead {bead}: the plan has {beads} beads</source>
        <translation>ingen streng {bead}: planen har {beads} strenger</translation>
    </message>
    <message>
        <source>commanded acceleration is {times:.1f} times the planned one</source>
        <translation>kommandert akselerasjon er {times:.1f} ganger den planlagte</translation>
    </message>
    <message>
        <source>the tool-paths of a file cannot be scaled</source>
        <translation>verktøybanene i en fil kan ikke skaleres</translation>
    </message>
    <message>
        <source>tool-paths of the file</source>
        <translation>filens verktøybaner</translation>
    </message>
    <message>
        <source>two modifiers of &apos;{attribute}&apos; or with the same factor</source>
        <translation>to modifikatorer for &apos;{attribute}&apos; eller med samme faktor</translation>
    </message>
    <message>
        <source>unpacks to an implausible size</source>
        <translation>pakkes ut til en usannsynlig størrelse</translation>
    </message>
    <message>
        <source>unparsed text in a layer&apos;s data</source>
        <translation>utolket tekst i dataene til et lag</translation>
    </message>
    <message>
        <source>unparsed text in a tool-path&apos;s data</source>
        <translation>utolket tekst i dataene til en verktøybane</translation>
    </message>
    <message>
        <source>waits before and after tool-paths are left out</source>
        <translation>ventetider før og etter verktøybaner utelates</translation>
    </message>
    <message>
        <source>write a build file</source>
        <translation>skriv en build-fil</translation>
    </message>
    <message>
        <source>write verification reports</source>
        <translation>skriv verifikasjonsrapporter</translation>
    </message>
    <message>
        <source>write the program again, with times instead of speeds where the format supports them</source>
        <translation>skriv programmet på nytt, med tider i stedet for hastigheter der formatet støtter det</translation>
    </message>
    <message>
        <source>{celsius} °C is outside the printing range of {material}</source>
        <translation>{celsius} °C er utenfor temperaturområdet for {material}</translation>
    </message>
    <message>
        <source>{length:.0f} of filament retracted: out of the hot end</source>
        <translation>{length:.0f} filament trukket tilbake: ut av hotenden</translation>
    </message>
    <message>
        <source>{part}: verification report of the {format} program</source>
        <translation>{part}: verifikasjonsrapport for {format}-programmet</translation>
    </message>
    <message>
        <source>{place}: no collision-free transfer from home to the place where the print resumes</source>
        <translation>{place}: ingen kollisjonsfri forflytning fra hjemposisjonen til stedet der printen gjenopptas</translation>
    </message>
    <message numerus="yes">
        <source>{points} points of the file&apos;s tool-paths need more flow than the extruder&apos;s limit of {limit}: printed slower</source>
        <translation>
            <numerusform>{points} punkt i filens verktøybaner trenger mer materialstrøm enn ekstruderens grense på {limit}: printes langsommere</numerusform>
            <numerusform>{points} punkter i filens verktøybaner trenger mer materialstrøm enn ekstruderens grense på {limit}: printes langsommere</numerusform>
        </translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded before the first bead instead of {planned:.3f}</source>
        <translation>{volume:.3f} ekstruderes før den første strengen i stedet for {planned:.3f}</translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded here while the nozzle does not move for {time:.3f}</source>
        <translation>{volume:.3f} ekstruderes her mens dysen står stille i {time:.3f}</translation>
    </message>
    <message>
        <source>$APO.CDIS is not set before this motion</source>
        <translation>$APO.CDIS er ikke satt før denne bevegelsen</translation>
    </message>
    <message>
        <source>$IPO_MODE must be #BASE or #TCP</source>
        <translation>$IPO_MODE må være #BASE eller #TCP</translation>
    </message>
    <message>
        <source>$VEL.CP is not set before this motion</source>
        <translation>$VEL.CP er ikke satt før denne bevegelsen</translation>
    </message>
    <message>
        <source>&apos;ChangeTCP&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;ChangeTCP&apos; mellom PVTEnter og PVTExit</translation>
    </message>
    <message>
        <source>&apos;Cnt&apos; is 0, or 1 with two distances</source>
        <translation>&apos;Cnt&apos; er 0, eller 1 med to avstander</translation>
    </message>
    <message>
        <source>&apos;Dly&apos; without a time in seconds</source>
        <translation>&apos;Dly&apos; uten tid i sekunder</translation>
    </message>
    <message>
        <source>&apos;EMvs&apos; without work coordinates 1 to 8</source>
        <translation>&apos;EMvs&apos; uten arbeidskoordinater 1 til 8</translation>
    </message>
    <message>
        <source>&apos;Mvs&apos; and &apos;EMvs&apos; in one program: only one of them can move the nozzle</source>
        <translation>&apos;Mvs&apos; og &apos;EMvs&apos; i ett program: bare en av dem kan bevege dysen</translation>
    </message>
    <message>
        <source>&apos;PTP&apos; in millimetres per second</source>
        <translation>&apos;PTP&apos; i millimeter per sekund</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; needs 0 (joints) or 1 (poses)</source>
        <translation>&apos;PVTEnter&apos; krever 0 (ledd) eller 1 (positurer)</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; without PVTExit before it</source>
        <translation>&apos;PVTEnter&apos; uten PVTExit før</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; is missing before the end</source>
        <translation>&apos;PVTExit&apos; mangler før slutten</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; without PVTEnter before it</source>
        <translation>&apos;PVTExit&apos; uten PVTEnter før</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; needs six positions, six velocities and a time in seconds</source>
        <translation>&apos;PVTPoint&apos; krever seks posisjoner, seks hastigheter og en tid i sekunder</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; with an invalid time or velocity</source>
        <translation>&apos;PVTPoint&apos; med ugyldig tid eller hastighet</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; without PVTEnter before it</source>
        <translation>&apos;PVTPoint&apos; uten PVTEnter før</translation>
    </message>
    <message>
        <source>&apos;Wth&apos; without an output</source>
        <translation>&apos;Wth&apos; uten utgang</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; without a sensible value</source>
        <translation>&apos;{name}&apos; uten en fornuftig verdi</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is a frame that only the controller knows</source>
        <translation>&apos;{word}&apos; er et koordinatsystem som bare styringen kjenner</translation>
    </message>
    <message>
        <source>Motions shorter than {time} ms are stretched to that time and their flow is reduced to match.</source>
        <translation>Bevegelser kortere enn {time} ms strekkes til den tiden, og materialstrømmen reduseres tilsvarende.</translation>
    </message>
    <message>
        <source>Corners are passed without a stop, as if rounded by an arc with a deviation of {distance:.3g}.</source>
        <translation>Hjørner passeres uten stopp, som om de var rundet av en bue med et avvik på {distance:.3g}.</translation>
    </message>
    <message>
        <source>E1 is missing: an external axis moves the base</source>
        <translation>E1 mangler: en ekstern akse beveger basen</translation>
    </message>
    <message>
        <source>ENDDAT is missing: the file was cut short</source>
        <translation>ENDDAT mangler: filen er avkortet</translation>
    </message>
    <message>
        <source>G-code with B and C (a table that tilts and turns)</source>
        <translation>G-kode med B og C (et bord som tilter og roterer)</translation>
    </message>
    <message>
        <source>G-code with B and C: X distance of the plate&apos;s centre from the tilt axis.</source>
        <translation>G-kode med B og C: X-avstand fra tiltaksen til byggeplatens sentrum.</translation>
    </message>
    <message>
        <source>G-code with B and C: height of the plate&apos;s top above the tilt axis.</source>
        <translation>G-kode med B og C: høyden på byggeplatens overside over tiltaksen.</translation>
    </message>
    <message>
        <source>G-code with B and C: whether B and C are the right-handed rotation of the part, or that of the tool around a fixed part.</source>
        <translation>G-kode med B og C: om B og C er delens høyrehendte rotasjon, eller verktøyets rotasjon rundt en fast del.</translation>
    </message>
    <message>
        <source>Joint speeds are in percent: 100 % is assumed to be 180 degrees/s, so the times of these travels are estimates.</source>
        <translation>Leddhastigheter er i prosent: 100 % antas å være 180 grader/s, så tidene for disse tomkjøringene er anslag.</translation>
    </message>
    <message>
        <source>Joints accelerate at {acceleration:.0f}/s2 unless the program states otherwise.</source>
        <translation>Leddene akselererer med {acceleration:.0f}/s2 når programmet ikke angir noe annet.</translation>
    </message>
    <message>
        <source>KRL (KUKA)</source>
        <translation>KRL (KUKA)</translation>
    </message>
    <message>
        <source>KRL memory</source>
        <translation>KRL-minne</translation>
    </message>
    <message>
        <source>MELFA-BASIC V (Mitsubishi)</source>
        <translation>MELFA-BASIC V (Mitsubishi)</translation>
    </message>
    <message>
        <source>Programmed accelerations are used; where none is given, motion starts instantly.</source>
        <translation>Programmerte akselerasjoner brukes; der ingen er oppgitt, starter bevegelsen momentant.</translation>
    </message>
    <message>
        <source>No motion is shorter than the controller&apos;s cycle of {cycle} ms.</source>
        <translation>Ingen bevegelse er kortere enn styringens syklus på {cycle} ms.</translation>
    </message>
    <message>
        <source>Not tested on a machine: start slowly, with a cold extruder.</source>
        <translation>Ikke prøvd på en maskin: start langsomt, med kald ekstruder.</translation>
    </message>
    <message>
        <source>Plain G-code (three axes, flat jobs)</source>
        <translation>Enkel G-kode (tre akser, flate jobber)</translation>
    </message>
    <message>
        <source>Points of a bead closer than {time} ms or {way} are merged if the bead stays the same.</source>
        <translation>Punkter i en streng som er nærmere hverandre enn {time} ms eller {way}, slås sammen hvis strengen forblir den samme.</translation>
    </message>
    <message>
        <source>Power Low limits the speed: Power High is missing</source>
        <translation>Power Low begrenser hastigheten: Power High mangler</translation>
    </message>
    <message>
        <source>ROT, but the tool does not turn</source>
        <translation>ROT, men verktøyet roterer ikke</translation>
    </message>
    <message>
        <source>Program memory of the controller. Longer programs contain a note in their header.</source>
        <translation>Styringens programminne. Lengre programmer har en merknad i hodet.</translation>
    </message>
    <message>
        <source>SPEL+ (Epson)</source>
        <translation>SPEL+ (Epson)</translation>
    </message>
    <message>
        <source>ScriptExit() is missing at the end</source>
        <translation>ScriptExit() mangler på slutten</translation>
    </message>
    <message>
        <source>Straight motions accelerate at {acceleration} mm/s2 unless the program states otherwise.</source>
        <translation>Rette bevegelser akselererer med {acceleration} mm/s2 når programmet ikke angir noe annet.</translation>
    </message>
    <message>
        <source>TMscript (Techman)</source>
        <translation>TMscript (Techman)</translation>
    </message>
    <message>
        <source>The arm stops at points without a blend.</source>
        <translation>Armen stopper i punkter uten overgang.</translation>
    </message>
    <message>
        <source>Unlimited look-ahead.</source>
        <translation>Ubegrenset forhåndslesing.</translation>
    </message>
    <message>
        <source>Look-ahead of {motions} motions.</source>
        <translation>Forhåndslesing på {motions} bevegelser.</translation>
    </message>
    <message>
        <source>Output delays and following error are not modelled.</source>
        <translation>Utgangsforsinkelser og følgefeil er ikke modellert.</translation>
    </message>
    <message>
        <source>Tool rotation may be limited separately (1 rad = {way:.0f} of path); the slower of the two sets the flow.</source>
        <translation>Verktøyrotasjon kan ha en egen grense (1 rad = {way:.0f} av banen); den langsomste av de to bestemmer materialstrømmen.</translation>
    </message>
    <message>
        <source>WAIT SEC needs a number of seconds</source>
        <translation>WAIT SEC krever et antall sekunder</translation>
    </message>
    <message>
        <source>Wait needs a number of seconds</source>
        <translation>Wait krever et antall sekunder</translation>
    </message>
    <message>
        <source>a G0 under G93 has no defined time</source>
        <translation>en G0 under G93 har ingen definert tid</translation>
    </message>
    <message>
        <source>unsupported base: positions must be in the robot&apos;s own base</source>
        <translation>base som ikke støttes: posisjoner må være i robotens egen base</translation>
    </message>
    <message>
        <source>a base known only to the robot: give its numbers</source>
        <translation>en base som bare roboten kjenner: oppgi tallene</translation>
    </message>
    <message>
        <source>a blend is no sensible number</source>
        <translation>en overgang er ikke et fornuftig tall</translation>
    </message>
    <message>
        <source>unsupported call of another program</source>
        <translation>kall av et annet program støttes ikke</translation>
    </message>
    <message>
        <source>a coordinate is missing, and the arm&apos;s position is not known</source>
        <translation>en koordinat mangler, og armens posisjon er ikke kjent</translation>
    </message>
    <message>
        <source>the flow is not an integer from 0 to {most}</source>
        <translation>materialstrømmen er ikke et heltall fra 0 til {most}</translation>
    </message>
    <message>
        <source>the frame&apos;s length differs from the stated one</source>
        <translation>rammens lengde avviker fra den angitte</translation>
    </message>
    <message>
        <source>the frame is not a script for a listen node</source>
        <translation>rammen er ikke et skript for en Listen-node</translation>
    </message>
    <message>
        <source>wrong checksum: the frame was modified or truncated</source>
        <translation>feil sjekksum: rammen er endret eller avkortet</translation>
    </message>
    <message>
        <source>frame without a length</source>
        <translation>ramme uten lengde</translation>
    </message>
    <message>
        <source>frame without a name</source>
        <translation>ramme uten navn</translation>
    </message>
    <message>
        <source>load without a mass</source>
        <translation>last uten masse</translation>
    </message>
    <message>
        <source>a mass is no sensible number</source>
        <translation>en masse er ikke et fornuftig tall</translation>
    </message>
    <message>
        <source>another motion between PVTEnter and PVTExit</source>
        <translation>en annen bevegelse mellom PVTEnter og PVTExit</translation>
    </message>
    <message>
        <source>a pure rotation needs ROT</source>
        <translation>en ren rotasjon krever ROT</translation>
    </message>
    <message>
        <source>a motion without F: under G93 each motion needs its own</source>
        <translation>en bevegelse uten F: under G93 krever hver bevegelse sin egen</translation>
    </message>
    <message>
        <source>a motion without G93: its F is not a time</source>
        <translation>en bevegelse uten G93: F er ikke en tid</translation>
    </message>
    <message>
        <source>the numbers of the motion do not match its letters</source>
        <translation>tallene i bevegelsen stemmer ikke med bokstavene</translation>
    </message>
    <message>
        <source>a pose before ChangeTCP: its TCP is unknown</source>
        <translation>en positur før ChangeTCP: TCP-en er ukjent</translation>
    </message>
    <message>
        <source>a position before Tool: its TCP is unknown</source>
        <translation>en posisjon før Tool: TCP-en er ukjent</translation>
    </message>
    <message>
        <source>step longer than 127 characters</source>
        <translation>trinn lengre enn 127 tegn</translation>
    </message>
    <message>
        <source>a straight motion before any Spd</source>
        <translation>en rett bevegelse før noen Spd</translation>
    </message>
    <message>
        <source>a straight motion in percent of an unknown speed</source>
        <translation>en rett bevegelse i prosent av en ukjent hastighet</translation>
    </message>
    <message>
        <source>a straight motion to joints</source>
        <translation>en rett bevegelse til leddverdier</translation>
    </message>
    <message>
        <source>the target is not a position within a robot&apos;s reach</source>
        <translation>målet er ikke en posisjon innenfor en robots rekkevidde</translation>
    </message>
    <message>
        <source>a text has {characters} characters; the controller accepts at most {most}</source>
        <translation>en tekst har {characters} tegn; styringen godtar høyst {most}</translation>
    </message>
    <message>
        <source>a tool is a position</source>
        <translation>et verktøy er en posisjon</translation>
    </message>
    <message>
        <source>a tool known only to the robot: give its numbers</source>
        <translation>et verktøy som bare roboten kjenner: oppgi tallene</translation>
    </message>
    <message>
        <source>a tool, local or control point that only the controller knows</source>
        <translation>et verktøy, lokalt koordinatsystem eller kontrollpunkt som bare styringen kjenner</translation>
    </message>
    <message>
        <source>accelerations other than the arm&apos;s own</source>
        <translation>andre akselerasjoner enn armens egne</translation>
    </message>
    <message>
        <source>an acceleration is no sensible number</source>
        <translation>en akselerasjon er ikke et fornuftig tall</translation>
    </message>
    <message>
        <source>an analogue output outside 0 to 10 V</source>
        <translation>en analog utgang utenfor 0 til 10 V</translation>
    </message>
    <message>
        <source>an angle rotates the long way around</source>
        <translation>en vinkel går den lange veien rundt</translation>
    </message>
    <message>
        <source>an immediate output, not synchronized with the motions</source>
        <translation>en umiddelbar utgang, ikke synkronisert med bevegelsene</translation>
    </message>
    <message>
        <source>an output after CONTINUE runs ahead of the arm</source>
        <translation>en utgang etter CONTINUE løper foran armen</translation>
    </message>
    <message>
        <source>an output is 0 or 1</source>
        <translation>en utgang er 0 eller 1</translation>
    </message>
    <message>
        <source>an output of the extruder is set together with other outputs</source>
        <translation>en utgang for ekstruderen settes sammen med andre utganger</translation>
    </message>
    <message>
        <source>axes cannot be the target of a straight motion</source>
        <translation>akser kan ikke være målet for en rett bevegelse</translation>
    </message>
    <message>
        <source>format {format} cannot tilt the nozzle, but this job tilts it by {angle}</source>
        <translation>formatet {format} kan ikke tilte dysen, men denne jobben tilter den {angle}</translation>
    </message>
    <message>
        <source>how &apos;{word}&apos; rounds a corner is not known to the reader</source>
        <translation>hvordan &apos;{word}&apos; runder et hjørne, er ukjent for leseren</translation>
    </message>
    <message>
        <source>joints of a straight motion may be reached in another posture</source>
        <translation>leddene i en rett bevegelse kan nås i en annen stilling</translation>
    </message>
    <message>
        <source>omit it, or give --format {format}</source>
        <translation>utelat det, eller oppgi --format {format}</translation>
    </message>
    <message>
        <source>lines end with LF only: a listen node needs CR LF</source>
        <translation>linjene slutter bare med LF: en Listen-node krever CR LF</translation>
    </message>
    <message>
        <source>material before X, Y and Z are all known</source>
        <translation>materiale før X, Y og Z alle er kjent</translation>
    </message>
    <message>
        <source>material before X, Y, Z, B and C are all known</source>
        <translation>materiale før X, Y, Z, B og C alle er kjent</translation>
    </message>
    <message>
        <source>must be 1 or -1</source>
        <translation>må være 1 eller -1</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>må være true eller false</translation>
    </message>
    <message>
        <source>no {format} motion found: line {line}: {what}</source>
        <translation>ingen {format}-bevegelse funnet: linje {line}: {what}</translation>
    </message>
    <message>
        <source>no procedure is defined</source>
        <translation>ingen prosedyre er definert</translation>
    </message>
    <message>
        <source>no program calls this file</source>
        <translation>ikke noe program kaller denne filen</translation>
    </message>
    <message>
        <source>not all axes are given</source>
        <translation>ikke alle akser er oppgitt</translation>
    </message>
    <message>
        <source>invalid plate position relative to the tilt axis</source>
        <translation>ugyldig byggeplateposisjon i forhold til tiltaksen</translation>
    </message>
    <message>
        <source>end without a matching beginning</source>
        <translation>slutt uten tilsvarende begynnelse</translation>
    </message>
    <message>
        <source>no procedure of this file is called</source>
        <translation>ingen prosedyre i denne filen kalles</translation>
    </message>
    <message>
        <source>only triggers at the start of a motion are supported</source>
        <translation>bare triggere ved starten av en bevegelse støttes</translation>
    </message>
    <message>
        <source>only the persistent forms of output commands are supported</source>
        <translation>bare de vedvarende formene av utgangskommandoer støttes</translation>
    </message>
    <message>
        <source>the work coordinates change: only one nozzle is supported</source>
        <translation>arbeidskoordinatene endres: bare én dyse støttes</translation>
    </message>
    <message>
        <source>part {part}, job {job}, cell {cell} with robot {robot}</source>
        <translation>del {part}, jobb {job}, celle {cell} med robot {robot}</translation>
    </message>
    <message>
        <source>plate height above the tilt axis</source>
        <translation>byggeplatens høyde over tiltaksen</translation>
    </message>
    <message>
        <source>plate offset from the tilt axis</source>
        <translation>byggeplatens avstand fra tiltaksen</translation>
    </message>
    <message>
        <source>speed, acceleration time and blend must be integers</source>
        <translation>hastighet, akselerasjonstid og overgang må være heltall</translation>
    </message>
    <message>
        <source>step numbers must ascend, up to 32767</source>
        <translation>trinnumre må være stigende, opp til 32767</translation>
    </message>
    <message>
        <source>either the tool&apos;s path or that of the external control point is straight, not both</source>
        <translation>enten er verktøyets eller det eksterne kontrollpunktets bane rett, ikke begge</translation>
    </message>
    <message>
        <source>table angles describe</source>
        <translation>bordvinklene beskriver</translation>
    </message>
    <message>
        <source>use {formats}, or a mode with flat layers</source>
        <translation>bruk {formats}, eller en modus med flate lag</translation>
    </message>
    <message>
        <source>text after a frame</source>
        <translation>tekst etter en ramme</translation>
    </message>
    <message>
        <source>the velocity at the last PVT point is not 0</source>
        <translation>hastigheten i det siste PVT-punktet er ikke 0</translation>
    </message>
    <message>
        <source>the line has {characters} characters; the controller accepts at most {most}</source>
        <translation>linjen har {characters} tegn; styringen godtar høyst {most}</translation>
    </message>
    <message>
        <source>&apos;Type&apos; other than 0,0: the long way around, or independent rotation of the angles</source>
        <translation>&apos;Type&apos; ulik 0,0: den lange veien rundt, eller uavhengig rotasjon av vinklene</translation>
    </message>
    <message>
        <source>X or Y motion before B and C are known</source>
        <translation>X- eller Y-bevegelse før B og C er kjent</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>delen</translation>
    </message>
    <message>
        <source>the procedure has no end</source>
        <translation>prosedyren har ingen slutt</translation>
    </message>
    <message>
        <source>the program has no End</source>
        <translation>programmet har ingen End</translation>
    </message>
    <message>
        <source>the program is for another cell: {program}; this job is {job}</source>
        <translation>programmet er for en annen celle: {program}; denne jobben er {job}</translation>
    </message>
    <message>
        <source>the program is from another job: {program}; this job is {job}</source>
        <translation>programmet er fra en annen jobb: {program}; denne jobben er {job}</translation>
    </message>
    <message>
        <source>the called program {name} is missing</source>
        <translation>det kalte programmet {name} mangler</translation>
    </message>
    <message>
        <source>table motion before Z is known: the nozzle may be down</source>
        <translation>bordbevegelse før Z er kjent: dysen kan være nede</translation>
    </message>
    <message>
        <source>the tool (ISO 841)</source>
        <translation>verktøyet (ISO 841)</translation>
    </message>
    <message>
        <source>the tool does not turn evenly along its way</source>
        <translation>verktøyet roterer ikke jevnt langs banen</translation>
    </message>
    <message>
        <source>the velocities lead off the path to this point</source>
        <translation>hastighetene fører bort fra banen til dette punktet</translation>
    </message>
    <message>
        <source>work coordinates that P_WkCord does not set</source>
        <translation>arbeidskoordinater som P_WkCord ikke setter</translation>
    </message>
    <message>
        <source>{frame} is not set before this motion</source>
        <translation>{frame} er ikke satt før denne bevegelsen</translation>
    </message>
    <message>
        <source>{option} applies to {having}, but the chosen formats are {formats}</source>
        <translation>{option} gjelder for {having}, men de valgte formatene er {formats}</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is missing</source>
        <translation>&apos;{attribute}&apos; mangler</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; must be three numbers: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; må være tre tall: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>expand it first: xacro FILE &gt; arm.urdf</source>
        <translation>ekspander den først: xacro FIL &gt; arm.urdf</translation>
    </message>
    <message>
        <source>the chain from &apos;{base}&apos; to &apos;{tip}&apos; has {count} turning axes; six are needed</source>
        <translation>kjeden fra &apos;{base}&apos; til &apos;{tip}&apos; har {count} roterende akser; seks trengs</translation>
    </message>
    <message>
        <source>choose another home pose for the cell; if only the enclosing shapes of two links overlap, list the pair under neverMeet in the robot&apos;s file</source>
        <translation>velg en annen hjempositur for cellen; hvis bare de omsluttende formene til to armsegmenter overlapper, oppgi paret under neverMeet i robotens fil</translation>
    </message>
    <message>
        <source>has no links</source>
        <translation>har ingen armsegmenter</translation>
    </message>
    <message>
        <source>has no tip: no joint moves</source>
        <translation>har ingen spiss: ingen ledd beveger seg</translation>
    </message>
    <message>
        <source>has several tips: {names}</source>
        <translation>har flere spisser: {names}</translation>
    </message>
    <message>
        <source>has two bases, &apos;{first}&apos; and &apos;{second}&apos;: no joint leads from one to the other</source>
        <translation>har to baser, &apos;{first}&apos; og &apos;{second}&apos;: ingen ledd fører fra den ene til den andre</translation>
    </message>
    <message>
        <source>is a xacro file</source>
        <translation>er en xacro-fil</translation>
    </message>
    <message>
        <source>is not a URDF: it begins with &lt;{element}&gt;</source>
        <translation>er ikke en URDF: den begynner med &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; mimics &apos;{other}&apos;: mimic joints are not supported</source>
        <translation>leddet &apos;{joint}&apos; etterligner &apos;{other}&apos;: mimic-ledd støttes ikke</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an axis of zero length</source>
        <translation>leddet &apos;{joint}&apos; har en akse med lengde null</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the lower limit is not below the upper one</source>
        <translation>leddet &apos;{joint}&apos;: den nedre grensen er ikke under den øvre</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an unknown type: &apos;{type}&apos;</source>
        <translation>leddet &apos;{joint}&apos; har ukjent type: &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; is {type}; only turning joints are supported</source>
        <translation>leddet &apos;{joint}&apos; er {type}; bare roterende ledd støttes</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; names an unknown link: &apos;{link}&apos;</source>
        <translation>leddet &apos;{joint}&apos; angir et ukjent armsegment: &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; has two parent joints, &apos;{first}&apos; and &apos;{second}&apos;: loops are not supported</source>
        <translation>armsegmentet &apos;{link}&apos; har to overordnede ledd, &apos;{first}&apos; og &apos;{second}&apos;: sløyfer støttes ikke</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; is part of a loop: loops are not supported</source>
        <translation>armsegmentet &apos;{link}&apos; er del av en sløyfe: sløyfer støttes ikke</translation>
    </message>
    <message>
        <source>name one: --tip</source>
        <translation>oppgi en: --tip</translation>
    </message>
    <message>
        <source>name the first and last link of the chain: --base, --tip</source>
        <translation>oppgi første og siste armsegment i kjeden: --base, --tip</translation>
    </message>
    <message>
        <source>the base &apos;{base}&apos; is on a moving branch off the chain to &apos;{tip}&apos;</source>
        <translation>basen &apos;{base}&apos; er på en bevegelig gren utenfor kjeden til &apos;{tip}&apos;</translation>
    </message>
    <message>
        <source>two links are named &apos;{link}&apos;</source>
        <translation>to armsegmenter heter &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the home pose: no motion is possible</source>
        <translation>{first} kolliderer med {second} i hjemposituren: ingen bevegelse er mulig</translation>
    </message>
    <message>
        <source>{option}: no link is named &apos;{name}&apos;</source>
        <translation>{option}: ikke noe armsegment heter &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>In a PolyScope file node the function must be called after its end. Text sent to port 30001 or 30002 runs by itself and must not call it.</source>
        <translation>I en PolyScope-filnode må funksjonen kalles etter slutten. Tekst sendt til port 30001 eller 30002 kjører av seg selv og må ikke kalle den.</translation>
    </message>
    <message>
        <source>a file node</source>
        <translation>en filnode</translation>
    </message>
    <message>
        <source>a port</source>
        <translation>en port</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an extruder command</source>
        <translation>&apos;{text}&apos; er ikke en ekstruderkommando</translation>
    </message>
    <message>
        <source>Like an ordinary printer, with the nozzle upright</source>
        <translation>Som en vanlig printer, med loddrett dyse</translation>
    </message>
    <message>
        <source>Filament retracted for each travel, if the extruder can; 0: none.</source>
        <translation>Filament som trekkes tilbake ved hver tomkjøring, hvis ekstruderen kan det; 0: ingenting.</translation>
    </message>
    <message>
        <source>Fills the nozzle before the part begins: on the plate, or in the air beside it if there is no room. The material is waste.</source>
        <translation>Fyller dysen før delen begynner: på byggeplaten, eller i luften ved siden av hvis det ikke er plass. Materialet er avfall.</translation>
    </message>
    <message>
        <source>Length of the line beside the part.</source>
        <translation>Lengden på linjen ved siden av delen.</translation>
    </message>
    <message>
        <source>Print in flat layers</source>
        <translation>Print i flate lag</translation>
    </message>
    <message>
        <source>the filament diameter is out of range</source>
        <translation>filamentdiameteren er utenfor området</translation>
    </message>
    <message>
        <source>a line beside the part</source>
        <translation>en linje ved siden av delen</translation>
    </message>
    <message>
        <source>a motion is missing or repeated in the filament stream</source>
        <translation>en bevegelse mangler eller er gjentatt i filamentstrømmen</translation>
    </message>
    <message>
        <source>a ring around the part</source>
        <translation>en ring rundt delen</translation>
    </message>
    <message>
        <source>a text to be sent is needed</source>
        <translation>en tekst som skal sendes, trengs</translation>
    </message>
    <message>
        <source>an external axis after an unused one is not supported</source>
        <translation>en ekstern akse etter en ubrukt akse støttes ikke</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>ekstruder</translation>
    </message>
    <message>
        <source>retraction</source>
        <translation>tilbaketrekking</translation>
    </message>
    <message>
        <source>the filament position decreases</source>
        <translation>filamentposisjonen avtar</translation>
    </message>
    <message>
        <source>format {format} cannot control extruder {extruder} in step with the motion</source>
        <translation>formatet {format} kan ikke styre ekstruderen {extruder} i takt med bevegelsen</translation>
    </message>
    <message>
        <source>has a name that is already used: &apos;{name}&apos;</source>
        <translation>har et navn som allerede er i bruk: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>must have minMm below maxMm</source>
        <translation>må ha minMm under maxMm</translation>
    </message>
    <message>
        <source>first-layer bead width</source>
        <translation>strengbredde på første lag</translation>
    </message>
    <message>
        <source>Nominal bead width of the first layer and the brim; limited by the process. 0: that of the process.</source>
        <translation>Nominell strengbredde på første lag og bremmen; begrenset av prosessen. 0: som prosessen.</translation>
    </message>
    <message>
        <source>outer-wall speed</source>
        <translation>hastighet for ytre vegg</translation>
    </message>
    <message>
        <source>Speed of the outermost walls. 0: that of the process.</source>
        <translation>Hastighet for de ytterste veggene. 0: som prosessen.</translation>
    </message>
    <message>
        <source>inner-wall speed</source>
        <translation>hastighet for indre vegger</translation>
    </message>
    <message>
        <source>Speed of all other walls. 0: that of the process.</source>
        <translation>Hastighet for alle andre vegger. 0: som prosessen.</translation>
    </message>
    <message>
        <source>infill speed</source>
        <translation>fyllhastighet</translation>
    </message>
    <message>
        <source>Speed of solid infill and gap fill, limited by the extruder&apos;s flow. 0: that of the process.</source>
        <translation>Hastighet for massivt fyll og spaltefyll, begrenset av ekstruderens materialstrøm. 0: som prosessen.</translation>
    </message>
    <message>
        <source>support speed</source>
        <translation>støttehastighet</translation>
    </message>
    <message>
        <source>Speed of supports. 0: that of the process.</source>
        <translation>Hastighet for støtter. 0: som prosessen.</translation>
    </message>
    <message>
        <source>first-layer speed</source>
        <translation>hastighet på første lag</translation>
    </message>
    <message>
        <source>Speed of all beads of the first layer and of the brim. 0: that of the process.</source>
        <translation>Hastighet for alle strenger i første lag og bremmen. 0: som prosessen.</translation>
    </message>
    <message>
        <source>brim width</source>
        <translation>brembredde</translation>
    </message>
    <message>
        <source>Width of the loops on the plate around the first layer, which keep it from lifting; break them off after printing. 0: no brim.</source>
        <translation>Bredden av sløyfene på byggeplaten rundt første lag, som hindrer det i å løfte seg; brekk dem av etter printing. 0: ingen brem.</translation>
    </message>
    <message>
        <source>no room on the plate for the whole brim, {width} wide: {share:.0f} of its length is left out</source>
        <translation>ikke plass på byggeplaten til hele bremmen, {width} bred: {share:.0f} av lengden utelates</translation>
    </message>
    <message>
        <source>use a larger plate (`--platform`), move the part to the middle, or set a smaller `brimWidthMm`</source>
        <translation>bruk en større byggeplate (`--platform`), flytt delen til midten, eller sett en mindre `brimWidthMm`</translation>
    </message>
    <message>
        <source>must be between {least} and {most}</source>
        <translation>må være mellom {least} og {most}</translation>
    </message>
    <message>
        <source>where the travel is shortest</source>
        <translation>der tomkjøringen er kortest</translation>
    </message>
    <message>
        <source>aligned from layer to layer</source>
        <translation>på linje fra lag til lag</translation>
    </message>
    <message>
        <source>in a corner</source>
        <translation>i et hjørne</translation>
    </message>
    <message>
        <source>spread over the part</source>
        <translation>spredt over delen</translation>
    </message>
    <message>
        <source>unknown seam &apos;{id}&apos;</source>
        <translation>ukjent søm &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>søm</translation>
    </message>
    <message>
        <source>Where closed walls begin and end. A seam aligned or in a corner is less visible; spread seams weaken the part least.</source>
        <translation>Der lukkede vegger begynner og slutter. En søm på linje eller i et hjørne er mindre synlig; spredte sømmer svekker delen minst.</translation>
    </message>
    <message>
        <source>shortest travel</source>
        <translation>korteste tomkjøring</translation>
    </message>
    <message>
        <source>as sliced</source>
        <translation>som slicet</translation>
    </message>
    <message>
        <source>order of islands</source>
        <translation>rekkefølge på øyer</translation>
    </message>
    <message>
        <source>Order in which separate islands of a flat layer are printed.</source>
        <translation>Rekkefølgen atskilte øyer i et flatt lag printes i.</translation>
    </message>
    <message>
        <source>Prints the part as one continuous bead of rising height on its bottom layers: one wall, without infill, top layers and supports under low overhangs.</source>
        <translation>Printer delen som én sammenhengende streng med økende høyde på bunnlagene: én vegg, uten fyll, topplag og støtter under lave overheng.</translation>
    </message>
    <message>
        <source>spiral vase</source>
        <translation>spiralvase</translation>
    </message>
    <message>
        <source>prime length</source>
        <translation>primelengde</translation>
    </message>
    <message>
        <source>must be empty: the plate is on the flange</source>
        <translation>må være tom: byggeplaten er på flensen</translation>
    </message>
    <message>
        <source>too many: robot and external axes together may have {most} axes</source>
        <translation>for mange: robot og eksterne akser kan til sammen ha {most} akser</translation>
    </message>
    <message>
        <source>must be turning or sliding, is &apos;{kind}&apos;</source>
        <translation>må være turning eller sliding, er &apos;{kind}&apos;</translation>
    </message>
    <message>
        <source>must not be zero</source>
        <translation>må ikke være null</translation>
    </message>
    <message>
        <source>must turn the rod about its own axis, the work frame&apos;s x</source>
        <translation>må dreie stangen om dens egen akse, x i arbeidskoordinatsystemet</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>priming</translation>
    </message>
    <message>
        <source>use extruder {extruders}</source>
        <translation>bruk ekstruderen {extruders}</translation>
    </message>
    <message>
        <source>the extruder is switched on or off where that is not possible</source>
        <translation>ekstruderen slås på eller av der det ikke er mulig</translation>
    </message>
    <message>
        <source>the extruder reverses while the nozzle moves</source>
        <translation>ekstruderen går bakover mens dysen beveger seg</translation>
    </message>
    <message>
        <source>the extruder runs where the program does not pause</source>
        <translation>ekstruderen går der programmet ikke tar pause</translation>
    </message>
    <message>
        <source>the extruder runs where the program has switched it off</source>
        <translation>ekstruderen går der programmet har slått den av</translation>
    </message>
    <message>
        <source>the retracted filament is not returned before the bead</source>
        <translation>det tilbaketrukne filamentet er ikke matet fram igjen før strengen</translation>
    </message>
    <message>
        <source>the file {file} begins with {procedure}: a module must have the name of its first procedure</source>
        <translation>filen {file} begynner med {procedure}: en modul må ha samme navn som sin første prosedyre</translation>
    </message>
    <message>
        <source>the filament stream has no end: the file is truncated</source>
        <translation>filamentstrømmen har ingen slutt: filen er avkortet</translation>
    </message>
    <message>
        <source>the filament stream has no entry for this motion</source>
        <translation>filamentstrømmen har ingen oppføring for denne bevegelsen</translation>
    </message>
    <message>
        <source>this arm keeps the nozzle upright, but the layers need it tilted, first at {place}</source>
        <translation>denne armen holder dysen loddrett, men lagene trenger den tiltet, først ved {place}</translation>
    </message>
    <message>
        <source>time decreases in the filament stream</source>
        <translation>tiden avtar i filamentstrømmen</translation>
    </message>
    <message>
        <source>unknown extruder &apos;{id}&apos;</source>
        <translation>ukjent ekstruder &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>use mode flat, or planar with upright layers</source>
        <translation>bruk modus flat, eller planar med loddrette lag</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}/s, above its limit of {limit:.1f#}</source>
        <translation>{joint} med {speed:.1f}/s, over grensen på {limit:.1f#}</translation>
    </message>
    <message>
        <source>Castelli serial</source>
        <translation>Castelli seriell</translation>
    </message>
    <message>
        <source>E stream</source>
        <translation>E-strøm</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>utganger</translation>
    </message>
    <message>
        <source>the cell&apos;s</source>
        <translation>cellens</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is NaN or out of range: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; er NaN eller utenfor området: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is a built-in cell</source>
        <translation>&apos;{id}&apos; er en innebygd celle</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is not a valid cell name</source>
        <translation>&apos;{id}&apos; er ikke et gyldig cellenavn</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a number</source>
        <translation>&apos;{word}&apos; er ikke et tall</translation>
    </message>
    <message>
        <source>How rotations about the nozzle are smoothed: quickly, or by a search for minimum joint jerk, which doubles the planning time of the motion.</source>
        <translation>Hvordan rotasjoner om dysen glattes: raskt, eller ved et søk etter minst leddrykk, som dobler planleggingstiden for bevegelsen.</translation>
    </message>
    <message>
        <source>Reached poses</source>
        <translation>Nådde positurer</translation>
    </message>
    <message>
        <source>a frame needs at least three points</source>
        <translation>et koordinatsystem krever minst tre punkter</translation>
    </message>
    <message>
        <source>a measured number is not finite</source>
        <translation>et målt tall er ikke endelig</translation>
    </message>
    <message>
        <source>a quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>lengden av en kvaternion er {length:.4g}, ikke 1</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is the name of a built-in robot</source>
        <translation>&apos;{id}&apos; er navnet på en innebygd robot</translation>
    </message>
    <message>
        <source>a row contains the robot&apos;s joints</source>
        <translation>en rad inneholder robotens ledd</translation>
    </message>
    <message>
        <source>a row contains x,y,z,qw,qx,qy,qz; for joints name the robot</source>
        <translation>en rad inneholder x,y,z,qw,qx,qy,qz; for ledd, oppgi roboten</translation>
    </message>
    <message>
        <source>a tool tip needs at least four poses</source>
        <translation>en verktøyspiss krever minst fire positurer</translation>
    </message>
    <message>
        <source>in the home pose {first} collides with {second}</source>
        <translation>i hjemposituren kolliderer {first} med {second}</translation>
    </message>
    <message>
        <source>bring plate and nozzle nearer to the arm</source>
        <translation>flytt byggeplate og dyse nærmere armen</translation>
    </message>
    <message>
        <source>cannot be read: not a mesh, or damaged</source>
        <translation>kan ikke leses: ikke en mesh, eller skadet</translation>
    </message>
    <message>
        <source>cannot be read: voluta-mesh-reader is missing beside this program</source>
        <translation>kan ikke leses: voluta-mesh-reader mangler ved siden av dette programmet</translation>
    </message>
    <message>
        <source>cell {cell} has no plate to map</source>
        <translation>cellen {cell} har ingen byggeplate å kartlegge</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>glattet</translation>
    </message>
    <message>
        <source>give the arm another name: --id</source>
        <translation>gi armen et annet navn: --id</translation>
    </message>
    <message>
        <source>give three rows x,y,z (origin, point on x, point in the xy plane), or at least three rows of six: nominal point in the frame, touched point</source>
        <translation>oppgi tre rader x,y,z (origo, punkt på x, punkt i xy-planet), eller minst tre rader med seks: nominelt punkt i koordinatsystemet, målt punkt</translation>
    </message>
    <message>
        <source>is damaged: the reader failed</source>
        <translation>er skadet: leseren mislyktes</translation>
    </message>
    <message>
        <source>minimum jerk of whole paths</source>
        <translation>minst rykk over hele baner</translation>
    </message>
    <message>
        <source>jerk of joint {joint} at its greatest here: {jerk:.3g} rad/s³, limit {limit:.3g} rad/s³</source>
        <translation>rykket i ledd {joint} er størst her: {jerk:.3g} rad/s³, grense {limit:.3g} rad/s³</translation>
    </message>
    <message>
        <source>smooth whole paths (`rotationSmoothing=wholePath`), print slower, or allow more jerk (`maxJerk`)</source>
        <translation>glatt hele baner (`rotationSmoothing=wholePath`), print langsommere, eller tillat mer rykk (`maxJerk`)</translation>
    </message>
    <message>
        <source>maximum jerk</source>
        <translation>maksimalt rykk</translation>
    </message>
    <message>
        <source>Maximum jerk of every joint; for a sliding joint 100 mm count as 1 rad. The robot moves more slowly where a joint would exceed it, and speeds up and slows down more gently. 0: no limit.</source>
        <translation>Maksimalt rykk for hvert ledd; for et glidende ledd regnes 100 mm som 1 rad. Roboten går langsommere der et ledd ville overskride det, og akselererer og bremser mykere. 0: ingen grense.</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>former</translation>
    </message>
    <message>
        <source>shapes, and a learned indicator</source>
        <translation>former, og en lært indikator</translation>
    </message>
    <message>
        <source>collision model</source>
        <translation>kollisjonsmodell</translation>
    </message>
    <message>
        <source>How a search for minimum joint jerk of whole paths avoids collisions: by checks of the shapes afterwards, or also by the gradient of an indicator that is learned for each layer (for research; slow). The shapes decide in both cases.</source>
        <translation>Hvordan et søk etter minst leddrykk over hele baner unngår kollisjoner: ved kontroll av formene etterpå, eller også med gradienten av en indikator som læres for hvert lag (for forskning; langsomt). Formene avgjør i begge tilfeller.</translation>
    </message>
    <message>
        <source>with the nozzle lifted</source>
        <translation>med løftet dyse</translation>
    </message>
    <message>
        <source>while printing, if possible</source>
        <translation>under printing, om mulig</translation>
    </message>
    <message>
        <source>change of the arm&apos;s branch</source>
        <translation>skifte av armens gren</translation>
    </message>
    <message>
        <source>Where the arm cannot print a whole path in one branch: whether the path is interrupted there, or the wrist changes over several points while printing, with the nozzle tilted within the tilt tolerance.</source>
        <translation>Der armen ikke kan printe en hel bane i én gren: om banen avbrytes der, eller om håndleddet skifter over flere punkter under printing, med dysen tiltet innenfor tilttoleransen.</translation>
    </message>
    <message>
        <source>remove the row, or measure it again</source>
        <translation>fjern raden, eller mål den på nytt</translation>
    </message>
    <message>
        <source>lengths in a URDF are metres</source>
        <translation>lengder i en URDF er i meter</translation>
    </message>
    <message>
        <source>check the limits and solids in the description, or name its links: --base, --tip</source>
        <translation>kontroller grensene og legemene i beskrivelsen, eller oppgi segmentene: --base, --tip</translation>
    </message>
    <message>
        <source>reduce the payload, or use a stronger robot</source>
        <translation>reduser nyttelasten, eller bruk en sterkere robot</translation>
    </message>
    <message>
        <source>measure another point</source>
        <translation>mål et punkt til</translation>
    </message>
    <message>
        <source>measure another pose</source>
        <translation>mål en positur til</translation>
    </message>
    <message>
        <source>measure three points</source>
        <translation>mål tre punkter</translation>
    </message>
    <message>
        <source>move one of them, or choose another home pose</source>
        <translation>flytt en av dem, eller velg en annen hjempositur</translation>
    </message>
    <message>
        <source>move one of them, or make the stem or the nozzle longer</source>
        <translation>flytt en av dem, eller gjør stammen eller dysen lengre</translation>
    </message>
    <message>
        <source>move the nozzle&apos;s frame</source>
        <translation>flytt dysens koordinatsystem</translation>
    </message>
    <message>
        <source>no folder for user-defined cells</source>
        <translation>ingen mappe for egendefinerte celler</translation>
    </message>
    <message>
        <source>not a table of points</source>
        <translation>ikke en punkttabell</translation>
    </message>
    <message>
        <source>searching a place for the plate</source>
        <translation>søker en plass for byggeplaten</translation>
    </message>
    <message>
        <source>poses {first} and {second} are identical</source>
        <translation>positurene {first} og {second} er like</translation>
    </message>
    <message>
        <source>set HOME, or VOLUTA_DATA to a folder</source>
        <translation>sett HOME, eller sett VOLUTA_DATA til en mappe</translation>
    </message>
    <message>
        <source>smoothing of rotations</source>
        <translation>glatting av rotasjoner</translation>
    </message>
    <message>
        <source>use a cell with a plate</source>
        <translation>bruk en celle med byggeplate</translation>
    </message>
    <message>
        <source>measure a point well off the line through the others</source>
        <translation>mål et punkt godt utenfor linjen gjennom de andre</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>velg et annet navn</translation>
    </message>
    <message>
        <source>takes too long to read</source>
        <translation>tar for lang tid å lese</translation>
    </message>
    <message>
        <source>no place found where the arm reaches above a plate without collision (reach {reach} mm)</source>
        <translation>fant ingen plass der armen når over en byggeplate uten kollisjon (rekkevidde {reach} mm)</translation>
    </message>
    <message>
        <source>implausible reach of the arm: {reach} mm</source>
        <translation>usannsynlig rekkevidde for armen: {reach} mm</translation>
    </message>
    <message>
        <source>the arm&apos;s description</source>
        <translation>armens beskrivelse</translation>
    </message>
    <message>
        <source>payload {carried:.3g} kg exceeds the robot&apos;s rating of {most:.3g} kg</source>
        <translation>nyttelasten på {carried:.3g} kg overskrider robotens bæreevne på {most:.3g} kg</translation>
    </message>
    <message>
        <source>must be larger than that of the point before</source>
        <translation>må være større enn for punktet før</translation>
    </message>
    <message>
        <source>must not be larger than that of the point before</source>
        <translation>må ikke være større enn for punktet før</translation>
    </message>
    <message>
        <source>must have at least one point</source>
        <translation>må ha minst ett punkt</translation>
    </message>
    <message>
        <source>fixed nozzle</source>
        <translation>fast dyse</translation>
    </message>
    <message>
        <source>tilting table</source>
        <translation>tiltbord</translation>
    </message>
    <message>
        <source>raised plate</source>
        <translation>hevet byggeplate</translation>
    </message>
    <message>
        <source>table on the floor</source>
        <translation>bord på gulvet</translation>
    </message>
    <message>
        <source>it prints around a rod</source>
        <translation>den printer rundt en stang</translation>
    </message>
    <message>
        <source>its largest plate is too small for the foot, which fits at scale {scale}</source>
        <translation>den største byggeplaten er for liten for foten, som passer i skala {scale}</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg at {lever:.0f}, the robot carries {most:.3g} kg there</source>
        <translation>flensen ville bære {kg:.3g} kg ved {lever:.0f}, roboten bærer {most:.3g} kg der</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg, the robot&apos;s rating is {most:.3g} kg</source>
        <translation>flensen ville bære {kg:.3g} kg, robotens bæreevne er {most:.3g} kg</translation>
    </message>
    <message>
        <source>its nozzle cannot tilt</source>
        <translation>dysen kan ikke tilte</translation>
    </message>
    <message>
        <source>its head is too bulky to lean</source>
        <translation>hodet er for klumpete til å helle</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the part upright</source>
        <translation>dysen når {share:.0f} av delen i loddrett stilling</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the poses up to a tilt of {tilt:.0f}</source>
        <translation>dysen når {share:.0f} av positurene opp til en tilt på {tilt:.0f}</translation>
    </message>
    <message>
        <source>no cell with a fixed nozzle is among them</source>
        <translation>det er ingen celle med fast dyse blant dem</translation>
    </message>
    <message>
        <source>{cell} is out: {reason}</source>
        <translation>{cell} er utelukket: {reason}</translation>
    </message>
    <message>
        <source>{cell}: its fixed nozzle stays upright, so gravity helps; the platform may be small, and the arm carries plate and part ({kg:.3g} kg)</source>
        <translation>{cell}: den faste dysen forblir loddrett, så tyngdekraften hjelper; plattformen kan være liten, og armen bærer byggeplate og del ({kg:.3g} kg)</translation>
    </message>
    <message>
        <source>{cell}: its table tilts the part, so gravity helps; {fixed}</source>
        <translation>{cell}: bordet tilter delen, så tyngdekraften hjelper; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves and takes large parts, and the raised plate stays small for a leaning head, but gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}: dysen beveger seg og klarer store deler, og den hevede byggeplaten forblir liten for et hode som heller, men tyngdekraften hjelper ikke ved opptil {lean:.0f} fra loddlinjen; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, and takes large parts; {fixed}</source>
        <translation>{cell}: dysen beveger seg, alltid loddrett, og klarer store deler; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves over a table on the floor and takes large parts, but the platform is not small and gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}: dysen beveger seg over et bord på gulvet og klarer store deler, men plattformen er ikke liten og tyngdekraften hjelper ikke ved opptil {lean:.0f} fra loddlinjen; {fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, over a table on the floor and takes large parts; {fixed}</source>
        <translation>{cell}: dysen beveger seg, alltid loddrett, over et bord på gulvet og klarer store deler; {fixed}</translation>
    </message>
    <message>
        <source>none of these cells: {reasons}</source>
        <translation>ingen av disse cellene: {reasons}</translation>
    </message>
    <message>
        <source>the nozzle is inside {body}</source>
        <translation>dysen er inne i {body}</translation>
    </message>
    <message>
        <source>the plate is out of the arm&apos;s reach</source>
        <translation>byggeplaten er utenfor armens rekkevidde</translation>
    </message>
    <message>
        <source>the points are on a line: the frame&apos;s rotation about it is undefined</source>
        <translation>punktene ligger på en linje: koordinatsystemets rotasjon om den er ubestemt</translation>
    </message>
    <message>
        <source>the poses rotate the flange about one axis only, or hardly at all</source>
        <translation>positurene roterer flensen bare om én akse, eller nesten ikke i det hele tatt</translation>
    </message>
    <message>
        <source>tilt it by at least 30 degrees about two axes</source>
        <translation>tilt den minst 30 grader om to akser</translation>
    </message>
    <message>
        <source>rotate the flange between poses</source>
        <translation>roter flensen mellom positurene</translation>
    </message>
    <message>
        <source>two of the three points are identical</source>
        <translation>to av de tre punktene er like</translation>
    </message>
    <message>
        <source>use letters, digits, dashes and dots</source>
        <translation>bruk bokstaver, sifre, bindestreker og punktum</translation>
    </message>
    <message>
        <source>reach of the head</source>
        <translation>hodets rekkevidde</translation>
    </message>
    <message>
        <source>wherever the nozzle reaches the plate, {first} collides with {second}</source>
        <translation>overalt der dysen når byggeplaten, kolliderer {first} med {second}</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted}</source>
        <translation>{found} tall i en rad i stedet for {wanted}</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted} as in the first</source>
        <translation>{found} tall i en rad i stedet for {wanted} som i den første</translation>
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
        <translation>Hendelser setter den analoge utgangen der en bevegelse begynner (TriggEquip); ved TCP-hastighet følger den TCP-ens virkelige hastighet, så langsomme hjørner ikke får for mye (TriggSpeed).</translation>
    </message>
    <message>
        <source>How far the nozzle may tilt from its planned direction where that makes the joints&apos; motion smoother. Only with minimum jerk of whole paths.</source>
        <translation>Hvor mye dysen kan tilte fra planlagt retning der det gjør leddenes bevegelse jevnere. Bare med minst rykk over hele baner.</translation>
    </message>
    <message>
        <source>Rotation of the nozzle about its own axis: best for the arm, or by a rule if the nozzle&apos;s attachments have a front. With a rule, fewer points can be reached.</source>
        <translation>Dysens rotasjon om sin egen akse: best for armen, eller etter en regel hvis det som er montert på dysen, har en forside. Med en regel kan færre punkter nås.</translation>
    </message>
    <message>
        <source>Joint stream (MELFA Mxt, with packets and sender)</source>
        <translation>Leddstrøm (MELFA Mxt, med pakker og sender)</translation>
    </message>
    <message>
        <source>Joint stream (Universal Robots, with receiver and sender)</source>
        <translation>Leddstrøm (Universal Robots, med mottaker og sender)</translation>
    </message>
    <message>
        <source>MELFA stream: one packet is sent per controller cycle.</source>
        <translation>MELFA-strøm: én pakke sendes per styringssyklus.</translation>
    </message>
    <message>
        <source>RAPID: flow controlled by</source>
        <translation>RAPID: materialstrøm styrt av</translation>
    </message>
    <message>
        <source>an invalid flow per speed</source>
        <translation>en ugyldig materialstrøm per hastighet</translation>
    </message>
    <message>
        <source>a second stream</source>
        <translation>en andre strøm</translation>
    </message>
    <message>
        <source>a stream has exactly one motion to the start, as its first row</source>
        <translation>en strøm har nøyaktig én bevegelse til start, som første rad</translation>
    </message>
    <message>
        <source>a stream of {count} packets is too large for a file</source>
        <translation>en strøm på {count} pakker er for stor for en fil</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>langs banen</translation>
    </message>
    <message>
        <source>along the plate</source>
        <translation>langs byggeplaten</translation>
    </message>
    <message>
        <source>best for the arm</source>
        <translation>best for armen</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>styring</translation>
    </message>
    <message>
        <source>tilt tolerance</source>
        <translation>tilttoleranse</translation>
    </message>
    <message>
        <source>events at points</source>
        <translation>hendelser i punkter</translation>
    </message>
    <message>
        <source>format {format} states joint values for another maker&apos;s arm, not for the {robot} of cell {cell}</source>
        <translation>formatet {format} angir leddverdier for en annen produsents arm, ikke for {robot} i cellen {cell}</translation>
    </message>
    <message>
        <source>smallest rotation from upright</source>
        <translation>minste rotasjon fra loddrett</translation>
    </message>
    <message>
        <source>not the header of a joint stream</source>
        <translation>ikke hodet til en leddstrøm</translation>
    </message>
    <message>
        <source>not the program that receives this stream: &apos;{code}&apos;</source>
        <translation>ikke programmet som mottar denne strømmen: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>packet {number} does not match the rows</source>
        <translation>pakke {number} stemmer ikke med radene</translation>
    </message>
    <message>
        <source>use melfa</source>
        <translation>bruk melfa</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP-hastighet</translation>
    </message>
    <message>
        <source>the arm waits at another target than the previous one</source>
        <translation>armen venter i et annet mål enn det forrige</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not off at the end</source>
        <translation>ekstruderens utganger er ikke av på slutten</translation>
    </message>
    <message>
        <source>a flow proportional to the speed in a motion of unknown length</source>
        <translation>en materialstrøm proporsjonal med hastigheten i en bevegelse av ukjent lengde</translation>
    </message>
    <message>
        <source>the program that receives the stream is truncated</source>
        <translation>programmet som mottar strømmen, er avkortet</translation>
    </message>
    <message>
        <source>the row that ends the stream is missing: the file is truncated</source>
        <translation>raden som avslutter strømmen, mangler: filen er avkortet</translation>
    </message>
    <message>
        <source>this is not the program that receives a stream</source>
        <translation>dette er ikke programmet som mottar en strøm</translation>
    </message>
    <message>
        <source>this line differs from the one Voluta writes; it is the same for every job</source>
        <translation>denne linjen avviker fra den Voluta skriver; den er lik for alle jobber</translation>
    </message>
    <message>
        <source>nozzle rotation</source>
        <translation>dyserotasjon</translation>
    </message>
    <message>
        <source>Maximum filament length that the external axis feeds before it is reset to 0.</source>
        <translation>Største filamentlengde den eksterne aksen mater før den nullstilles.</translation>
    </message>
    <message>
        <source>How far the nozzle moves back over its bead, or on along a closed one, with the extruder off before it lifts. 0: it lifts at the end of the bead.</source>
        <translation>Hvor langt dysen går tilbake over strengen sin, eller videre langs en lukket streng, med ekstruderen av før den løftes. 0: den løftes ved enden av strengen.</translation>
    </message>
    <message>
        <source>How the program controls the extruder. Outputs: one for on/off, one for the flow. Castelli serial: texts over a socket. E stream: a file of amounts over time. External axis: mm of filament in each motion.</source>
        <translation>Hvordan programmet styrer ekstruderen. Utganger: en for av/på, en for materialstrømmen. Castelli seriell: tekster over en socket. E-strøm: en fil med mengder over tid. Ekstern akse: mm filament i hver bevegelse.</translation>
    </message>
    <message>
        <source>the whole mesh is a single point</source>
        <translation>hele meshen er ett enkelt punkt</translation>
    </message>
    <message>
        <source>at {x:.3f#}, {y:.3f#}, {z:.3f}, rotated by {rx:.3f#}, {ry:.3f#}, {rz:.3f}</source>
        <translation>ved {x:.3f#}, {y:.3f#}, {z:.3f}, rotert {rx:.3f#}, {ry:.3f#}, {rz:.3f}</translation>
    </message>
    <message>
        <source>more than {length:.0f} of filament is needed between two lifts: beyond the extruder axis&apos; range</source>
        <translation>mer enn {length:.0f} filament trengs mellom to løft: utenfor ekstruderaksens område</translation>
    </message>
    <message>
        <source>external axes that move alone are only supported for the extruder, with a time</source>
        <translation>eksterne akser som beveger seg alene, støttes bare for ekstruderen, med en tid</translation>
    </message>
    <message>
        <source>external axis</source>
        <translation>ekstern akse</translation>
    </message>
    <message>
        <source>extruder axis: range</source>
        <translation>ekstruderakse: område</translation>
    </message>
    <message>
        <source>no redundant measurements: the error cannot be estimated</source>
        <translation>ingen overtallige målinger: feilen kan ikke anslås</translation>
    </message>
    <message>
        <source>increase {option}</source>
        <translation>øk {option}</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is missing</source>
        <translation>ekstruderens akse mangler</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is not set to 0 before this motion</source>
        <translation>ekstruderens akse er ikke satt til 0 før denne bevegelsen</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is slowed: the arm would wait for it</source>
        <translation>ekstruderens akse bremses: armen ville vente på den</translation>
    </message>
    <message>
        <source>wipe</source>
        <translation>avstryk</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f}</source>
        <translation>{rows} rader, avvik {rms:.3f} i snitt og {worst:.3f} på det meste: nøyaktig til {place:.3f}</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f} and {turn:.3f}</source>
        <translation>{rows} rader, avvik {rms:.3f} i snitt og {worst:.3f} på det meste: nøyaktig til {place:.3f} og {turn:.3f}</translation>
    </message>
    <message>
        <source>Extended G-code: also writes a RAPID module that reads the file on an ABB controller and runs arm and extruder.</source>
        <translation>Utvidet G-kode: skriver også en RAPID-modul som leser filen på en ABB-styring og kjører arm og ekstruder.</translation>
    </message>
    <message>
        <source>Lines by data link (MELFA-BASIC V, with receiver and sender)</source>
        <translation>Linjer via Data Link (MELFA-BASIC V, med mottaker og sender)</translation>
    </message>
    <message>
        <source>a RAPID module (ABB)</source>
        <translation>en RAPID-modul (ABB)</translation>
    </message>
    <message>
        <source>a module that reads G-code cannot move the {axis} of cell {cell}: G-code does not state its position</source>
        <translation>en modul som leser G-kode, kan ikke bevege {axis} i cellen {cell}: G-kode angir ikke posisjonen</translation>
    </message>
    <message>
        <source>a position before the tool is defined</source>
        <translation>en posisjon før verktøyet er definert</translation>
    </message>
    <message>
        <source>the full flow is not the process&apos;s</source>
        <translation>full materialstrøm er ikke prosessens</translation>
    </message>
    <message>
        <source>companion reader for extended G-code</source>
        <translation>tilhørende leser for utvidet G-kode</translation>
    </message>
    <message>
        <source>its count (G92 C)</source>
        <translation>telleren (G92 C)</translation>
    </message>
    <message>
        <source>joint motions with joint targets and with pose targets in one stream</source>
        <translation>leddbevegelser med leddmål og med positurmål i én strøm</translation>
    </message>
    <message>
        <source>not the header of lines for a data link</source>
        <translation>ikke hodet til linjer for en Data Link</translation>
    </message>
    <message>
        <source>unexpected in the program that receives these lines: &apos;{code}&apos;</source>
        <translation>uventet i programmet som mottar disse linjene: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ingenting</translation>
    </message>
    <message>
        <source>set `tableTurns` to {turns} or more</source>
        <translation>sett `tableTurns` til {turns} eller mer</translation>
    </message>
    <message>
        <source>choose rapid</source>
        <translation>velg rapid</translation>
    </message>
    <message>
        <source>the arm does not stop before this line</source>
        <translation>armen stopper ikke før denne linjen</translation>
    </message>
    <message>
        <source>the extruder is on in a joint motion</source>
        <translation>ekstruderen er på i en leddbevegelse</translation>
    </message>
    <message>
        <source>the job&apos;s file, start or full flow is missing or given twice</source>
        <translation>jobbens fil, start eller fulle materialstrøm mangler eller er oppgitt to ganger</translation>
    </message>
    <message>
        <source>the first line is not a joint motion to the start</source>
        <translation>den første linjen er ikke en leddbevegelse til start</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; has no height above the previous one</source>
        <translation>laget &apos;{path}&apos; har ingen høyde over det forrige</translation>
    </message>
    <message>
        <source>the line that ends the stream is missing: the file is truncated</source>
        <translation>linjen som avslutter strømmen, mangler: filen er avkortet</translation>
    </message>
    <message>
        <source>the program that receives the lines is truncated</source>
        <translation>programmet som mottar linjene, er avkortet</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>bordet</translation>
    </message>
    <message>
        <source>within a bead the table would turn by more than {turns} turns to one side</source>
        <translation>innenfor en streng ville bordet dreie mer enn {turns} omdreininger til én side</translation>
    </message>
    <message>
        <source>this is not the module that reads G-code</source>
        <translation>dette er ikke modulen som leser G-kode</translation>
    </message>
    <message>
        <source>tool-paths of type &apos;{type}&apos; without beads; only beads from a nozzle are supported</source>
        <translation>verktøybaner av typen &apos;{type}&apos; uten strenger; bare strenger fra en dyse støttes</translation>
    </message>
    <message>
        <source>turns until C is reset</source>
        <translation>omdreininger før C nullstilles</translation>
    </message>
    <message>
        <source>reset of C</source>
        <translation>nullstilling av C</translation>
    </message>
    <message>
        <source>Adds break-away beads under low overhangs; thickens the overhanging bead instead where that is enough.</source>
        <translation>Legger til avbrekkbare strenger under lave overheng; gjør i stedet den overhengende strengen tykkere der det er nok.</translation>
    </message>
    <message>
        <source>Lines by EthernetKRL (KUKA, with receiver and sender)</source>
        <translation>Linjer via EthernetKRL (KUKA, med mottaker og sender)</translation>
    </message>
    <message>
        <source>an axis that carries the robot is missing</source>
        <translation>en akse som bærer roboten, mangler</translation>
    </message>
    <message numerus="yes">
        <source>support beads ({volume:.3g}) under {paths} beads that would overhang just above the plate or the printed part</source>
        <translation>
            <numerusform>støttestrenger ({volume:.3g}) under {paths} streng som ville henge over like over byggeplaten eller den printede delen</numerusform>
            <numerusform>støttestrenger ({volume:.3g}) under {paths} strenger som ville henge over like over byggeplaten eller den printede delen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{paths} unsupported beads are printed after their inner neighbours, with the nozzle tilted by up to {lean:.0f} more</source>
        <translation>
            <numerusform>{paths} streng uten støtte printes etter den indre naboen, med dysen tiltet opptil {lean:.0f} mer</numerusform>
            <numerusform>{paths} strenger uten støtte printes etter de indre naboene, med dysen tiltet opptil {lean:.0f} mer</numerusform>
        </translation>
    </message>
    <message>
        <source>if you do not want this, turn the part or print it in flat layers with supports</source>
        <translation>hvis dette ikke er ønsket, roter delen eller print den i flate lag med støtter</translation>
    </message>
    <message>
        <source>format {format} does not support external axes: it cannot move the {axis} of cell {cell}</source>
        <translation>formatet {format} støtter ikke eksterne akser: det kan ikke bevege {axis} i cellen {cell}</translation>
    </message>
    <message>
        <source>must be platform after an axis that carries the platform</source>
        <translation>må være platform etter en akse som bærer plattformen</translation>
    </message>
    <message>
        <source>must be platform or robot, is &apos;{carries}&apos;</source>
        <translation>må være platform eller robot, er &apos;{carries}&apos;</translation>
    </message>
    <message>
        <source>either a base or a fixed nozzle has to be defined</source>
        <translation>enten en base eller en fast dyse må være definert</translation>
    </message>
    <message>
        <source>support low overhangs</source>
        <translation>støtt lave overheng</translation>
    </message>
    <message>
        <source>the program&apos;s nozzle is {distance:.2f} and {angle:.2f} off the cell&apos;s nozzle</source>
        <translation>programmets dyse er {distance:.2f} og {angle:.2f} fra cellens dyse</translation>
    </message>
    <message numerus="yes">
        <source>{waypoints} waypoints ({share:.2g} of the material) are skipped; see the findings above</source>
        <translation>
            <numerusform>{waypoints} banepunkt ({share:.2g} av materialet) hoppes over; se funnene over</numerusform>
            <numerusform>{waypoints} banepunkter ({share:.2g} av materialet) hoppes over; se funnene over</numerusform>
        </translation>
    </message>
    <message>
        <source>The largest scale that the robot reaches entirely</source>
        <translation>Den største skalaen som roboten når helt</translation>
    </message>
    <message>
        <source>print it at scale {scale:.3g}, turn it, or use a larger robot</source>
        <translation>print den i skala {scale:.3g}, roter den, eller bruk en større robot</translation>
    </message>
    <message>
        <source>use flat layers, which need no tilt of the nozzle, turn the part, or use a larger robot</source>
        <translation>bruk flate lag, som ikke krever tilt av dysen, roter delen, eller bruk en større robot</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach</source>
        <translation>{share:.2g} av verktøybanepunktene er utenfor robotens rekkevidde</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach; at {size:.2g} of this size all would be reachable</source>
        <translation>{share:.2g} av verktøybanepunktene er utenfor robotens rekkevidde; ved {size:.2g} av denne størrelsen ville alle kunne nås</translation>
    </message>
    <message>
        <source>Let Voluta choose</source>
        <translation>La Voluta velge</translation>
    </message>
    <message>
        <source>Tries the ways of building in turn until nothing is unsupported or missed</source>
        <translation>Prøver byggemåtene etter tur til ingenting er uten støtte eller tapt</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is a reserved word and cannot name a function</source>
        <translation>&apos;{name}&apos; er et reservert ord og kan ikke være navn på en funksjon</translation>
    </message>
    <message>
        <source>ambiguous number &apos;{number}&apos;: decimal comma or thousands separator</source>
        <translation>tvetydig tall &apos;{number}&apos;: desimalkomma eller tusenskille</translation>
    </message>
    <message>
        <source>20 % smaller</source>
        <translation>20 % mindre</translation>
    </message>
    <message>
        <source>Adds a verification report to each program, NAME.proof.html and NAME.proof.pdf: the verdict, the checks and the margins to the limits; its figures as NAME.proof.json; and NAME.printed.stl, the part as printed, as a solid.</source>
        <translation>Legger en verifikasjonsrapport til hvert program, NAME.proof.html og NAME.proof.pdf: konklusjonen, kontrollene og marginene til grensene; tallene som NAME.proof.json; og NAME.printed.stl, delen slik den printes, som solid.</translation>
    </message>
    <message>
        <source>Allow less clearance</source>
        <translation>Tillat mindre klaring</translation>
    </message>
    <message>
        <source>Amount: {share:.1f} of the part&apos;s volume is deposited; {least:.4g#} to {most:.4g} allowed.</source>
        <translation>Mengde: {share:.1f} av delens volum avsettes; {least:.4g#} til {most:.4g} tillatt.</translation>
    </message>
    <message>
        <source>Arm, joints and their limits: not checked, as the program contains nozzle positions but no joint values.</source>
        <translation>Arm, ledd og leddgrenser: ikke kontrollert, fordi programmet inneholder dyseposisjoner, men ingen leddverdier.</translation>
    </message>
    <message>
        <source>The largest scale that the cell&apos;s plates carry</source>
        <translation>Den største skalaen som cellens byggeplater bærer</translation>
    </message>
    <message>
        <source>The part&apos;s footprint plus 20 mm, on its own stem</source>
        <translation>Delens fotavtrykk pluss 20 mm, på egen stamme</translation>
    </message>
    <message>
        <source>Bead section: off by more than 5 % over {share:.2f} of the printed length; at most {limit:.0f} allowed.</source>
        <translation>Strengens tverrsnitt: mer enn 5 % feil over {share:.2f} av den printede lengden; høyst {limit:.0f} tillatt.</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Innebygd</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Chosen: {way} ({values})</source>
        <translation>Valgt: {way} ({values})</translation>
    </message>
    <message>
        <source>Close the openings</source>
        <translation>Lukk åpningene</translation>
    </message>
    <message>
        <source>Minimum clearance between arm, plate and part: {way:.1f}.</source>
        <translation>Minste klaring mellom arm, byggeplate og del: {way:.1f}.</translation>
    </message>
    <message>
        <source>Collisions of head, plate and part: {collisions}; none allowed.</source>
        <translation>Kollisjoner mellom hode, byggeplate og del: {collisions}; ingen tillatt.</translation>
    </message>
    <message>
        <source>Collisions: {collisions}; none allowed.</source>
        <translation>Kollisjoner: {collisions}; ingen tillatt.</translation>
    </message>
    <message>
        <source>Fill: {share:.1f} of the part is filled; at least {limit:.4g} required.</source>
        <translation>Fylling: {share:.1f} av delen er fylt; minst {limit:.4g} kreves.</translation>
    </message>
    <message>
        <source>Flat patches over the openings: the part becomes solid</source>
        <translation>Flate lapper over åpningene: delen blir solid</translation>
    </message>
    <message>
        <source>G-code with B and C: beyond this number of turns to one side C is reset by whole turns during a travel. 0: the minimum the beads allow if the table is wound back, one turn if only its count is reset.</source>
        <translation>G-kode med B og C: over dette antallet omdreininger til én side nullstilles C med hele omdreininger under en tomkjøring. 0: minimum strengene tillater hvis bordet dreies tilbake, én omdreining hvis bare telleren nullstilles.</translation>
    </message>
    <message>
        <source>G-code with B and C: winds the table back during a travel, with the nozzle raised clear of it. For a table that turns endlessly only the count can be reset, without a motion.</source>
        <translation>G-kode med B og C: dreier bordet tilbake under en tomkjøring, med dysen løftet klar av det. For et bord som dreier endeløst, kan bare telleren nullstilles, uten bevegelse.</translation>
    </message>
    <message>
        <source>G94 is missing after the last motion: the next program would read F as times</source>
        <translation>G94 mangler etter siste bevegelse: neste program ville lese F som tider</translation>
    </message>
    <message>
        <source>Half the layer height, within the process&apos;s range</source>
        <translation>Halv laghøyde, innenfor prosessens område</translation>
    </message>
    <message>
        <source>50 % larger</source>
        <translation>50 % større</translation>
    </message>
    <message>
        <source>Half the distance of the arm from itself and from the part</source>
        <translation>Halve avstanden fra armen til seg selv og til delen</translation>
    </message>
    <message>
        <source>Partly supported: {share:.1f} of the bead length is supported over less than half its width.</source>
        <translation>Delvis støttet: {share:.1f} av strenglengden er støttet over mindre enn halve bredden.</translation>
    </message>
    <message>
        <source>In a usual cell; Voluta chooses the way of building</source>
        <translation>I en vanlig celle; Voluta velger byggemåte</translation>
    </message>
    <message>
        <source>It is for another controller than the cell&apos;s.</source>
        <translation>Det er for en annen styring enn cellens.</translation>
    </message>
    <message>
        <source>It prints the rest of a stopped print.</source>
        <translation>Det printer resten av en stanset print.</translation>
    </message>
    <message>
        <source>Joint range: joint {name} has the smallest margin to its limit, {angle:.1f}.</source>
        <translation>Leddområde: ledd {name} har minst margin til grensen, {angle:.1f}.</translation>
    </message>
    <message>
        <source>Joint speed: joint {name} is closest to its limit, at {share:.0f} of it.</source>
        <translation>Leddhastighet: ledd {name} er nærmest grensen, på {share:.0f} av den.</translation>
    </message>
    <message>
        <source>Keep more clearance</source>
        <translation>Hold større klaring</translation>
    </message>
    <message>
        <source>Limits of flow and blends: {violations} violations; none allowed.</source>
        <translation>Grenser for materialstrøm og overganger: {violations} brudd; ingen tillatt.</translation>
    </message>
    <message>
        <source>Limits of joints, speeds and flow: {violations} violations; none allowed.</source>
        <translation>Grenser for ledd, hastigheter og materialstrøm: {violations} brudd; ingen tillatt.</translation>
    </message>
    <message>
        <source>Longer programs are split into files to run one after the other. 0: the format&apos;s default (URScript and RAPID 5000, KRL 2500, MELFA 6500, SPEL+ one file).</source>
        <translation>Lengre programmer deles i filer som kjøres etter hverandre. 0: formatets standard (URScript og RAPID 5000, KRL 2500, MELFA 6500, SPEL+ én fil).</translation>
    </message>
    <message>
        <source>Longest unsupported run: {length:.1f}; this material bridges {bridge:.1f}.</source>
        <translation>Lengste strekk uten støtte: {length:.1f}; dette materialet bygger bro over {bridge:.1f}.</translation>
    </message>
    <message>
        <source>Make a platform for the part</source>
        <translation>Lag en plattform for delen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>No way of building passes; the best one is shown: {way} ({values})</source>
        <translation>Ingen byggemåte består; den beste vises: {way} ({values})</translation>
    </message>
    <message>
        <source>The default nozzle, head and material of this way of building</source>
        <translation>Standard dyse, hode og materiale for denne byggemåten</translation>
    </message>
    <message>
        <source>G{number} is not understood</source>
        <translation>G{number} støttes ikke</translation>
    </message>
    <message>
        <source>Height after which the layers turn in the other direction, again and again; 0: never.</source>
        <translation>Høyden der lagene begynner å dreie motsatt vei, om og om igjen; 0: aldri.</translation>
    </message>
    <message>
        <source>Material of the file&apos;s tool-paths, in percent of its amounts. For a file that was read with another filament diameter: 100 times the square of their ratio (2.85 mm instead of 1.75 mm: 265).</source>
        <translation>Materiale i filens verktøybaner, i prosent av filens mengder. For en fil som ble lest med en annen filamentdiameter: 100 ganger kvadratet av forholdet (2,85 mm i stedet for 1,75 mm: 265).</translation>
    </message>
    <message>
        <source>Moves the file&apos;s tool-paths to x,y,z,a,b,c: mm, and degrees about the fixed axes x, y and z in this order; e.g. onto a side of the platform&apos;s body. Empty: no motion.</source>
        <translation>Flytter filens verktøybaner til x,y,z,a,b,c: mm, og grader om de faste aksene x, y og z i denne rekkefølgen; f.eks. til en side av plattformens legeme. Tom: ingen flytting.</translation>
    </message>
    <message>
        <source>On a cylinder or sphere: each layer keeps the lengths of the file, or the angle of the layer below, so that it grows with the radius and its beads with it.</source>
        <translation>På en sylinder eller kule: hvert lag beholder filens lengder, eller vinkelen til laget under, slik at det vokser med radien og strengene vokser med.</translation>
    </message>
    <message>
        <source>Paths of the file</source>
        <translation>Filens baner</translation>
    </message>
    <message>
        <source>Radius of that cylinder or sphere; negative: its inside.</source>
        <translation>Radien til den sylinderen eller kulen; negativ: innsiden.</translation>
    </message>
    <message>
        <source>Turns each layer of the file&apos;s tool-paths about z against the one below; positive: counterclockwise.</source>
        <translation>Dreier hvert lag av filens verktøybaner om z i forhold til laget under; positiv: mot klokken.</translation>
    </message>
    <message>
        <source>Where the file&apos;s tool-paths are printed: on the plate; on a block with a plane top, which is turned together with them; or bent onto a cylinder along x or a sphere. The block is made for the part, unless the platform is a body.</source>
        <translation>Hvor filens verktøybaner printes: på byggeplaten; på en blokk med plan topp, som roteres sammen med dem; eller bøyd over på en sylinder langs x eller en kule. Blokken lages for delen, med mindre plattformen er et legeme.</translation>
    </message>
    <message>
        <source>a bead from an unknown position</source>
        <translation>en streng fra en ukjent posisjon</translation>
    </message>
    <message>
        <source>a direction of length 0</source>
        <translation>en retning med lengde 0</translation>
    </message>
    <message>
        <source>a length of filament of more than a kilometre</source>
        <translation>en filamentlengde på mer enn en kilometer</translation>
    </message>
    <message>
        <source>a motion with a word A, U, V or W is not understood</source>
        <translation>en bevegelse med et ord A, U, V eller W støttes ikke</translation>
    </message>
    <message>
        <source>a position more than a kilometre away</source>
        <translation>en posisjon mer enn en kilometer unna</translation>
    </message>
    <message>
        <source>a position without G0 or G1</source>
        <translation>en posisjon uten G0 eller G1</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>mengde</translation>
    </message>
    <message>
        <source>an arc that does not pass through its ends</source>
        <translation>en bue som ikke går gjennom endepunktene sine</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>vinkler</translation>
    </message>
    <message>
        <source>bent layers keep</source>
        <translation>bøyde lag beholder</translation>
    </message>
    <message>
        <source>contains no beads of a part</source>
        <translation>inneholder ingen strenger av en del</translation>
    </message>
    <message>
        <source>contains no beads: no motion extrudes</source>
        <translation>inneholder ingen strenger: ingen bevegelse ekstruderer</translation>
    </message>
    <message>
        <source>export G-code as text from the slicer</source>
        <translation>eksporter G-kode som tekst fra sliceren</translation>
    </message>
    <message>
        <source>export straight lines, or arcs in the plane of X and Y (G2, G3)</source>
        <translation>eksporter rette linjer, eller buer i planet X og Y (G2, G3)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E)</source>
        <translation>eksporter G-koden med ekstrudering (E)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E) from a slicer</source>
        <translation>eksporter G-koden med ekstrudering (E) fra en slicer</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>koordinatsystem</translation>
    </message>
    <message>
        <source>give F in mm per minute</source>
        <translation>oppgi F i mm per minutt</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`</source>
        <translation>oppgi en større `pathsRadiusMm`</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`, or turn the part by 90 degrees</source>
        <translation>oppgi en større `pathsRadiusMm`, eller roter delen 90 grader</translation>
    </message>
    <message>
        <source>give at least 1 mm, or at most -1 mm for the inside</source>
        <translation>oppgi minst 1 mm, eller høyst -1 mm for innsiden</translation>
    </message>
    <message>
        <source>give its centre (I, J) or its radius (R)</source>
        <translation>oppgi sentrum (I, J) eller radius (R)</translation>
    </message>
    <message>
        <source>give nX nY nZ as a unit vector</source>
        <translation>oppgi nX nY nZ som enhetsvektor</translation>
    </message>
    <message>
        <source>give the nozzle&apos;s direction as nX nY nZ, or the table&apos;s angles as B and C</source>
        <translation>oppgi dysens retning som nX nY nZ, eller bordets vinkler som B og C</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>underlag</translation>
    </message>
    <message>
        <source>home the axes (G28) or travel to its start first</source>
        <translation>kjør aksene til hjem (G28) eller tomkjør til starten først</translation>
    </message>
    <message>
        <source>is binary G-code</source>
        <translation>er binær G-kode</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>lengder</translation>
    </message>
    <message>
        <source>`pathsFrame` &apos;{text}&apos; is not a frame</source>
        <translation>`pathsFrame` &apos;{text}&apos; er ikke et koordinatsystem</translation>
    </message>
    <message>
        <source>`pathsRadiusMm={radius}` is no radius of a ground</source>
        <translation>`pathsRadiusMm={radius}` er ikke radien til et underlag</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>byggeplate</translation>
    </message>
    <message>
        <source>slice with comments, or with layers of one height</source>
        <translation>slice med kommentarer, eller med lag av samme høyde</translation>
    </message>
    <message>
        <source>the file may be damaged; export it again</source>
        <translation>filen kan være skadet; eksporter den på nytt</translation>
    </message>
    <message>
        <source>the file states no filament diameter: {diameter} assumed; for another one set `pathsFlow`</source>
        <translation>filen angir ingen filamentdiameter: {diameter} antas; for en annen, sett `pathsFlow`</translation>
    </message>
    <message>
        <source>a bead at X{x:.1f} Y{y:.1f} Z{z:.1f} is {width:.0f} wide</source>
        <translation>en streng ved X{x:.1f} Y{y:.1f} Z{z:.1f} er {width:.0f} bred</translation>
    </message>
    <message>
        <source>correct the amount (E) of that line, or the filament&apos;s diameter</source>
        <translation>rett mengden (E) på den linjen, eller filamentets diameter</translation>
    </message>
    <message>
        <source>the height of the beads is not known</source>
        <translation>høyden på strengene er ikke kjent</translation>
    </message>
    <message>
        <source>the part is {height:.1f} high, too high for the inside of a radius of {radius:.1f}</source>
        <translation>delen er {height:.1f} høy, for høy for innsiden av en radius på {radius:.1f}</translation>
    </message>
    <message>
        <source>the part reaches {angle:.0f} round the ground, more than 90</source>
        <translation>delen når {angle:.0f} rundt underlaget, mer enn 90</translation>
    </message>
    <message>
        <source>turn back after</source>
        <translation>snu etter</translation>
    </message>
    <message>
        <source>turn per layer</source>
        <translation>dreining per lag</translation>
    </message>
    <message>
        <source>write the command in each line</source>
        <translation>skriv kommandoen på hver linje</translation>
    </message>
    <message>
        <source>write x,y,z,a,b,c in mm and degrees</source>
        <translation>skriv x,y,z,a,b,c i mm og grader</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded before the first layer are left out</source>
        <translation>{volume:.0f} ekstrudert før første lag utelates</translation>
    </message>
    <message>
        <source>Open surfaces</source>
        <translation>Åpne flater</translation>
    </message>
    <message>
        <source>Overfill: {share:.1f} of the part&apos;s volume lies outside it or in places already full; at most {limit:.4g} allowed.</source>
        <translation>Overfylling: {share:.1f} av delens volum ligger utenfor den eller på steder som alt er fulle; høyst {limit:.4g} tillatt.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Passed: this program prints the part as planned.</source>
        <translation>Bestått: dette programmet printer delen som planlagt.</translation>
    </message>
    <message>
        <source>Path: the nozzle deviates from the planned path by up to {way:.3f}; at most {limit:.2f} allowed.</source>
        <translation>Bane: dysen avviker opptil {way:.3f} fra planlagt bane; høyst {limit:.2f} tillatt.</translation>
    </message>
    <message>
        <source>Planned
time</source>
        <translation>Planlagt
tid</translation>
    </message>
    <message>
        <source>Positions are in mm in the work frame: origin at the centre of the platform&apos;s top, z pointing out of it. The printed part as a solid: {file}</source>
        <translation>Posisjoner er i mm i arbeidskoordinatsystemet: origo i sentrum av plattformens overside, z ut fra den. Den printede delen som solid: {file}</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Priming</translation>
    </message>
    <message>
        <source>Print it larger</source>
        <translation>Print den større</translation>
    </message>
    <message>
        <source>Print it smaller</source>
        <translation>Print den mindre</translation>
    </message>
    <message>
        <source>Print thinner layers</source>
        <translation>Print tynnere lag</translation>
    </message>
    <message>
        <source>Print on a plate</source>
        <translation>Print på en byggeplate</translation>
    </message>
    <message>
        <source>Print time</source>
        <translation>Printtid</translation>
    </message>
    <message>
        <source>Program files with their SHA-256</source>
        <translation>Programfiler med SHA-256</translation>
    </message>
    <message>
        <source>Refused: do not run this program.</source>
        <translation>Avvist: ikke kjør dette programmet.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>The default robot and plate of this way of building</source>
        <translation>Standard robot og byggeplate for denne byggemåten</translation>
    </message>
    <message>
        <source>Singularities: isotropy is at least {ratio:.3f} (0 is singular, 1 is isotropic).</source>
        <translation>Singulariteter: isotropien er minst {ratio:.3f} (0 er singulær, 1 er isotrop).</translation>
    </message>
    <message>
        <source>The next cell with a larger plate</source>
        <translation>Neste celle med større byggeplate</translation>
    </message>
    <message>
        <source>The cell&apos;s smallest plate that carries the part</source>
        <translation>Cellens minste byggeplate som bærer delen</translation>
    </message>
    <message>
        <source>Thicken to a wall</source>
        <translation>Gjør tykkere til en vegg</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Verktøy</translation>
    </message>
    <message>
        <source>Try more rotations</source>
        <translation>Prøv flere rotasjoner</translation>
    </message>
    <message>
        <source>Trying {way} ({number} of {count})</source>
        <translation>Prøver {way} ({number} av {count})</translation>
    </message>
    <message>
        <source>Twice as many rotations about the nozzle per point; planning takes longer</source>
        <translation>Dobbelt så mange rotasjoner om dysen per punkt; planleggingen tar lengre tid</translation>
    </message>
    <message>
        <source>Twice the distance of the arm from itself and from the part</source>
        <translation>Dobbel avstand fra armen til seg selv og til delen</translation>
    </message>
    <message>
        <source>Two beads wide, centred on the surface</source>
        <translation>To strenger bred, sentrert på flaten</translation>
    </message>
    <message>
        <source>Unsupported: {share:.2f} of the bead length; at most {limit:.4g} allowed.</source>
        <translation>Uten støtte: {share:.2f} av strenglengden; høyst {limit:.4g} tillatt.</translation>
    </message>
    <message>
        <source>Use a larger cell</source>
        <translation>Bruk en større celle</translation>
    </message>
    <message>
        <source>Use longer motions</source>
        <translation>Bruk lengre bevegelser</translation>
    </message>
    <message>
        <source>Use shorter motions</source>
        <translation>Bruk kortere bevegelser</translation>
    </message>
    <message>
        <source>Use the cell&apos;s plate</source>
        <translation>Bruk cellens byggeplate</translation>
    </message>
    <message>
        <source>Use the usual cell</source>
        <translation>Bruk den vanlige cellen</translation>
    </message>
    <message>
        <source>Use the usual process</source>
        <translation>Bruk den vanlige prosessen</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, moved the nozzle along it without an arm, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta leste programmet tilbake, beveget dysen langs det uten arm og fant at {checks} kontroll ikke er bestått.</numerusform>
            <numerusform>Voluta leste programmet tilbake, beveget dysen langs det uten arm og fant at {checks} kontroller ikke er bestått.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, moved the nozzle along it without an arm, and measured what it prints.</source>
        <translation>Voluta leste programmet tilbake, beveget dysen langs det uten arm og målte hva det printer.</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta leste programmet tilbake, kjørte det på en modell av roboten og styringen og fant at {checks} kontroll ikke er bestått.</numerusform>
            <numerusform>Voluta leste programmet tilbake, kjørte det på en modell av roboten og styringen og fant at {checks} kontroller ikke er bestått.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and measured what it prints.</source>
        <translation>Voluta leste programmet tilbake, kjørte det på en modell av roboten og styringen og målte hva det printer.</translation>
    </message>
    <message>
        <source>Voluta {version}, {date}</source>
        <translation>Voluta {version}, {date}</translation>
    </message>
    <message>
        <source>Half the waypoint spacing; the program gets longer</source>
        <translation>Halv avstand mellom banepunktene; programmet blir lengre</translation>
    </message>
    <message>
        <source>Twice the waypoint spacing</source>
        <translation>Dobbel avstand mellom banepunktene</translation>
    </message>
    <message>
        <source>Checks, with the closest approach to each limit</source>
        <translation>Kontroller, med nærmeste avstand til hver grense</translation>
    </message>
    <message>
        <source>Modules and signal list for this controller: IRC5 (RobotWare 6) or OmniCore (RobotWare 7).</source>
        <translation>Moduler og signalliste for denne styringen: IRC5 (RobotWare 6) eller OmniCore (RobotWare 7).</translation>
    </message>
    <message>
        <source>a ball refers to the missing vertex {vertex}</source>
        <translation>en kule viser til hjørnepunkt {vertex}, som mangler</translation>
    </message>
    <message>
        <source>a beam refers to the missing vertex {vertex}</source>
        <translation>en bjelke viser til hjørnepunkt {vertex}, som mangler</translation>
    </message>
    <message>
        <source>a beam without a radius</source>
        <translation>en bjelke uten radius</translation>
    </message>
    <message>
        <source>a picture of the sheet is not a PNG</source>
        <translation>et bilde på arket er ikke en PNG</translation>
    </message>
    <message>
        <source>a stop until the operator continues</source>
        <translation>en stopp til operatøren fortsetter</translation>
    </message>
    <message>
        <source>a trigger for the output</source>
        <translation>en trigger for utgangen</translation>
    </message>
    <message>
        <source>a wait until the nozzle is hot</source>
        <translation>en venting til dysen er varm</translation>
    </message>
    <message>
        <source>a wall of {wall:.2f} is too thin for a surface of this size: it would need {facets:.2g} triangles</source>
        <translation>en vegg på {wall:.2f} er for tynn for en overflate av denne størrelsen: den ville trenge {facets:.2g} trekanter</translation>
    </message>
    <message>
        <source>absolute positions</source>
        <translation>absolutte posisjoner</translation>
    </message>
    <message>
        <source>after {time}</source>
        <translation>etter {time}</translation>
    </message>
    <message>
        <source>an object of the unknown type &apos;{type}&apos;</source>
        <translation>et objekt av den ukjente typen &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>an extruder output is set while the arm is moving: it switches at the wrong place, or stops the arm on the bead</source>
        <translation>en ekstruderutgang settes mens armen beveger seg: den kobler på feil sted, eller stopper armen på strengen</translation>
    </message>
    <message>
        <source>according to the robot&apos;s controller</source>
        <translation>ifølge robotens styring</translation>
    </message>
    <message>
        <source>at {place:.1f}</source>
        <translation>ved {place:.1f}</translation>
    </message>
    <message>
        <source>clear this place, or use a larger plate (`--platform`)</source>
        <translation>rydd dette stedet, eller bruk en større byggeplate (`--platform`)</translation>
    </message>
    <message>
        <source>close</source>
        <translation>lukk</translation>
    </message>
    <message>
        <source>open edges were closed: {share:.3g} of the surface is patches</source>
        <translation>åpne kanter ble lukket: {share:.3g} av overflaten er lapper</translation>
    </message>
    <message>
        <source>curved layers</source>
        <translation>krumme lag</translation>
    </message>
    <message>
        <source>curved layers on a pedestal</source>
        <translation>krumme lag på en sokkel</translation>
    </message>
    <message>
        <source>curved layers with supports</source>
        <translation>krumme lag med støtter</translation>
    </message>
    <message>
        <source>decimal commas read as decimal points</source>
        <translation>desimalkomma lest som desimalpunktum</translation>
    </message>
    <message>
        <source>export it as a triangle mesh</source>
        <translation>eksporter det som trekantmesh</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>eksporter den med desimalpunktum</translation>
    </message>
    <message>
        <source>flat layers</source>
        <translation>flate lag</translation>
    </message>
    <message>
        <source>flat layers with supports</source>
        <translation>flate lag med støtter</translation>
    </message>
    <message>
        <source>footprint of the part: {length:.0f} by {width:.0f}, larger than the cell&apos;s largest plate ({plate})</source>
        <translation>delens fotavtrykk: {length:.0f} ganger {width:.0f}, større enn cellens største byggeplate ({plate})</translation>
    </message>
    <message>
        <source>has a disc inside another</source>
        <translation>har en skive inne i en annen</translation>
    </message>
    <message>
        <source>contains nothing to print: {what}</source>
        <translation>inneholder ingenting å printe: {what}</translation>
    </message>
    <message>
        <source>contains sliced G-code (&apos;{member}&apos;) and no model</source>
        <translation>inneholder slicet G-kode (&apos;{member}&apos;) og ingen modell</translation>
    </message>
    <message>
        <source>the counting mode of the filament</source>
        <translation>filamentets tellemåte</translation>
    </message>
    <message>
        <source>parameter {key} no longer exists: its value has no effect</source>
        <translation>parameteren {key} finnes ikke lenger: verdien har ingen virkning</translation>
    </message>
    <message>
        <source>parameter {oldKey} was renamed to {key}</source>
        <translation>parameteren {oldKey} har fått navnet {key}</translation>
    </message>
    <message>
        <source>is damaged or truncated UTF-16</source>
        <translation>er skadet eller avkortet UTF-16</translation>
    </message>
    <message>
        <source>is UTF-32, which cannot be read</source>
        <translation>er UTF-32, som ikke kan leses</translation>
    </message>
    <message>
        <source>is not one of the colours: &apos;{name}&apos;</source>
        <translation>er ikke en av fargene: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>stored as text in an older project: plan again to see remedies</source>
        <translation>lagret som tekst i et eldre prosjekt: planlegg på nytt for å se tiltak</translation>
    </message>
    <message>
        <source>layer height {height}, platform: {platform}</source>
        <translation>laghøyde {height}, plattform: {platform}</translation>
    </message>
    <message>
        <source>layer height {height}, supports: {supports}, platform: {platform}</source>
        <translation>laghøyde {height}, støtter: {supports}, plattform: {platform}</translation>
    </message>
    <message>
        <source>layer {layer}</source>
        <translation>lag {layer}</translation>
    </message>
    <message>
        <source>sheets without thickness were left out: {share:.3g} of the surface, {triangles} triangles</source>
        <translation>flak uten tykkelse ble utelatt: {share:.3g} av overflaten, {triangles} trekanter</translation>
    </message>
    <message>
        <source>less than {share:.0f}</source>
        <translation>mindre enn {share:.0f}</translation>
    </message>
    <message>
        <source>line {line} of {file}</source>
        <translation>linje {line} i {file}</translation>
    </message>
    <message>
        <source>millimetres as the unit of length</source>
        <translation>millimeter som lengdeenhet</translation>
    </message>
    <message>
        <source>missing before this line: {statement}</source>
        <translation>mangler før denne linjen: {statement}</translation>
    </message>
    <message>
        <source>must be a colour like &quot;#d0d4d8&quot;</source>
        <translation>må være en farge som &quot;#d0d4d8&quot;</translation>
    </message>
    <message>
        <source>must be in 1..{most}</source>
        <translation>må være i 1..{most}</translation>
    </message>
    <message>
        <source>must hold as many discs as the first, at least one</source>
        <translation>må ha like mange skiver som den første, minst én</translation>
    </message>
    <message>
        <source>must hold at least one solid</source>
        <translation>må ha minst ett legeme</translation>
    </message>
    <message>
        <source>must hold {wanted} values, holds {found}</source>
        <translation>må ha {wanted} verdier, har {found}</translation>
    </message>
    <message>
        <source>must not be along the axis</source>
        <translation>må ikke være langs aksen</translation>
    </message>
    <message>
        <source>must not be before the previous one</source>
        <translation>må ikke være før den forrige</translation>
    </message>
    <message>
        <source>no available process has narrower beads</source>
        <translation>ingen tilgjengelig prosess har smalere strenger</translation>
    </message>
    <message>
        <source>nothing is left: no triangle has area or encloses a volume</source>
        <translation>ingenting er igjen: ingen trekant har areal eller omslutter et volum</translation>
    </message>
    <message>
        <source>nozzle {nozzle}, bead {width#} x {height}</source>
        <translation>dyse {nozzle}, streng {width#} x {height}</translation>
    </message>
    <message>
        <source>numbers with decimal commas, such as &apos;{number}&apos;, mixed with numbers with decimal points</source>
        <translation>tall med desimalkomma, som &apos;{number}&apos;, blandet med tall med desimalpunktum</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; has a beam lattice clipped by a mesh, which cannot be read</source>
        <translation>objektet &apos;{id}&apos; har et bjelkegitter klippet av en mesh, som ikke kan leses</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is stored as slices (slicestack), which cannot be read</source>
        <translation>objektet &apos;{id}&apos; er lagret som skiver (slicestack), som ikke kan leses</translation>
    </message>
    <message>
        <source>change the cell&apos;s file: Edit, Edit cell</source>
        <translation>endre cellens fil: Rediger, Rediger celle</translation>
    </message>
    <message numerus="yes">
        <source>open surface: {rims} open edge loops, the widest {width:.3g} wide</source>
        <translation>
            <numerusform>åpen flate: {rims} åpen kantsløyfe, {width:.3g} bred</numerusform>
            <numerusform>åpen flate: {rims} åpne kantsløyfer, den bredeste {width:.3g} bred</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>open surface: it ends at {rims} rims, the widest {width:.3g} wide at {at:.1f}</source>
        <translation>
            <numerusform>åpen flate: den slutter ved {rims} rand, {width:.3g} bred ved {at:.1f}</numerusform>
            <numerusform>åpen flate: den slutter ved {rims} render, den bredeste {width:.3g} bred ved {at:.1f}</numerusform>
        </translation>
    </message>
    <message>
        <source>open the model that it was sliced from</source>
        <translation>åpne modellen den ble slicet fra</translation>
    </message>
    <message>
        <source>to get a solid instead, use `openSurfaces=close`</source>
        <translation>for å få en solid i stedet, bruk `openSurfaces=close`</translation>
    </message>
    <message>
        <source>to get a wall instead, use `openSurfaces=thicken`</source>
        <translation>for å få en vegg i stedet, bruk `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>to get walls instead, use `openSurfaces=thicken`</source>
        <translation>for å få vegger i stedet, bruk `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>pieces with supports</source>
        <translation>stykker med støtter</translation>
    </message>
    <message>
        <source>planned time</source>
        <translation>planlagt tid</translation>
    </message>
    <message>
        <source>print the part at scale {scale}, or use a cell with a larger plate or a platform made for the part</source>
        <translation>print delen i skala {scale}, eller bruk en celle med større byggeplate eller en plattform laget for delen</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>avvis</translation>
    </message>
    <message numerus="yes">
        <source>removed the self-intersections of {count} components</source>
        <translation>
            <numerusform>fjernet selvskjæringene i {count} komponent</numerusform>
            <numerusform>fjernet selvskjæringene i {count} komponenter</numerusform>
        </translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>lagre den som UTF-8</translation>
    </message>
    <message>
        <source>set it by a trigger of the next motion, or write the program again</source>
        <translation>sett den med en trigger i neste bevegelse, eller skriv programmet på nytt</translation>
    </message>
    <message>
        <source>sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles</source>
        <translation>flakmodell: {share:.3g} av overflaten har ingen tykkelse, {triangles} trekanter</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} items marked as not printable</source>
        <translation>
            <numerusform>hoppet over: {count} element merket som ikke printbart</numerusform>
            <numerusform>hoppet over: {count} elementer merket som ikke printbare</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;other&apos;, which are not printed</source>
        <translation>
            <numerusform>hoppet over: {count} objekt av typen &apos;other&apos;, som ikke printes</numerusform>
            <numerusform>hoppet over: {count} objekter av typen &apos;other&apos;, som ikke printes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;surface&apos;, which are not solids</source>
        <translation>
            <numerusform>hoppet over: {count} objekt av typen &apos;surface&apos;, som ikke er et legeme</numerusform>
            <numerusform>hoppet over: {count} objekter av typen &apos;surface&apos;, som ikke er legemer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects without a mesh</source>
        <translation>
            <numerusform>hoppet over: {count} objekt uten mesh</numerusform>
            <numerusform>hoppet over: {count} objekter uten mesh</numerusform>
        </translation>
    </message>
    <message>
        <source>contains {parts} parts, of which {limit} can be printed</source>
        <translation>inneholder {parts} deler, hvorav {limit} kan printes</translation>
    </message>
    <message>
        <source>open it as one part</source>
        <translation>åpne den som én del</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} support objects</source>
        <translation>
            <numerusform>hoppet over: {count} støtteobjekt</numerusform>
            <numerusform>hoppet over: {count} støtteobjekter</numerusform>
        </translation>
    </message>
    <message>
        <source>the PDF could not be created: {why}</source>
        <translation>PDF-en kunne ikke lages: {why}</translation>
    </message>
    <message>
        <source>the arm passes this point at {stated:.1f} mm/s with unchanged flow; the path requires {suits:.1f} mm/s</source>
        <translation>armen passerer dette punktet med {stated:.1f} mm/s med uendret materialstrøm; banen krever {suits:.1f} mm/s</translation>
    </message>
    <message>
        <source>the robot dwells here for {time:.2f} with the hot nozzle touching the part</source>
        <translation>roboten dveler her i {time:.2f} med den varme dysen mot delen</translation>
    </message>
    <message>
        <source>the arm&apos;s posture at this target: {found} in the program, {planned} planned</source>
        <translation>armens stilling i dette målet: {found} i programmet, {planned} planlagt</translation>
    </message>
    <message>
        <source>choose the bead to resume from on the Simulate page</source>
        <translation>velg strengen det skal gjenopptas fra på siden Simuler</translation>
    </message>
    <message>
        <source>the rounding distances of corners</source>
        <translation>avrundingsavstandene i hjørner</translation>
    </message>
    <message>
        <source>the reference run</source>
        <translation>referansekjøringen</translation>
    </message>
    <message>
        <source>see the remedies of the findings before this one</source>
        <translation>se tiltakene for funnene før dette</translation>
    </message>
    <message>
        <source>the frame of the targets</source>
        <translation>koordinatsystemet til målene</translation>
    </message>
    <message>
        <source>the full flow</source>
        <translation>full materialstrøm</translation>
    </message>
    <message>
        <source>the mechanical unit</source>
        <translation>den mekaniske enheten</translation>
    </message>
    <message>
        <source>the message says how to fix it</source>
        <translation>meldingen sier hvordan det rettes</translation>
    </message>
    <message>
        <source>the part as printed, every bead laid</source>
        <translation>delen slik den printes, alle strenger lagt</translation>
    </message>
    <message>
        <source>no room on the plate for the prime: a bead {length:.0f} long is printed in the air beside the plate and falls down here</source>
        <translation>ikke plass på byggeplaten til primingen: en streng på {length:.0f} printes i luften ved siden av byggeplaten og faller ned her</translation>
    </message>
    <message>
        <source>the program does not match this plan: changing the plan does not help</source>
        <translation>programmet stemmer ikke med denne planen: å endre planen hjelper ikke</translation>
    </message>
    <message>
        <source>the range of the flow output</source>
        <translation>området til utgangen for materialstrøm</translation>
    </message>
    <message>
        <source>self-intersecting surface: {share:.3g} of the enclosed volume is inside out and counts as outside</source>
        <translation>selvskjærende overflate: {share:.3g} av det omsluttede volumet er vrengt og regnes som utenfor</translation>
    </message>
    <message>
        <source>the nozzle temperature, °C</source>
        <translation>dysetemperaturen, °C</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>gjør tykkere</translation>
    </message>
    <message>
        <source>one wall</source>
        <translation>én vegg</translation>
    </message>
    <message>
        <source>Print as one wall</source>
        <translation>Print som én vegg</translation>
    </message>
    <message>
        <source>One bead wide, centred on the surface; its rims stay open</source>
        <translation>Én streng bred, sentrert på flaten; rendene forblir åpne</translation>
    </message>
    <message>
        <source>print it as one wall (`openSurfaces=wall`), thicken it to a wall of two beads (`openSurfaces=thicken`), close its rims to make it solid (`openSurfaces=close`), or close it in a modelling program</source>
        <translation>print den som én vegg (`openSurfaces=wall`), gjør den tykkere til en vegg på to strenger (`openSurfaces=thicken`), lukk rendene for å gjøre den solid (`openSurfaces=close`), eller lukk den i et modelleringsprogram</translation>
    </message>
    <message>
        <source>print the sheets as walls of one bead (`openSurfaces=wall`) or two (`openSurfaces=thicken`), or give them a thickness in a modelling program</source>
        <translation>print flakene som vegger på én streng (`openSurfaces=wall`) eller to (`openSurfaces=thicken`), eller gi dem tykkelse i et modelleringsprogram</translation>
    </message>
    <message>
        <source>thicken the surface in a modelling program</source>
        <translation>gi flaten tykkelse i et modelleringsprogram</translation>
    </message>
    <message>
        <source>the open surface was thickened to a wall of {wall:.2f}, half on each side</source>
        <translation>den åpne flaten ble gjort tykkere til en vegg på {wall:.2f}, halvparten på hver side</translation>
    </message>
    <message>
        <source>thicken it to a wall of two beads (`openSurfaces=thicken`), or repair it in a modelling program</source>
        <translation>gjør den tykkere til en vegg på to strenger (`openSurfaces=thicken`), eller reparer den i et modelleringsprogram</translation>
    </message>
    <message>
        <source>the open surface crosses itself at {places} pairs of triangles, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>den åpne flaten krysser seg selv ved {places} trekantpar, det første ved ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface has only one side: it is twisted along {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>den åpne flaten har bare én side: den er vridd langs {edges} kanter, den første ved ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface branches at {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>den åpne flaten forgrener seg ved {edges} kanter, den første ved ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>to get a wall of two beads instead, use `openSurfaces=thicken`</source>
        <translation>for å få en vegg på to strenger i stedet, bruk `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>the open surface is printed as one wall, one bead ({width:.2f}) wide</source>
        <translation>den åpne flaten printes som én vegg, én streng ({width:.2f}) bred</translation>
    </message>
    <message numerus="yes">
        <source>converted {count} lattice beams into round bars</source>
        <translation>
            <numerusform>gjorde om {count} gitterbjelke til en rund stav</numerusform>
            <numerusform>gjorde om {count} gitterbjelker til runde staver</numerusform>
        </translation>
    </message>
    <message>
        <source>{bytes} bytes</source>
        <translation>{bytes} byte</translation>
    </message>
    <message>
        <source>{hours} h {minutes} min</source>
        <translation>{hours} t {minutes} min</translation>
    </message>
    <message numerus="yes">
        <source>{layers} layers, {way}</source>
        <translation>
            <numerusform>{layers} lag, {way}</numerusform>
            <numerusform>{layers} lag, {way}</numerusform>
        </translation>
    </message>
    <message>
        <source>{least:.0f#} to {most:.0f}</source>
        <translation>{least:.0f#} til {most:.0f}</translation>
    </message>
    <message>
        <source>{mass:.1f} g, supports and waste included</source>
        <translation>{mass:.1f} g, støtter og avfall inkludert</translation>
    </message>
    <message>
        <source>{material}, {volume:.1f} cm3 at {density:.2f} g/cm3</source>
        <translation>{material}, {volume:.1f} cm³ ved {density:.2f} g/cm³</translation>
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
        <translation>minst {share:.0f} fylt</translation>
    </message>
    <message>
        <source>{statement}: {found} in the program, {planned} planned</source>
        <translation>{statement}: {found} i programmet, {planned} planlagt</translation>
    </message>
    <message>
        <source>{time} on its controller</source>
        <translation>{time} på sin styring</translation>
    </message>
    <message>
        <source>{way}, {height} each</source>
        <translation>{way}, {height} hver</translation>
    </message>
    <message>
        <source>a cut of the tape</source>
        <translation>et kutt av tapen</translation>
    </message>
    <message>
        <source>a pause for the operator</source>
        <translation>en pause for operatøren</translation>
    </message>
    <message>
        <source>a tool change</source>
        <translation>et verktøybytte</translation>
    </message>
    <message>
        <source>feeding in place</source>
        <translation>mating på stedet</translation>
    </message>
    <message>
        <source>is above 1</source>
        <translation>er over 1</translation>
    </message>
    <message>
        <source>mode {mode} needs a rod, but cell {cell} has none</source>
        <translation>modus {mode} trenger en stang, men cellen {cell} har ingen</translation>
    </message>
    <message>
        <source>must be #RRGGBB</source>
        <translation>må være #RRGGBB</translation>
    </message>
    <message>
        <source>nothing in this file is executed</source>
        <translation>ingenting i denne filen utføres</translation>
    </message>
    <message>
        <source>one</source>
        <translation>én</translation>
    </message>
    <message>
        <source>the report has no item</source>
        <translation>rapporten har ingen elementer</translation>
    </message>
    <message>
        <source>unknown material &apos;{id}&apos;</source>
        <translation>ukjent materiale &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>events of unequal number</source>
        <translation>ulikt antall hendelser</translation>
    </message>
    <message>
        <source>Share of the interior that is filled: the whole is solid, none is hollow. Walls and skins are always solid.</source>
        <translation>Andel av det indre som fylles: hele er massivt, ingenting er hult. Vegger og hud er alltid massive.</translation>
    </message>
    <message>
        <source>sparse pattern</source>
        <translation>glissent mønster</translation>
    </message>
    <message>
        <source>Pattern of the interior if it is not solid.</source>
        <translation>Mønsteret i det indre hvis det ikke er massivt.</translation>
    </message>
    <message>
        <source>top layers</source>
        <translation>topplag</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface above it.</source>
        <translation>Massive lag mellom det glisne indre og overflaten over.</translation>
    </message>
    <message>
        <source>bottom layers</source>
        <translation>bunnlag</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface below it.</source>
        <translation>Massive lag mellom det glisne indre og overflaten under.</translation>
    </message>
    <message>
        <source>skin thickness</source>
        <translation>hudtykkelse</translation>
    </message>
    <message>
        <source>Minimum thickness of the top and bottom layers together with their number.</source>
        <translation>Minste tykkelse på topp- og bunnlagene, i tillegg til antallet.</translation>
    </message>
    <message>
        <source>gyroid</source>
        <translation>gyroide</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>linjer</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>rutenett</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>trekanter</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisk</translation>
    </message>
    <message>
        <source>honeycomb</source>
        <translation>bikake</translation>
    </message>
    <message>
        <source>unknown sparse infill &apos;{id}&apos;</source>
        <translation>ukjent glissent fyll &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>Glissent fyll</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Bro</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Tape</translation>
    </message>
    <message>
        <source>tapes after every n-th layer</source>
        <translation>tape etter hvert n-te lag</translation>
    </message>
    <message>
        <source>Irons tapes of continuous fibre onto every n-th layer but the last; needs a tool for tape. 0: no tapes.</source>
        <translation>Stryker tape av kontinuerlig fiber på hvert n-te lag unntatt det siste; krever et verktøy for tape. 0: ingen tape.</translation>
    </message>
    <message>
        <source>first layer with tapes</source>
        <translation>første lag med tape</translation>
    </message>
    <message>
        <source>Layers are counted from 1, on the platform.</source>
        <translation>Lag telles fra 1, på plattformen.</translation>
    </message>
    <message>
        <source>tapes on a layer</source>
        <translation>taper på et lag</translation>
    </message>
    <message>
        <source>Only the longest tapes of each layer are laid. 0: as many as fit.</source>
        <translation>Bare de lengste tapene i hvert lag legges. 0: så mange som får plass.</translation>
    </message>
    <message>
        <source>paths of tapes</source>
        <translation>tapebaner</translation>
    </message>
    <message>
        <source>Tapes lie beside each other, one width apart.</source>
        <translation>Tapene ligger ved siden av hverandre, med én breddes avstand.</translation>
    </message>
    <message>
        <source>direction of tapes</source>
        <translation>taperetning</translation>
    </message>
    <message>
        <source>Direction of tapes on the first layer with tapes, measured from x to y.</source>
        <translation>Tapenes retning på første lag med tape, målt fra x mot y.</translation>
    </message>
    <message>
        <source>rotation of tapes per layer</source>
        <translation>taperotasjon per lag</translation>
    </message>
    <message>
        <source>Rotation from one layer with tapes to the next.</source>
        <translation>Rotasjon fra ett lag med tape til det neste.</translation>
    </message>
    <message>
        <source>distance of tape ends</source>
        <translation>avstand til tapeender</translation>
    </message>
    <message>
        <source>Least distance of the ends of tapes from the outline, so that plastic encloses them. The sides are inside the outline.</source>
        <translation>Minste avstand fra tapeendene til omrisset, slik at plasten omslutter dem. Sidene er innenfor omrisset.</translation>
    </message>
    <message>
        <source>curves for tapes</source>
        <translation>kurver for tape</translation>
    </message>
    <message>
        <source>For tapes along given curves: points x,y or x,y,z in mm on the plate, separated by spaces, and semicolons between curves; or a file of them.</source>
        <translation>For tape langs gitte kurver: punkter x,y eller x,y,z i mm på byggeplaten, atskilt med mellomrom, og semikolon mellom kurver; eller en fil med slike.</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Fiber</translation>
    </message>
    <message>
        <source>along a field of directions</source>
        <translation>langs et retningsfelt</translation>
    </message>
    <message>
        <source>there is no field of directions for tapes</source>
        <translation>det finnes ikke noe retningsfelt for tape</translation>
    </message>
    <message>
        <source>give place and direction as x,y,z,dx,dy,dz, separated by spaces or lines</source>
        <translation>oppgi sted og retning som x,y,z,dx,dy,dz, atskilt med mellomrom eller linjer</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no direction at a place</source>
        <translation>&apos;{part}&apos; er ikke en retning på et sted</translation>
    </message>
    <message>
        <source>field of tape directions</source>
        <translation>felt av taperetninger</translation>
    </message>
    <message>
        <source>For tapes along a field: x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them.</source>
        <translation>For tape langs et felt: x,y,z,dx,dy,dz i mm på byggeplaten, atskilt med mellomrom eller linjer, eller en fil med slike.</translation>
    </message>
    <message>
        <source>in one direction</source>
        <translation>i én retning</translation>
    </message>
    <message>
        <source>along the outline</source>
        <translation>langs omrisset</translation>
    </message>
    <message>
        <source>along given curves</source>
        <translation>langs gitte kurver</translation>
    </message>
    <message>
        <source>unknown paths of tapes &apos;{id}&apos;</source>
        <translation>ukjente tapebaner &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>give points in mm: x,y or x,y,z, separated by spaces, at least two for each curve, and semicolons between curves</source>
        <translation>oppgi punkter i mm: x,y eller x,y,z, atskilt med mellomrom, minst to for hver kurve, og semikolon mellom kurver</translation>
    </message>
    <message>
        <source>no tool of the job lays tape</source>
        <translation>ingen av jobbens verktøy legger tape</translation>
    </message>
    <message>
        <source>add a tool with a process for tape, such as tape-5, or set `fibreLayers=0`</source>
        <translation>legg til et verktøy med en prosess for tape, som tape-5, eller sett `fibreLayers=0`</translation>
    </message>
    <message>
        <source>process {process} lays tape and prints no beads</source>
        <translation>prosessen {process} legger tape og printer ingen strenger</translation>
    </message>
    <message>
        <source>choose it for a further tool, and another one for the part</source>
        <translation>velg den for et ekstra verktøy, og en annen for delen</translation>
    </message>
    <message>
        <source>no tape fits into the layers chosen for tapes: {width} wide and at least {length:.0f} long</source>
        <translation>ingen tape får plass i lagene som er valgt for tape: {width} bred og minst {length:.0f} lang</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`), other paths (`fibrePaths`), or a narrower tape</source>
        <translation>velg en annen retning (`fibreAngle`), andre baner (`fibrePaths`), eller en smalere tape</translation>
    </message>
    <message>
        <source>{bent:.0f} of tape is left out because it bends more than a radius of {radius:.0f} allows, {short:.0f} because its pieces are shorter than {length:.0f}</source>
        <translation>{bent:.0f} tape utelates fordi den bøyes mer enn en radius på {radius:.0f} tillater, {short:.0f} fordi bitene er kortere enn {length:.0f}</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`) or other paths (`fibrePaths`)</source>
        <translation>velg en annen retning (`fibreAngle`) eller andre baner (`fibrePaths`)</translation>
    </message>
    <message>
        <source>plastic does not cover the tape: {length:.0f} on layer {layer}, from this place on</source>
        <translation>plasten dekker ikke tapen: {length:.0f} på lag {layer}, fra dette stedet</translation>
    </message>
    <message>
        <source>increase `fibreEndMm`, or choose layers that others cover (`fibreLayers`, `fibreFirstLayer`)</source>
        <translation>øk `fibreEndMm`, eller velg lag som dekkes av andre (`fibreLayers`, `fibreFirstLayer`)</translation>
    </message>
    <message>
        <source>is not less than &apos;widthMm&apos;</source>
        <translation>er ikke mindre enn &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is less than half of &apos;widthMm&apos;</source>
        <translation>er mindre enn halve &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is not less than &apos;leastLengthMm&apos;</source>
        <translation>er ikke mindre enn &apos;leastLengthMm&apos;</translation>
    </message>
    <message numerus="yes">
        <source>the skins above a hollow interior have nothing to rest on: {paths} beads, from this place on</source>
        <translation>
            <numerusform>huden over et hult indre har ingenting å hvile på: {paths} streng, fra dette stedet</numerusform>
            <numerusform>hudene over et hult indre har ingenting å hvile på: {paths} strenger, fra dette stedet</numerusform>
        </translation>
    </message>
    <message>
        <source>set `infillDensity` to 0.1 or more; for a part that is open at the top, set `topLayers` to 0</source>
        <translation>sett `infillDensity` til 0.1 eller mer; for en del som er åpen på toppen, sett `topLayers` til 0</translation>
    </message>
    <message>
        <source>thin walls</source>
        <translation>tynne vegger</translation>
    </message>
    <message>
        <source>as the narrowest bead</source>
        <translation>som den smaleste strengen</translation>
    </message>
    <message>
        <source>leave out</source>
        <translation>utelat</translation>
    </message>
    <message>
        <source>Walls narrower than the narrowest bead: printed as that bead, and so too wide, or left out. Below half its width they are always left out.</source>
        <translation>Vegger smalere enn den smaleste strengen: printes som den strengen, og dermed for brede, eller utelates. Under halve bredden utelates de alltid.</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is printed too wide: with the narrowest bead, {bead:.3g}</source>
        <translation>{length:.0f} vegg, ned til {width:.2f} tynn, printes for bredt: med den smaleste strengen, {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or leave them out (`thinWalls=omit`)</source>
        <translation>bruk en finere dyse, eller utelat dem (`thinWalls=omit`)</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is left out: the narrowest bead is {bead:.3g}</source>
        <translation>{length:.0f} vegg, ned til {width:.2f} tynn, utelates: den smaleste strengen er {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print them with that bead (`thinWalls=bead`)</source>
        <translation>bruk en finere dyse, eller print dem med den strengen (`thinWalls=bead`)</translation>
    </message>
    <message>
        <source>use thinner layers, or a part with steeper walls; another spiral may begin there</source>
        <translation>bruk tynnere lag, eller en del med brattere vegger; en ny spiral kan begynne der</translation>
    </message>
    <message>
        <source>the spiral ends below layer {layer} of {layers}, which does not continue the layer before</source>
        <translation>spiralen slutter under lag {layer} av {layers}, som ikke fortsetter laget før</translation>
    </message>
    <message>
        <source>print towers as separate items, or cut off the part there; layers of several beads are printed as usual</source>
        <translation>print tårn som separate elementer, eller kapp delen der; lag med flere strenger printes som vanlig</translation>
    </message>
    <message numerus="yes">
        <source>the spiral ends below layer {layer} of {layers}: it has {beads} beads, not one closed loop</source>
        <translation>
            <numerusform>spiralen slutter under lag {layer} av {layers}: det har {beads} streng som ikke er en lukket sløyfe</numerusform>
            <numerusform>spiralen slutter under lag {layer} av {layers}: det har {beads} strenger, ikke én lukket sløyfe</numerusform>
        </translation>
    </message>
    <message>
        <source>{first} and {second} overlap</source>
        <translation>{first} og {second} overlapper</translation>
    </message>
    <message>
        <source>arrange the parts</source>
        <translation>ordne delene</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or arrange them</source>
        <translation>flytt en av delene på siden Klargjør, eller ordne dem</translation>
    </message>
    <message>
        <source>the head may touch {first} or {second} beside the other one: they are {gap:.1f} apart, the head needs {needed:.1f}</source>
        <translation>hodet kan berøre {first} eller {second} ved siden av den andre: de er {gap:.1f} fra hverandre, hodet trenger {needed:.1f}</translation>
    </message>
    <message>
        <source>{share:.2g} of {first} cannot be printed layer by layer: its layers tilt the head into {second}</source>
        <translation>{share:.2g} av {first} kan ikke printes lag for lag: lagene tilter hodet inn i {second}</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or print one after another</source>
        <translation>flytt en av delene på siden Klargjør, eller print en etter en</translation>
    </message>
    <message>
        <source>print one after another, or move {second} by {move:.0f}</source>
        <translation>print en etter en, eller flytt {second} {move:.0f}</translation>
    </message>
    <message>
        <source>print one after another</source>
        <translation>print en etter en</translation>
    </message>
    <message>
        <source>move {second} by {move:.0f}</source>
        <translation>flytt {second} {move:.0f}</translation>
    </message>
    <message>
        <source>print them as separate jobs</source>
        <translation>print dem som separate jobber</translation>
    </message>
    <message>
        <source>the flange carries {carried:.3g} kg, {material:.3g} kg of it printed material; the robot is rated for {most:.3g} kg</source>
        <translation>flensen bærer {carried:.3g} kg, {material:.3g} kg av det printet materiale; robotens bæreevne er {most:.3g} kg</translation>
    </message>
    <message>
        <source>print a smaller part, or with less infill, or use a stronger robot</source>
        <translation>print en mindre del, eller med mindre fyll, eller bruk en sterkere robot</translation>
    </message>
    <message>
        <source>choose a cell with a stronger robot on the Prepare page</source>
        <translation>velg en celle med en sterkere robot på siden Klargjør</translation>
    </message>
    <message>
        <source>is above {limit:.0f}</source>
        <translation>er over {limit:.0f}</translation>
    </message>
    <message>
        <source>is longer than maxLayerTimeS</source>
        <translation>er lengre enn maxLayerTimeS</translation>
    </message>
    <message>
        <source>`maxLayerTimeS={greatest:.0f}` is shorter than the {least:.0f} that {material} has to cool</source>
        <translation>`maxLayerTimeS={greatest:.0f}` er kortere enn de {least:.0f} {material} har til å kjøle seg ned</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than the {greatest:.0f} in which {material} bonds</source>
        <translation>`minLayerTimeS={least:.0f}` er lengre enn de {greatest:.0f} {material} binder innenfor</translation>
    </message>
    <message>
        <source>give a longer maximum, or another material</source>
        <translation>oppgi et lengre maksimum, eller et annet materiale</translation>
    </message>
    <message>
        <source>give a shorter minimum, or another material</source>
        <translation>oppgi et kortere minimum, eller et annet materiale</translation>
    </message>
    <message>
        <source>arrange the parts, or print them layer by layer</source>
        <translation>ordne delene, eller print dem lag for lag</translation>
    </message>
    <message>
        <source>Print layer by layer</source>
        <translation>Print lag for lag</translation>
    </message>
    <message>
        <source>All parts grow together, so that no finished part is in the way</source>
        <translation>Alle deler vokser sammen, så ingen ferdig del er i veien</translation>
    </message>
    <message>
        <source>the plate has no room for {parts} parts</source>
        <translation>byggeplaten har ikke plass til {parts} deler</translation>
    </message>
    <message>
        <source>print fewer or smaller parts, or use a cell with a larger plate</source>
        <translation>print færre eller mindre deler, eller bruk en celle med større byggeplate</translation>
    </message>
    <message>
        <source>a spiral is printed alone</source>
        <translation>en spiral printes alene</translation>
    </message>
    <message>
        <source>remove the other parts, or set spiral to false</source>
        <translation>fjern de andre delene, eller sett spiral til false</translation>
    </message>
    <message>
        <source>a part around a rod or on a body is printed alone</source>
        <translation>en del rundt en stang eller på et legeme printes alene</translation>
    </message>
    <message>
        <source>remove the other parts, or choose a way of building on a plate</source>
        <translation>fjern de andre delene, eller velg en byggemåte på en byggeplate</translation>
    </message>
    <message>
        <source>{parts} parts are too many for a job</source>
        <translation>{parts} deler er for mange for en jobb</translation>
    </message>
    <message>
        <source>print up to {most} parts</source>
        <translation>print opptil {most} deler</translation>
    </message>
    <message>
        <source>a part on a ground of its own is printed alone</source>
        <translation>en del på eget underlag printes alene</translation>
    </message>
    <message>
        <source>remove the other parts, or give `pathsOn=plate`</source>
        <translation>fjern de andre delene, eller oppgi `pathsOn=plate`</translation>
    </message>
    <message>
        <source>different for each part</source>
        <translation>ulik for hver del</translation>
    </message>
    <message>
        <source>the bed temperature, °C</source>
        <translation>byggeplatetemperaturen, °C</translation>
    </message>
    <message>
        <source>a wait until the bed is hot</source>
        <translation>en venting til byggeplaten er varm</translation>
    </message>
    <message>
        <source>must be at most {most}</source>
        <translation>må være høyst {most}</translation>
    </message>
    <message>
        <source>must be one line that is not empty</source>
        <translation>må være én linje som ikke er tom</translation>
    </message>
    <message>
        <source>has no statements</source>
        <translation>har ingen setninger</translation>
    </message>
    <message>
        <source>has its statements already</source>
        <translation>har allerede setningene sine</translation>
    </message>
    <message>
        <source>must be between {least} and 1</source>
        <translation>må være mellom {least} og 1</translation>
    </message>
    <message>
        <source>a wait for the extruder&apos;s start lag</source>
        <translation>en venting på ekstruderens startforsinkelse</translation>
    </message>
    <message>
        <source>stopping the extruder ahead of a bead&apos;s end</source>
        <translation>stopp av ekstruderen før enden av en streng</translation>
    </message>
    <message>
        <source>extruder {extruder} cannot keep the start and stop lag of process {process}</source>
        <translation>ekstruderen {extruder} kan ikke holde start- og stoppforsinkelsen i prosessen {process}</translation>
    </message>
    <message>
        <source>turning off the nozzle&apos;s heating</source>
        <translation>avslåing av dysens oppvarming</translation>
    </message>
    <message>
        <source>turning off the bed&apos;s heating</source>
        <translation>avslåing av byggeplatens oppvarming</translation>
    </message>
    <message>
        <source>part cooling {found} % from this line on, {planned} % planned</source>
        <translation>delkjøling {found} % fra denne linjen, {planned} % planlagt</translation>
    </message>
    <message>
        <source>is above 250</source>
        <translation>er over 250</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a material&apos;s id</source>
        <translation>&apos;{id}&apos; kan ikke være id-en til et materiale</translation>
    </message>
    <message>
        <source>use small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>bruk små bokstaver, sifre, &apos;-&apos;, &apos;_&apos; og &apos;.&apos;</translation>
    </message>
    <message>
        <source>a material &apos;{id}&apos; comes with the program</source>
        <translation>et materiale &apos;{id}&apos; følger med programmet</translation>
    </message>
    <message>
        <source>choose another id</source>
        <translation>velg en annen id</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Kjøling</translation>
    </message>
    <message>
        <source>minimum layer time</source>
        <translation>minste lagtid</translation>
    </message>
    <message>
        <source>Minimum time before a bead is covered by the next layer, at every place. The robot waits above the part where the order of the beads does not give them this time. 0: no limit.</source>
        <translation>Minste tid før en streng dekkes av neste lag, på hvert sted. Roboten venter over delen der rekkefølgen på strengene ikke gir dem denne tiden. 0: ingen grense.</translation>
    </message>
    <message>
        <source>maximum layer time</source>
        <translation>største lagtid</translation>
    </message>
    <message>
        <source>Age up to which a bead still bonds with the one above it. Older places are reported. 0: no limit.</source>
        <translation>Alder en streng kan ha og fortsatt binde seg til strengen over. Eldre steder rapporteres. 0: ingen grense.</translation>
    </message>
    <message>
        <source>a wait</source>
        <translation>en venting</translation>
    </message>
    <message>
        <source>lower the minimum layer time, print slower, or print without a spiral</source>
        <translation>senk den minste lagtiden, print langsommere, eller print uten spiral</translation>
    </message>
    <message>
        <source>only you know how long a bead has to cool: change the minimum layer time</source>
        <translation>bare du vet hvor lenge en streng må kjøle: endre den minste lagtiden</translation>
    </message>
    <message>
        <source>the bead below is {time:.1f} old when it is covered, beyond the maximum layer time of {limit:.1f}; so are {length:.0f} of beads</source>
        <translation>strengen under er {time:.1f} gammel når den dekkes, over den største lagtiden på {limit:.1f}; det samme gjelder {length:.0f} streng</translation>
    </message>
    <message>
        <source>print faster, or fewer parts at a time</source>
        <translation>print raskere, eller færre deler om gangen</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average; at least {limit:.0f} required.</source>
        <translation>Tid mellom lag: {shortest:.1f} til {longest:.1f} på sin styring, {mean:.1f} i snitt; minst {limit:.0f} kreves.</translation>
    </message>
    <message>
        <source>Layer time</source>
        <translation>Lagtid</translation>
    </message>
    <message>
        <source>slowest speed for cooling</source>
        <translation>laveste hastighet for kjøling</translation>
    </message>
    <message>
        <source>Down to this speed beads are printed slower to keep the minimum layer time, before the robot waits. 0: it only waits.</source>
        <translation>Ned til denne hastigheten printes strenger langsommere for å holde den minste lagtiden, før roboten venter. 0: den bare venter.</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average.</source>
        <translation>Tid mellom lag: {shortest:.1f} til {longest:.1f} på sin styring, {mean:.1f} i snitt.</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than `maxLayerTimeS={greatest:.0f}`</source>
        <translation>`minLayerTimeS={least:.0f}` er lengre enn `maxLayerTimeS={greatest:.0f}`</translation>
    </message>
    <message>
        <source>give a shorter minimum, or a longer maximum</source>
        <translation>oppgi et kortere minimum, eller et lengre maksimum</translation>
    </message>
    <message>
        <source>#RRGGBB, for the view.</source>
        <translation>#RRGGBB, for visningen.</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a process&apos;s id</source>
        <translation>&apos;{id}&apos; kan ikke være id-en til en prosess</translation>
    </message>
    <message>
        <source>0: as in the process.</source>
        <translation>0: som i prosessen.</translation>
    </message>
    <message>
        <source>Beads are nowhere narrower.</source>
        <translation>Strenger er ingen steder smalere.</translation>
    </message>
    <message>
        <source>Beads are nowhere wider.</source>
        <translation>Strenger er ingen steder bredere.</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Broer</translation>
    </message>
    <message>
        <source>Colder nozzles do not print it.</source>
        <translation>Kaldere dyser printer det ikke.</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thicker.</source>
        <translation>Krumme lag er ingen steder tykkere.</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thinner.</source>
        <translation>Krumme lag er ingen steder tynnere.</translation>
    </message>
    <message>
        <source>Density of the printed material.</source>
        <translation>Tettheten til det printede materialet.</translation>
    </message>
    <message>
        <source>Diameter of the nozzle&apos;s opening.</source>
        <translation>Diameteren på dyseåpningen.</translation>
    </message>
    <message>
        <source>Distance of waypoints along a tool-path.</source>
        <translation>Avstanden mellom banepunkter langs en verktøybane.</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Ekstruder</translation>
    </message>
    <message>
        <source>Factor of the bead&apos;s section.</source>
        <translation>Faktor for strengens tverrsnitt.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Elementer</translation>
    </message>
    <message>
        <source>Flow at full scale of the analogue output.</source>
        <translation>Materialstrøm ved fullt utslag på den analoge utgangen.</translation>
    </message>
    <message>
        <source>For people, for example how to dry it.</source>
        <translation>For mennesker, for eksempel hvordan det tørkes.</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Hode</translation>
    </message>
    <message>
        <source>Height and radius of its sections, in mm.</source>
        <translation>Høyde og radius for tverrsnittene, i mm.</translation>
    </message>
    <message>
        <source>Hotter nozzles damage it.</source>
        <translation>Varmere dyser skader det.</translation>
    </message>
    <message>
        <source>How deep the head may enter soft beads before it is a collision.</source>
        <translation>Hvor dypt hodet kan gå inn i myke strenger før det er en kollisjon.</translation>
    </message>
    <message>
        <source>In your currency. 0: unknown.</source>
        <translation>I egen valuta. 0: ukjent.</translation>
    </message>
    <message>
        <source>Length of filament that is retracted for a travel. 0: none.</source>
        <translation>Filamentlengden som trekkes tilbake ved en tomkjøring. 0: ingen.</translation>
    </message>
    <message>
        <source>Length that a bead bridges, unless the process states it.</source>
        <translation>Lengden en streng bygger bro over, med mindre prosessen angir den.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenser</translation>
    </message>
    <message>
        <source>Material that the process prints.</source>
        <translation>Materialet prosessen printer.</translation>
    </message>
    <message>
        <source>Maximum acceleration of the nozzle.</source>
        <translation>Dysens største akselerasjon.</translation>
    </message>
    <message>
        <source>Maximum length of an unsupported bridge.</source>
        <translation>Største lengde på en bro uten støtte.</translation>
    </message>
    <message>
        <source>Maximum speed on a bridge.</source>
        <translation>Største hastighet på en bro.</translation>
    </message>
    <message>
        <source>Melted at most, whatever the process allows.</source>
        <translation>Det meste som smeltes, uansett hva prosessen tillater.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Annet</translation>
    </message>
    <message>
        <source>Part cooling from the second layer on, 0 to 1.</source>
        <translation>Delkjøling fra og med andre lag, 0 til 1.</translation>
    </message>
    <message>
        <source>Part cooling of bridges, 0 to 1.</source>
        <translation>Delkjøling av broer, 0 til 1.</translation>
    </message>
    <message>
        <source>Shown in lists and reports.</source>
        <translation>Vises i lister og rapporter.</translation>
    </message>
    <message>
        <source>Speed of the nozzle between tool-paths.</source>
        <translation>Dysens hastighet mellom verktøybaner.</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Hastigheter</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Temperaturer</translation>
    </message>
    <message>
        <source>The extruder runs this long before a tool-path begins.</source>
        <translation>Ekstruderen går så lenge før en verktøybane begynner.</translation>
    </message>
    <message>
        <source>Usual height of a layer, and of a bead.</source>
        <translation>Vanlig høyde på et lag, og på en streng.</translation>
    </message>
    <message>
        <source>Usual speed of the nozzle while it prints.</source>
        <translation>Dysens vanlige hastighet mens den printer.</translation>
    </message>
    <message>
        <source>Usual temperature of the nozzle.</source>
        <translation>Dysens vanlige temperatur.</translation>
    </message>
    <message>
        <source>Usual temperature of the plate.</source>
        <translation>Byggeplatens vanlige temperatur.</translation>
    </message>
    <message>
        <source>Usual width of a bead.</source>
        <translation>Vanlig bredde på en streng.</translation>
    </message>
    <message>
        <source>Whatever the process allows.</source>
        <translation>Uansett hva prosessen tillater.</translation>
    </message>
    <message>
        <source>a process &apos;{id}&apos; comes with the program</source>
        <translation>en prosess &apos;{id}&apos; følger med programmet</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>akselerasjon</translation>
    </message>
    <message>
        <source>any</source>
        <translation>vilkårlig</translation>
    </message>
    <message>
        <source>as elsewhere</source>
        <translation>som ellers</translation>
    </message>
    <message>
        <source>as in the process</source>
        <translation>som i prosessen</translation>
    </message>
    <message>
        <source>block height</source>
        <translation>blokkhøyde</translation>
    </message>
    <message>
        <source>block width</source>
        <translation>blokkbredde</translation>
    </message>
    <message>
        <source>bridge flow</source>
        <translation>materialstrøm i bro</translation>
    </message>
    <message>
        <source>bridge length in bead widths</source>
        <translation>brolengde i strengbredder</translation>
    </message>
    <message>
        <source>bridge speed</source>
        <translation>brohastighet</translation>
    </message>
    <message>
        <source>cannot be deleted</source>
        <translation>kan ikke slettes</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>farge</translation>
    </message>
    <message>
        <source>cone angle</source>
        <translation>kjeglevinkel</translation>
    </message>
    <message>
        <source>cone angle must be below 180°</source>
        <translation>kjeglevinkelen må være under 180°</translation>
    </message>
    <message>
        <source>cone height</source>
        <translation>kjeglehøyde</translation>
    </message>
    <message>
        <source>contact tolerance</source>
        <translation>kontakttoleranse</translation>
    </message>
    <message>
        <source>density</source>
        <translation>tetthet</translation>
    </message>
    <message>
        <source>export the head with its nozzle pointing down</source>
        <translation>eksporter hodet med dysen pekende nedover</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>vifte</translation>
    </message>
    <message>
        <source>fan on bridges</source>
        <translation>vifte på broer</translation>
    </message>
    <message>
        <source>first-layer flow</source>
        <translation>materialstrøm på første lag</translation>
    </message>
    <message>
        <source>first-layer width</source>
        <translation>bredde på første lag</translation>
    </message>
    <message>
        <source>infill flow</source>
        <translation>materialstrøm i fyll</translation>
    </message>
    <message>
        <source>inner-wall flow</source>
        <translation>materialstrøm i indre vegger</translation>
    </message>
    <message>
        <source>is above 1000</source>
        <translation>er over 1000</translation>
    </message>
    <message>
        <source>is above 30 g/cm3: check the unit</source>
        <translation>er over 30 g/cm3: kontroller enheten</translation>
    </message>
    <message>
        <source>is above {most} {unit}: check the unit</source>
        <translation>er over {most} {unit}: kontroller enheten</translation>
    </message>
    <message>
        <source>is below 1</source>
        <translation>er under 1</translation>
    </message>
    <message>
        <source>is {usual}, above &apos;max&apos;, which is {most}</source>
        <translation>er {usual}, over &apos;max&apos;, som er {most}</translation>
    </message>
    <message>
        <source>is {usual}, below &apos;min&apos;, which is {least}</source>
        <translation>er {usual}, under &apos;min&apos;, som er {least}</translation>
    </message>
    <message>
        <source>label</source>
        <translation>etikett</translation>
    </message>
    <message>
        <source>longest bridge</source>
        <translation>lengste bro</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiale</translation>
    </message>
    <message>
        <source>maximum bead width</source>
        <translation>største strengbredde</translation>
    </message>
    <message>
        <source>maximum flow</source>
        <translation>største materialstrøm</translation>
    </message>
    <message>
        <source>maximum layer height</source>
        <translation>største laghøyde</translation>
    </message>
    <message>
        <source>maximum nozzle temperature</source>
        <translation>høyeste dysetemperatur</translation>
    </message>
    <message>
        <source>minimum bead width</source>
        <translation>minste strengbredde</translation>
    </message>
    <message>
        <source>minimum layer height</source>
        <translation>minste laghøyde</translation>
    </message>
    <message>
        <source>minimum nozzle temperature</source>
        <translation>laveste dysetemperatur</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>må ikke være tom</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>notater</translation>
    </message>
    <message>
        <source>nozzle diameter</source>
        <translation>dysediameter</translation>
    </message>
    <message>
        <source>nozzle temperature</source>
        <translation>dysetemperatur</translation>
    </message>
    <message>
        <source>nozzle tip radius</source>
        <translation>radius på dysespissen</translation>
    </message>
    <message>
        <source>outer-wall flow</source>
        <translation>materialstrøm i ytre vegg</translation>
    </message>
    <message>
        <source>outer-wall width</source>
        <translation>bredde på ytre vegg</translation>
    </message>
    <message>
        <source>plate temperature</source>
        <translation>byggeplatetemperatur</translation>
    </message>
    <message>
        <source>price per kg</source>
        <translation>pris per kg</translation>
    </message>
    <message>
        <source>prime time</source>
        <translation>primetid</translation>
    </message>
    <message>
        <source>print speed</source>
        <translation>printhastighet</translation>
    </message>
    <message>
        <source>reduce angle or height of the cone</source>
        <translation>reduser vinkelen eller høyden på kjeglen</translation>
    </message>
    <message>
        <source>retraction length</source>
        <translation>tilbaketrekkingslengde</translation>
    </message>
    <message>
        <source>sparse-infill flow</source>
        <translation>materialstrøm i glissent fyll</translation>
    </message>
    <message>
        <source>sparse-infill speed</source>
        <translation>hastighet for glissent fyll</translation>
    </message>
    <message>
        <source>support flow</source>
        <translation>materialstrøm i støtter</translation>
    </message>
    <message>
        <source>support width</source>
        <translation>støttebredde</translation>
    </message>
    <message>
        <source>the cone is {cone} wide at its top, more than the block&apos;s corners, {block}</source>
        <translation>kjeglen er {cone} bred på toppen, mer enn blokkens hjørner, {block}</translation>
    </message>
    <message>
        <source>the mesh is flat: it has no height along z</source>
        <translation>meshen er flat: den har ingen høyde langs z</translation>
    </message>
    <message>
        <source>travel speed</source>
        <translation>tomkjøringshastighet</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukjent</translation>
    </message>
    <message>
        <source>waypoint distance</source>
        <translation>banepunktavstand</translation>
    </message>
    <message>
        <source>{name} must be greater than 0</source>
        <translation>{name} må være større enn 0</translation>
    </message>
    <message>
        <source>&apos;Pause&apos; does not wait for the motions before it (QueueTag)</source>
        <translation>&apos;Pause&apos; venter ikke på bevegelsene før den (QueueTag)</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of tools</source>
        <translation>&apos;{text}&apos; er ikke en liste over verktøy</translation>
    </message>
    <message>
        <source>Material that flows out at the place of the tool change after each change of the tool.</source>
        <translation>Materialet som renner ut på verktøybytteplassen etter hvert verktøybytte.</translation>
    </message>
    <message>
        <source>Mode planar: numbers of the tools that print the pieces, separated by commas. The list starts over if there are more pieces. Empty: the tool of the part.</source>
        <translation>Modus planar: numrene til verktøyene som printer stykkene, atskilt med komma. Listen begynner på nytt hvis det er flere stykker. Tom: delens verktøy.</translation>
    </message>
    <message>
        <source>Number of the tool that fills the interior within walls and skins; 0: that of the part.</source>
        <translation>Nummeret til verktøyet som fyller det indre innenfor vegger og hud; 0: delens verktøy.</translation>
    </message>
    <message>
        <source>Number of the tool that prints supports; 0: that of the part.</source>
        <translation>Nummeret til verktøyet som printer støtter; 0: delens verktøy.</translation>
    </message>
    <message>
        <source>Number of the tool that prints the part. The tips of all tools are in one place, that of the cell&apos;s nozzle.</source>
        <translation>Nummeret til verktøyet som printer delen. Spissene på alle verktøy er på ett sted, der cellens dyse er.</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Verktøybytter</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Verktøy</translation>
    </message>
    <message>
        <source>a purge of the nozzle</source>
        <translation>en spyling av dysen</translation>
    </message>
    <message>
        <source>a tool is selected together with a command</source>
        <translation>et verktøy velges sammen med en kommando</translation>
    </message>
    <message>
        <source>add a tool, or give the number of one</source>
        <translation>legg til et verktøy, eller oppgi nummeret til et</translation>
    </message>
    <message>
        <source>are those of a changer</source>
        <translation>er de til en veksler</translation>
    </message>
    <message>
        <source>cannot be changer: the nozzle does not move</source>
        <translation>kan ikke være changer: dysen beveger seg ikke</translation>
    </message>
    <message>
        <source>cell {cell} has no dock for tool {tool}</source>
        <translation>cellen {cell} har ingen dokk for verktøy {tool}</translation>
    </message>
    <message>
        <source>give numbers, such as 1,2</source>
        <translation>oppgi tall, for eksempel 1,2</translation>
    </message>
    <message>
        <source>give up to {most}</source>
        <translation>oppgi opptil {most}</translation>
    </message>
    <message>
        <source>locking the tool</source>
        <translation>låsing av verktøyet</translation>
    </message>
    <message>
        <source>the selection of the first tool</source>
        <translation>valget av første verktøy</translation>
    </message>
    <message>
        <source>the tool that the program begins with</source>
        <translation>verktøyet programmet begynner med</translation>
    </message>
    <message>
        <source>before {event}</source>
        <translation>før {event}</translation>
    </message>
    <message>
        <source>behind {event}</source>
        <translation>etter {event}</translation>
    </message>
    <message>
        <source>the time for {event}</source>
        <translation>tiden for {event}</translation>
    </message>
    <message>
        <source>the text of the stop</source>
        <translation>teksten til stoppen</translation>
    </message>
    <message>
        <source>a motion that begins with no tool</source>
        <translation>en bevegelse som begynner uten verktøy</translation>
    </message>
    <message>
        <source>the output of a tool is not set: an earlier run may have left it on</source>
        <translation>utgangen til et verktøy er ikke satt: en tidligere kjøring kan ha latt den stå på</translation>
    </message>
    <message>
        <source>the arm does not get to the place for purges without a collision</source>
        <translation>armen kommer ikke til spyleplassen uten kollisjon</translation>
    </message>
    <message>
        <source>move the place or the part</source>
        <translation>flytt plassen eller delen</translation>
    </message>
    <message>
        <source>the nozzle does not move</source>
        <translation>dysen beveger seg ikke</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the {body}</source>
        <translation>en priming eller spyling på {volume:.0f} faller på {body}</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the plate, beside the print</source>
        <translation>en priming eller spyling på {volume:.0f} faller på byggeplaten, ved siden av printen</translation>
    </message>
    <message>
        <source>state a place for purges in the cell (purgeMm), or move the part</source>
        <translation>angi en spyleplass i cellen (purgeMm), eller flytt delen</translation>
    </message>
    <message>
        <source>remove the strand before it is dragged along, or state a place for purges in the cell (purgeMm)</source>
        <translation>fjern tråden før den dras med, eller angi en spyleplass i cellen (purgeMm)</translation>
    </message>
    <message>
        <source>print</source>
        <translation>print</translation>
    </message>
    <message>
        <source>workpiece</source>
        <translation>arbeidsstykke</translation>
    </message>
    <message>
        <source>the arm does not reach the place for purges</source>
        <translation>armen når ikke spyleplassen</translation>
    </message>
    <message>
        <source>the arm collides at the place for purges</source>
        <translation>armen kolliderer ved spyleplassen</translation>
    </message>
    <message>
        <source>move the place for purges</source>
        <translation>flytt spyleplassen</translation>
    </message>
    <message>
        <source>move the dock or the part</source>
        <translation>flytt dokken eller delen</translation>
    </message>
    <message>
        <source>must be hand, feeder or changer</source>
        <translation>må være hand, feeder eller changer</translation>
    </message>
    <message>
        <source>purge</source>
        <translation>spyling</translation>
    </message>
    <message>
        <source>releasing the tool</source>
        <translation>frigjøring av verktøyet</translation>
    </message>
    <message>
        <source>remove a tool, or choose another cell</source>
        <translation>fjern et verktøy, eller velg en annen celle</translation>
    </message>
    <message>
        <source>the arm does not get to the dock of tool {number} without a collision</source>
        <translation>armen kommer ikke til dokken for verktøy {number} uten kollisjon</translation>
    </message>
    <message>
        <source>the extruder {extruder} prints with one tool</source>
        <translation>ekstruderen {extruder} printer med ett verktøy</translation>
    </message>
    <message>
        <source>the job has no tool {number}, it has {tools}</source>
        <translation>jobben har ikke noe verktøy {number}, den har {tools}</translation>
    </message>
    <message>
        <source>the outputs of several tools are on</source>
        <translation>utgangene til flere verktøy er på</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>verktøy</translation>
    </message>
    <message>
        <source>tool {number} cannot print layers of {height}</source>
        <translation>verktøy {number} kan ikke printe lag på {height}</translation>
    </message>
    <message>
        <source>tool {number}: {material}, {process}, {mass:.1f} g</source>
        <translation>verktøy {number}: {material}, {process}, {mass:.1f} g</translation>
    </message>
    <message>
        <source>tools of the pieces</source>
        <translation>verktøy for stykkene</translation>
    </message>
    <message>
        <source>{changes}, {mass:.1f} g purged</source>
        <translation>{changes}, {mass:.1f} g spylt</translation>
    </message>
    <message>
        <source>{tools} tools are too many for a job</source>
        <translation>{tools} verktøy er for mange for en jobb</translation>
    </message>
    <message>
        <source>export it in millimetres</source>
        <translation>eksporter den i millimeter</translation>
    </message>
    <message>
        <source>the mesh is only {height} high</source>
        <translation>meshen er bare {height} høy</translation>
    </message>
    <message>
        <source>Layer times</source>
        <translation>Lagtider</translation>
    </message>
    <message>
        <source>Time that a bead needs before the next layer covers it, unless the job states it.</source>
        <translation>Tiden en streng trenger før neste lag dekker den, med mindre jobben angir den.</translation>
    </message>
    <message>
        <source>Age up to which a bead bonds with the next layer, unless the job states it.</source>
        <translation>Alder en streng kan ha og fortsatt binde seg til neste lag, med mindre jobben angir den.</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skudd</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Sting</translation>
    </message>
    <message>
        <source>spacing of stitches</source>
        <translation>stingavstand</translation>
    </message>
    <message>
        <source>Mode flat: distance of pockets that are filled from above in one shot and lock the layers together. 0: none.</source>
        <translation>Modus flat: avstanden mellom lommer som fylles ovenfra i ett skudd og låser lagene sammen. 0: ingen.</translation>
    </message>
    <message>
        <source>diameter of stitches</source>
        <translation>stingdiameter</translation>
    </message>
    <message>
        <source>stitches after every n-th layer</source>
        <translation>sting etter hvert n-te lag</translation>
    </message>
    <message>
        <source>Pockets end at the top of these layers.</source>
        <translation>Lommer slutter på toppen av disse lagene.</translation>
    </message>
    <message>
        <source>stitches need horizontal layers</source>
        <translation>sting krever horisontale lag</translation>
    </message>
    <message>
        <source>set `stitchSpacing=0`, or give no `layerPlanes`</source>
        <translation>sett `stitchSpacing=0`, eller oppgi ingen `layerPlanes`</translation>
    </message>
    <message>
        <source>excess of a shot</source>
        <translation>overskudd i et skudd</translation>
    </message>
    <message>
        <source>Material of a shot beyond the volume of its pocket, as a share of that volume.</source>
        <translation>Materialet i et skudd utover lommens volum, som andel av det volumet.</translation>
    </message>
    <message>
        <source>nozzle depth of a shot</source>
        <translation>dysedybde i et skudd</translation>
    </message>
    <message>
        <source>Depth of the nozzle in the pocket; 0: it seals the opening.</source>
        <translation>Dysens dybde i lommen; 0: den tetter åpningen.</translation>
    </message>
    <message>
        <source>flow of a shot</source>
        <translation>materialstrøm i et skudd</translation>
    </message>
    <message>
        <source>Flow into a pocket, at most that of the process. 0: as much.</source>
        <translation>Materialstrøm inn i en lomme, høyst prosessens. 0: like mye.</translation>
    </message>
    <message>
        <source>wait after a shot</source>
        <translation>venting etter et skudd</translation>
    </message>
    <message>
        <source>Time that the nozzle stays in the pocket after the shot, so that the material does not come out again.</source>
        <translation>Tiden dysen blir i lommen etter skuddet, slik at materialet ikke kommer ut igjen.</translation>
    </message>
    <message>
        <source>a shot into a pocket</source>
        <translation>et skudd inn i en lomme</translation>
    </message>
    <message>
        <source>Trace on a surface</source>
        <translation>Spor på en overflate</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Spor</translation>
    </message>
    <message>
        <source>find the seam</source>
        <translation>finn sømmen</translation>
    </message>
    <message>
        <source>the part has no surface within {angle} of the vertical that is wide enough for a seam</source>
        <translation>delen har ingen overflate innenfor {angle} fra loddlinjen som er bred nok for en søm</translation>
    </message>
    <message>
        <source>turn the part, or increase `traceAngle`</source>
        <translation>roter delen, eller øk `traceAngle`</translation>
    </message>
    <message>
        <source>greatest angle of the traced surface</source>
        <translation>største vinkel på den sporede overflaten</translation>
    </message>
    <message>
        <source>Mode trace: the seam is the outline of the part&apos;s surface whose normal is within this angle of the vertical.</source>
        <translation>Modus trace: sømmen er omrisset av den delen av overflaten der normalen er innenfor denne vinkelen fra loddlinjen.</translation>
    </message>
    <message>
        <source>inset of the seam</source>
        <translation>innrykk av sømmen</translation>
    </message>
    <message>
        <source>Distance of the first bead from the outline, inwards, seen from above.</source>
        <translation>Avstanden fra omrisset og innover til den første strengen, sett ovenfra.</translation>
    </message>
    <message>
        <source>seams</source>
        <translation>sømmer</translation>
    </message>
    <message>
        <source>Number of beads from the outline inwards.</source>
        <translation>Antall strenger fra omrisset og innover.</translation>
    </message>
    <message>
        <source>side passes</source>
        <translation>sidepass</translation>
    </message>
    <message>
        <source>Number of beads on the side of the part, below the outline.</source>
        <translation>Antall strenger på siden av delen, under omrisset.</translation>
    </message>
    <message>
        <source>depth of side passes</source>
        <translation>dybde på sidepass</translation>
    </message>
    <message>
        <source>Height of the outline above the first side pass.</source>
        <translation>Omrissets høyde over det første sidepasset.</translation>
    </message>
    <message>
        <source>lines at heel and toe</source>
        <translation>linjer ved hæl og tå</translation>
    </message>
    <message>
        <source>Number of parallel beads that fill each of the two ends inside the innermost seam.</source>
        <translation>Antall parallelle strenger som fyller hver av de to endene innenfor den innerste sømmen.</translation>
    </message>
    <message>
        <source>angle of lines</source>
        <translation>linjevinkel</translation>
    </message>
    <message>
        <source>Angle of the lines at heel and toe to the x axis, seen from above.</source>
        <translation>Vinkelen mellom linjene ved hæl og tå og x-aksen, sett ovenfra.</translation>
    </message>
    <message>
        <source>dovetail</source>
        <translation>svalehale</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>kjegle</translation>
    </message>
    <message>
        <source>shape of stitches</source>
        <translation>stingform</translation>
    </message>
    <message>
        <source>Dovetail: chamber, cone and opening, three quarters of the diameter high. Cone: half of the diameter high.</source>
        <translation>Svalehale: kammer, kjegle og åpning, tre fjerdedeler av diameteren høy. Kjegle: halve diameteren høy.</translation>
    </message>
    <message>
        <source>Diameter of a pocket where it is widest. Its opening is half of it wide.</source>
        <translation>Diameteren på en lomme der den er bredest. Åpningen er halvparten så bred.</translation>
    </message>
    <message>
        <source>process {process} has no statements (beadWords) for format {format}, which its beads need</source>
        <translation>prosessen {process} har ingen setninger (beadWords) for formatet {format}, som strengene trenger</translation>
    </message>
    <message>
        <source>use {formats}, or add the statements to the process</source>
        <translation>bruk {formats}, eller legg setningene til prosessen</translation>
    </message>
    <message>
        <source>beadWords: &apos;{word}&apos; is not a word for a force</source>
        <translation>beadWords: &apos;{word}&apos; er ikke et ord for en kraft</translation>
    </message>
    <message>
        <source>write {pressFrame}, {pressSpace}, {press 5} or {pressAxis 20}</source>
        <translation>skriv {pressFrame}, {pressSpace}, {press 5} eller {pressAxis 20}</translation>
    </message>
    <message>
        <source>the nozzle of cell {cell} is along no axis of the arm&apos;s base, so that MELFA cannot press along it</source>
        <translation>dysen i cellen {cell} er ikke langs noen akse i armens base, så MELFA kan ikke presse langs den</translation>
    </message>
    <message>
        <source>use a cell whose nozzle is upright, or another format</source>
        <translation>bruk en celle med loddrett dyse, eller et annet format</translation>
    </message>
    <message>
        <source>find the skeleton</source>
        <translation>finn skjelettet</translation>
    </message>
    <message>
        <source>pith</source>
        <translation>kjerne</translation>
    </message>
    <message>
        <source>the part is not closed</source>
        <translation>delen er ikke lukket</translation>
    </message>
    <message>
        <source>the part has no limbs</source>
        <translation>delen har ingen grener</translation>
    </message>
    <message>
        <source>use infill that is dense along the part&apos;s middle (`sparsePattern=pith`)</source>
        <translation>bruk fyll som er tett langs delens midte (`sparsePattern=pith`)</translation>
    </message>
    <message>
        <source>the limbs of the pith cannot be joined</source>
        <translation>kjernens grener kan ikke føyes sammen</translation>
    </message>
    <message>
        <source>change the pith&apos;s share</source>
        <translation>endre kjernens andel</translation>
    </message>
    <message>
        <source>the pith cannot be cut at the part&apos;s surface</source>
        <translation>kjernen kan ikke kappes ved delens overflate</translation>
    </message>
    <message>
        <source>distance of seams</source>
        <translation>avstand mellom sømmer</translation>
    </message>
    <message>
        <source>Distance between beads, seen from above. 0: the bead&apos;s width.</source>
        <translation>Avstand mellom strenger, sett ovenfra. 0: strengens bredde.</translation>
    </message>
    <message>
        <source>radius of the outline&apos;s hull</source>
        <translation>radius for omrissets innhylling</translation>
    </message>
    <message>
        <source>Gaps of the outline through which no disc of this radius passes are closed.</source>
        <translation>Åpninger i omrisset som ingen skive med denne radien går gjennom, lukkes.</translation>
    </message>
    <message>
        <source>Hard plastic</source>
        <translation>Hard plast</translation>
    </message>
    <message>
        <source>Soft plastic</source>
        <translation>Myk plast</translation>
    </message>
    <message>
        <source>the cutter has no diameter or no teeth</source>
        <translation>fresen har ingen diameter eller ingen tenner</translation>
    </message>
    <message>
        <source>give --cutter and --teeth above 0</source>
        <translation>oppgi --cutter og --teeth over 0</translation>
    </message>
    <message>
        <source>a distance of passes is not positive</source>
        <translation>en passavstand er ikke positiv</translation>
    </message>
    <message>
        <source>give distances above 0</source>
        <translation>oppgi avstander over 0</translation>
    </message>
    <message>
        <source>the block is less than the cutter&apos;s {diameter} wider than the part</source>
        <translation>emnet er mindre enn fresens {diameter} bredere enn delen</translation>
    </message>
    <message>
        <source>increase --gap</source>
        <translation>øk --gap</translation>
    </message>
    <message>
        <source>unknown word {word}</source>
        <translation>ukjent ord {word}</translation>
    </message>
    <message>
        <source>a motion before {word}</source>
        <translation>en bevegelse før {word}</translation>
    </message>
    <message>
        <source>G53 with another position than Z0 is not understood</source>
        <translation>G53 med en annen posisjon enn Z0 støttes ikke</translation>
    </message>
    <message>
        <source>the block turns while the cutter is not home</source>
        <translation>emnet dreies mens fresen ikke er i hjemposisjon</translation>
    </message>
    <message>
        <source>the block is turned by neither 0 nor 180 degrees</source>
        <translation>emnet er verken dreid 0 eller 180 grader</translation>
    </message>
    <message>
        <source>coordinates of another side</source>
        <translation>koordinater for en annen side</translation>
    </message>
    <message>
        <source>a rapid move through the block</source>
        <translation>en ilgangsbevegelse gjennom emnet</translation>
    </message>
    <message>
        <source>the spindle has another speed than planned</source>
        <translation>spindelen har en annen hastighet enn planlagt</translation>
    </message>
    <message>
        <source>another feed than planned</source>
        <translation>en annen mating enn planlagt</translation>
    </message>
    <message>
        <source>{volume:.0f} of the block stay in slots, undercuts or holes that should be free, up to {height:.1f} high</source>
        <translation>{volume:.0f} av emnet blir igjen i spor, underskjæringer eller hull som skulle være frie, opptil {height:.1f} høyt</translation>
    </message>
    <message>
        <source>only you know which cutter and block you have: change the values of the passes</source>
        <translation>bare du vet hvilken fres og hvilket emne du har: endre verdiene for passene</translation>
    </message>
    <message>
        <source>the cutter takes up to {depth:.3f} from the part</source>
        <translation>fresen tar opptil {depth:.3f} av delen</translation>
    </message>
    <message>
        <source>the way home</source>
        <translation>veien hjem</translation>
    </message>
    <message>
        <source>&apos;{place}&apos; is no place</source>
        <translation>&apos;{place}&apos; er ikke en plassering</translation>
    </message>
    <message>
        <source>give X,Y,Z in mm and a rotation about z in degrees, as in 900,0,0,180</source>
        <translation>oppgi X,Y,Z i mm og en rotasjon om z i grader, som i 900,0,0,180</translation>
    </message>
    <message>
        <source>the job has no motion</source>
        <translation>jobben har ingen bevegelse</translation>
    </message>
    <message>
        <source>looking for an order of work</source>
        <translation>søker en arbeidsrekkefølge</translation>
    </message>
    <message>
        <source>{count} jobs: two to {most} machines can work together</source>
        <translation>{count} jobber: to til {most} maskiner kan arbeide sammen</translation>
    </message>
    <message>
        <source>machine {machine} waits in line {line} for a mark that the other does not reach</source>
        <translation>maskin {machine} venter på linje {line} på et merke som den andre ikke når</translation>
    </message>
    <message>
        <source>machine {machine} passes the mark in line {line} before machine {other} has reached it, if signals are still on or the programs are not started at once</source>
        <translation>maskin {machine} passerer merket på linje {line} før maskin {other} har nådd det, hvis signaler fortsatt er på eller programmene ikke startes samtidig</translation>
    </message>
    <message>
        <source>machine {machine}: {reason}</source>
        <translation>maskin {machine}: {reason}</translation>
    </message>
    <message>
        <source>name a folder that &apos;together&apos; wrote</source>
        <translation>oppgi en mappe som &apos;together&apos; har skrevet</translation>
    </message>
    <message>
        <source>comparing the motions of the machines</source>
        <translation>sammenligner maskinenes bevegelser</translation>
    </message>
    <message>
        <source>running all programs in one time</source>
        <translation>kjører alle programmer i felles tid</translation>
    </message>
    <message>
        <source>a mark for the other machine</source>
        <translation>et merke for den andre maskinen</translation>
    </message>
    <message>
        <source>an input is read while motions are queued</source>
        <translation>en inngang leses mens bevegelser ligger i kø</translation>
    </message>
    <message>
        <source>dense at the pith</source>
        <translation>tett ved kjernen</translation>
    </message>
    <message>
        <source>mean step height</source>
        <translation>gjennomsnittlig trinnhøyde</translation>
    </message>
    <message>
        <source>Mean step
mm</source>
        <translation>Snitt-
trinn mm</translation>
    </message>
    <message>
        <source>greatest step height</source>
        <translation>største trinnhøyde</translation>
    </message>
    <message>
        <source>Greatest
step mm</source>
        <translation>Største
trinn mm</translation>
    </message>
    <message>
        <source>angle between beads and load</source>
        <translation>vinkel mellom strenger og last</translation>
    </message>
    <message>
        <source>Bead
angle °</source>
        <translation>Streng-
vinkel °</translation>
    </message>
    <message>
        <source>interfaces across the load</source>
        <translation>grenseflater på tvers av lasten</translation>
    </message>
    <message>
        <source>Inter-
faces %</source>
        <translation>Grense-
flater %</translation>
    </message>
    <message>
        <source>interfaces in the weakest section</source>
        <translation>grenseflater i det svakeste tverrsnittet</translation>
    </message>
    <message>
        <source>Weakest
% interf.</source>
        <translation>Svakeste
% grensefl.</translation>
    </message>
    <message>
        <source>is below {least}</source>
        <translation>er under {least}</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Mål</translation>
    </message>
    <message>
        <source>size factor along x</source>
        <translation>målfaktor langs x</translation>
    </message>
    <message>
        <source>Flat layers are made larger by it, so that printed lengths are right. 1: none.</source>
        <translation>Flate lag gjøres større med den, så printede lengder blir riktige. 1: ingen.</translation>
    </message>
    <message>
        <source>size factor along y</source>
        <translation>målfaktor langs y</translation>
    </message>
    <message>
        <source>As along x.</source>
        <translation>Som langs x.</translation>
    </message>
    <message>
        <source>outline offset</source>
        <translation>omrissforskyvning</translation>
    </message>
    <message>
        <source>Outlines of flat layers move outwards by it.</source>
        <translation>Omriss i flate lag flyttes så mye utover.</translation>
    </message>
    <message>
        <source>hole offset</source>
        <translation>hullforskyvning</translation>
    </message>
    <message>
        <source>Contours of holes in flat layers move into the material by it.</source>
        <translation>Hullkonturer i flate lag flyttes så mye inn i materialet.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Styrke</translation>
    </message>
    <message>
        <source>direction of the load</source>
        <translation>lastretning</translation>
    </message>
    <message>
        <source>the job has no motion to compare with</source>
        <translation>jobben har ingen bevegelse å sammenligne med</translation>
    </message>
    <message>
        <source>give rows such as: length x 50 49.8; slot y 5 4.8; hole 10 9.6</source>
        <translation>oppgi rader som: length x 50 49.8; slot y 5 4.8; hole 10 9.6</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a size</source>
        <translation>&apos;{word}&apos; er ikke et mål</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a kind of size</source>
        <translation>&apos;{word}&apos; er ikke en måltype</translation>
    </message>
    <message>
        <source>not a kind, an axis and two sizes</source>
        <translation>ikke en type, en akse og to mål</translation>
    </message>
    <message>
        <source>{measured} is too far from {nominal}</source>
        <translation>{measured} er for langt fra {nominal}</translation>
    </message>
    <message>
        <source>{key} would be {value}, beyond {least} to {most}</source>
        <translation>{key} ville bli {value}, utenfor {least} til {most}</translation>
    </message>
    <message>
        <source>check the measured sizes</source>
        <translation>kontroller de målte verdiene</translation>
    </message>
    <message>
        <source>no measured sizes</source>
        <translation>ingen målte verdier</translation>
    </message>
    <message>
        <source>aligning</source>
        <translation>innretting</translation>
    </message>
    <message>
        <source>path</source>
        <translation>bane</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>hastighet</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>materialstrøm</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>mangler</translation>
    </message>
    <message>
        <source>the record does not come near the planned path</source>
        <translation>registreringen kommer ikke i nærheten av den planlagte banen</translation>
    </message>
    <message>
        <source>choose the project and the cell that it was recorded with</source>
        <translation>velg prosjektet og cellen den ble registrert med</translation>
    </message>
    <message>
        <source>{found} joints are recorded, the cell has {wanted} axes</source>
        <translation>{found} ledd er registrert, cellen har {wanted} akser</translation>
    </message>
    <message>
        <source>record all axes, external ones included</source>
        <translation>registrer alle akser, også de eksterne</translation>
    </message>
    <message>
        <source>poses of the TCP do not contain the external axes</source>
        <translation>TCP-positurer inneholder ikke de eksterne aksene</translation>
    </message>
    <message>
        <source>record the joints of all axes</source>
        <translation>registrer leddene for alle akser</translation>
    </message>
    <message>
        <source>the pose of the TCP is incomplete</source>
        <translation>TCP-posituren er ufullstendig</translation>
    </message>
    <message>
        <source>record actual_q or all of actual_TCP_pose</source>
        <translation>registrer actual_q eller hele actual_TCP_pose</translation>
    </message>
    <message>
        <source>column &apos;{name}&apos; is missing</source>
        <translation>kolonnen &apos;{name}&apos; mangler</translation>
    </message>
    <message>
        <source>record X, Y, Z, A, B and C, or all joints</source>
        <translation>registrer X, Y, Z, A, B og C, eller alle ledd</translation>
    </message>
    <message>
        <source>RTDE of Universal Robots</source>
        <translation>RTDE fra Universal Robots</translation>
    </message>
    <message>
        <source>monitor of MELFA</source>
        <translation>MELFA-monitor</translation>
    </message>
    <message>
        <source>table of joints</source>
        <translation>leddtabell</translation>
    </message>
    <message>
        <source>no joints and no pose of the TCP among the columns</source>
        <translation>ingen ledd og ingen TCP-positur blant kolonnene</translation>
    </message>
    <message>
        <source>record actual_q (RTDE), X to C (MELFA) or j1_deg, j2_deg ...</source>
        <translation>registrer actual_q (RTDE), X til C (MELFA) eller j1_deg, j2_deg ...</translation>
    </message>
    <message>
        <source>no column of times</source>
        <translation>ingen tidskolonne</translation>
    </message>
    <message>
        <source>name it timestamp, time_s or time_ms</source>
        <translation>kall den timestamp, time_s eller time_ms</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>færre enn to prøver</translation>
    </message>
    <message>
        <source>record the whole run</source>
        <translation>registrer hele kjøringen</translation>
    </message>
    <message>
        <source>no number in column &apos;{column}&apos;</source>
        <translation>ikke et tall i kolonnen &apos;{column}&apos;</translation>
    </message>
    <message>
        <source>{found} values in a row instead of {wanted}, as there are names</source>
        <translation>{found} verdier i en rad i stedet for {wanted}, som det er navn</translation>
    </message>
    <message>
        <source>no rows of numbers below a row of names</source>
        <translation>ingen rader med tall under en rad med navn</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a direction</source>
        <translation>&apos;{text}&apos; er ikke en retning</translation>
    </message>
    <message>
        <source>give x,y,z, for example 1,0,0</source>
        <translation>oppgi x,y,z, for eksempel 1,0,0</translation>
    </message>
    <message>
        <source>the job waits for another machine at marks</source>
        <translation>jobben venter på en annen maskin ved merker</translation>
    </message>
    <message>
        <source>resume the job from which it was made, and print its rest alone</source>
        <translation>gjenoppta jobben den ble laget fra, og print resten av den alene</translation>
    </message>
    <message>
        <source>milling passes</source>
        <translation>frespass</translation>
    </message>
    <message>
        <source>milling the block</source>
        <translation>freser emnet</translation>
    </message>
    <message>
        <source>another motion than planned</source>
        <translation>en annen bevegelse enn planlagt</translation>
    </message>
    <message>
        <source>laying the part down</source>
        <translation>legger delen ned</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volum</translation>
    </message>
    <message>
        <source>negative volume</source>
        <translation>negativt volum</translation>
    </message>
    <message>
        <source>modifier volume</source>
        <translation>modifikatorvolum</translation>
    </message>
    <message>
        <source>support enforcer</source>
        <translation>støttefremmer</translation>
    </message>
    <message>
        <source>support blocker</source>
        <translation>støtteblokkering</translation>
    </message>
    <message>
        <source>not used: extruder {number} of &apos;{object}&apos; ({where}): choose the tool of the part</source>
        <translation>ikke brukt: ekstruder {number} for &apos;{object}&apos; ({where}): velg verktøyet til delen</translation>
    </message>
    <message>
        <source>not used: settings of &apos;{object}&apos; ({where}): {keys}</source>
        <translation>ikke brukt: innstillinger for &apos;{object}&apos; ({where}): {keys}</translation>
    </message>
    <message>
        <source>not used: the slice stack of object &apos;{id}&apos; ({where}): its mesh is printed</source>
        <translation>ikke brukt: skivestabelen til objektet &apos;{id}&apos; ({where}): meshen printes</translation>
    </message>
    <message>
        <source>cut away: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>kuttet bort: {kind} &apos;{name}&apos; i &apos;{object}&apos;, med midten ved {place} i filen</translation>
    </message>
    <message>
        <source>not used: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>ikke brukt: {kind} &apos;{name}&apos; i &apos;{object}&apos;, med midten ved {place} i filen</translation>
    </message>
    <message>
        <source>read although its namespace is &apos;{space}&apos; and not that of 3MF ({where})</source>
        <translation>lest selv om navnerommet er &apos;{space}&apos; og ikke det til 3MF ({where})</translation>
    </message>
    <message>
        <source>not used: materials and colours of objects and triangles, more than one from line {line} of {where}</source>
        <translation>ikke brukt: materialer og farger på objekter og trekanter, mer enn én fra linje {line} i {where}</translation>
    </message>
    <message>
        <source>M200 changes the meaning of E between beads</source>
        <translation>M200 endrer betydningen av E mellom strenger</translation>
    </message>
    <message>
        <source>export the whole file with lengths of filament, or with volumes</source>
        <translation>eksporter hele filen med filamentlengder, eller med volumer</translation>
    </message>
    <message>
        <source>purge lines beside the part are left out: {volume:.0f} from line {line} on</source>
        <translation>spylelinjer ved siden av delen utelates: {volume:.0f} fra linje {line}</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as the setting use_volumetric_e of the file says</source>
        <translation>mengder tolkes som volumer, slik filens innstilling use_volumetric_e sier</translation>
    </message>
    <message>
        <source>the negative volume &apos;{negative}&apos; cannot be cut out of &apos;{part}&apos;: their meshes are not closed or intersect themselves</source>
        <translation>det negative volumet &apos;{negative}&apos; kan ikke skjæres ut av &apos;{part}&apos;: meshene er ikke lukket eller skjærer seg selv</translation>
    </message>
    <message>
        <source>repair them in the slicer, or export the part as STL</source>
        <translation>reparer dem i sliceren, eller eksporter delen som STL</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} elements {name}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>ikke brukt: {count} element {name}, på linje {line} i {where}</numerusform>
            <numerusform>ikke brukt: {count} elementer {name}, det første på linje {line} i {where}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: attribute {name} of {count} elements {element}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>ikke brukt: attributtet {name} i {count} element {element}, på linje {line} i {where}</numerusform>
            <numerusform>ikke brukt: attributtet {name} i {count} elementer {element}, det første på linje {line} i {where}</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: metadata &apos;{name}&apos; ({where})</source>
        <translation>ikke brukt: metadata &apos;{name}&apos; ({where})</translation>
    </message>
    <message>
        <source>not used: the division into {plates} plates ({where}): the parts of all are read</source>
        <translation>ikke brukt: inndelingen i {plates} byggeplater ({where}): delene på alle leses</translation>
    </message>
    <message>
        <source>not used: settings of plates ({where}): {keys}</source>
        <translation>ikke brukt: innstillinger for byggeplater ({where}): {keys}</translation>
    </message>
    <message>
        <source>printed like the part: a volume of the unknown kind &apos;{kind}&apos; ({where})</source>
        <translation>printet som delen: et volum av den ukjente typen &apos;{kind}&apos; ({where})</translation>
    </message>
    <message>
        <source>the slicer&apos;s settings</source>
        <translation>slicerens innstillinger</translation>
    </message>
    <message>
        <source>variable layer heights</source>
        <translation>variable laghøyder</translation>
    </message>
    <message>
        <source>settings of ranges of height</source>
        <translation>innstillinger for høydeområder</translation>
    </message>
    <message>
        <source>stops, tools and G-code at given heights</source>
        <translation>stopp, verktøy og G-kode ved gitte høyder</translation>
    </message>
    <message>
        <source>points of support</source>
        <translation>støttepunkter</translation>
    </message>
    <message>
        <source>drain holes</source>
        <translation>dreneringshull</translation>
    </message>
    <message>
        <source>ears of the brim</source>
        <translation>bremører</translation>
    </message>
    <message>
        <source>not used: {what} (&apos;{member}&apos;)</source>
        <translation>ikke brukt: {what} (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: {count} further members of the package</source>
        <translation>ikke brukt: {count} andre filer i pakken</translation>
    </message>
    <message>
        <source>not used: &apos;{member}&apos; in the package</source>
        <translation>ikke brukt: &apos;{member}&apos; i pakken</translation>
    </message>
    <message>
        <source>not used, as they are damaged: kinds and settings of objects ({where}): modifiers and negative volumes may be printed as parts: {why}</source>
        <translation>ikke brukt, fordi de er skadet: typer og innstillinger for objekter ({where}): modifikatorer og negative volumer kan bli printet som deler: {why}</translation>
    </message>
    <message>
        <source>does not have three numbers</source>
        <translation>har ikke tre tall</translation>
    </message>
    <message>
        <source>refers to a missing vertex</source>
        <translation>viser til et hjørnepunkt som mangler</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>har ingen trekanter</translation>
    </message>
    <message>
        <source>is another version</source>
        <translation>er en annen versjon</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>er ukjent</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}, estimated); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): overheng etter kutting {left:.0f} (stykker: {pieces}) i stedet for {leftBefore:.0f#} (stykker: {piecesBefore}, anslått); ukuttet {overhang:.0f} i stedet for {overhangBefore:.0f#}</translation>
    </message>
    <message numerus="yes">
        <source>{shots} shots into pockets last up to {seconds:.1f}: after {most:.0f} in a pocket the nozzle melts the layers around it</source>
        <translation>
            <numerusform>{shots} skudd inn i en lomme varer opptil {seconds:.1f}: etter {most:.0f} i en lomme smelter dysen lagene rundt</numerusform>
            <numerusform>{shots} skudd inn i lommer varer opptil {seconds:.1f}: etter {most:.0f} i en lomme smelter dysen lagene rundt</numerusform>
        </translation>
    </message>
    <message>
        <source>use a process with a greater flow, or smaller pockets (`stitchDiameter`)</source>
        <translation>bruk en prosess med større materialstrøm, eller mindre lommer (`stitchDiameter`)</translation>
    </message>
    <message>
        <source>support in closed hollows of the part cannot be removed: {volume:.3g}</source>
        <translation>støtte i lukkede hulrom i delen kan ikke fjernes: {volume:.3g}</translation>
    </message>
    <message>
        <source>too many intersecting triangles to unite them ({pairs} pairs, at most {most}): shells stay as they are, overlaps count as one solid when layers are made</source>
        <translation>for mange trekanter som skjærer hverandre til å forene dem ({pairs} par, høyst {most}): skallene forblir som de er, overlapp regnes som ett legeme når lag lages</translation>
    </message>
    <message>
        <source>change parameters, process or cell of the plan, or leave this format out</source>
        <translation>endre planens parametere, prosess eller celle, eller utelat dette formatet</translation>
    </message>
    <message>
        <source>choose another program format</source>
        <translation>velg et annet programformat</translation>
    </message>
    <message>
        <source>the tool-paths are those of the file: change them where they were made</source>
        <translation>verktøybanene er filens: endre dem der de ble laget</translation>
    </message>
    <message>
        <source>slice the part again with supports there, or with denser infill; its tool-paths are printed as they are</source>
        <translation>slice delen på nytt med støtter der, eller med tettere fyll; verktøybanene printes som de er</translation>
    </message>
    <message>
        <source>check the widths and layer heights in the slicer against the bead of the process; the tool-paths are printed as they are</source>
        <translation>kontroller bredder og laghøyder i sliceren mot prosessens streng; verktøybanene printes som de er</translation>
    </message>
    <message>
        <source>check the flow in the slicer, and purge or prime lines that it does not mark; the tool-paths are printed as they are</source>
        <translation>kontroller materialstrømmen i sliceren, og spyle- eller primelinjer som den ikke merker; verktøybanene printes som de er</translation>
    </message>
    <message>
        <source>check the slicer&apos;s flow, its filament diameter and its amounts at tool changes; the tool-paths are printed as they are</source>
        <translation>kontroller slicerens materialstrøm, filamentdiameter og mengder ved verktøybytter; verktøybanene printes som de er</translation>
    </message>
    <message>
        <source>no {format} program: {why}</source>
        <translation>ikke noe {format}-program: {why}</translation>
    </message>
    <message>
        <source>the {format} program lays beads by position, without the force of process {process}</source>
        <translation>{format}-programmet legger strenger etter posisjon, uten kraften i prosessen {process}</translation>
    </message>
    <message>
        <source>to press with the force, use {formats}, or add the statements to the process (beadWords)</source>
        <translation>for å presse med kraften, bruk {formats}, eller legg setningene til prosessen (beadWords)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {command} in {count} lines, the first is line {line}</source>
        <translation>
            <numerusform>ikke brukt: {command} på {count} linje, linje {line}</numerusform>
            <numerusform>ikke brukt: {command} på {count} linjer, den første er linje {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>{cell}: best of the planned rows (row {row})</source>
        <translation>{cell}: den beste av de planlagte radene (rad {row})</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} statements &apos;{word}&apos;, the first in line {line}</source>
        <translation>
            <numerusform>ikke brukt: {count} setning &apos;{word}&apos;, på linje {line}</numerusform>
            <numerusform>ikke brukt: {count} setninger &apos;{word}&apos;, den første på linje {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not followed by a joint motion: it changes the speed of a later travel</source>
        <translation>&apos;{word}&apos; følges ikke av en leddbevegelse: det endrer hastigheten på en senere tomkjøring</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out already</source>
        <translation>tapekutteren er allerede ute</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not out</source>
        <translation>tapekutteren er ikke ute</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out for {time:.2f}: it needs {least:.1f} to {most:.1f}</source>
        <translation>tapekutteren er ute i {time:.2f}: den trenger {least:.1f} til {most:.1f}</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not drawn back</source>
        <translation>tapekutteren trekkes ikke tilbake</translation>
    </message>
    <message>
        <source>outside the function of a part: &apos;{code}&apos;</source>
        <translation>utenfor funksjonen til en del: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>the cutter&apos;s output needs S255 or S0</source>
        <translation>kutterens utgang krever S255 eller S0</translation>
    </message>
    <message>
        <source>the cutter&apos;s output runs ahead of the motions: M400 is missing before it</source>
        <translation>kutterens utgang løper foran bevegelsene: M400 mangler før den</translation>
    </message>
    <message>
        <source>the first module declares &apos;{procedure}&apos;, too</source>
        <translation>den første modulen deklarerer også &apos;{procedure}&apos;</translation>
    </message>
    <message>
        <source>frame {id} follows frame {before}: frames are missing or in another order</source>
        <translation>ramme {id} følger ramme {before}: rammer mangler eller står i en annen rekkefølge</translation>
    </message>
    <message>
        <source>the velocity at this point leads off the path</source>
        <translation>hastigheten i dette punktet fører bort fra banen</translation>
    </message>
    <message>
        <source>the motors&apos; power for the first motion</source>
        <translation>motorenes effekt for den første bevegelsen</translation>
    </message>
    <message>
        <source>full</source>
        <translation>full</translation>
    </message>
    <message>
        <source>low</source>
        <translation>lav</translation>
    </message>
    <message>
        <source>no place differs from the plan by more than the tolerances</source>
        <translation>ingen steder avviker fra planen mer enn toleransene</translation>
    </message>
    <message numerus="yes">
        <source>{count} places are beyond the tolerances</source>
        <translation>
            <numerusform>{count} sted er utenfor toleransene</numerusform>
            <numerusform>{count} steder er utenfor toleransene</numerusform>
        </translation>
    </message>
    <message>
        <source>only {recorded:.1f} of {planned:.1f} of beads are recorded</source>
        <translation>bare {recorded:.1f} av {planned:.1f} streng er registrert</translation>
    </message>
    <message>
        <source>this is no record of this job: {recorded:.1f} of {planned:.1f} of beads agree</source>
        <translation>dette er ikke en registrering av denne jobben: {recorded:.1f} av {planned:.1f} streng stemmer overens</translation>
    </message>
    <message>
        <source>Plan: {finding}.</source>
        <translation>Plan: {finding}.</translation>
    </message>
    <message numerus="yes">
        <source>Plan: {count} more blocking findings.</source>
        <translation>
            <numerusform>Plan: ett blokkerende funn til.</numerusform>
            <numerusform>Plan: {count} blokkerende funn til.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not approved: the plan has blocking findings.</source>
        <translation>Ikke godkjent: planen har blokkerende funn.</translation>
    </message>
    <message>
        <source>exists, perhaps with measured frames and obstacles</source>
        <translation>finnes allerede, kanskje med målte koordinatsystemer og hindringer</translation>
    </message>
    <message>
        <source>give another name, --id, or replace it: --replace</source>
        <translation>oppgi et annet navn, --id, eller erstatt den: --replace</translation>
    </message>
    <message>
        <source>a share that is not positive</source>
        <translation>en andel som ikke er positiv</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as UltiGCode states them</source>
        <translation>mengder tolkes som volumer, slik UltiGCode angir dem</translation>
    </message>
    <message>
        <source>give S in percent</source>
        <translation>oppgi S i prosent</translation>
    </message>
    <message>
        <source>two commands in one line: &apos;{code}&apos; and &apos;{next}&apos;</source>
        <translation>to kommandoer på én linje: &apos;{code}&apos; og &apos;{next}&apos;</translation>
    </message>
    <message>
        <source>write each command in a line of its own</source>
        <translation>skriv hver kommando på egen linje</translation>
    </message>
    <message>
        <source>a second object of the id &apos;{id}&apos;</source>
        <translation>et andre objekt med id-en &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>cells of {pitch} are too fine for a block of {along} by {across}</source>
        <translation>celler på {pitch} er for fine for et emne på {along} ganger {across}</translation>
    </message>
    <message>
        <source>give --pitch of {least} or more</source>
        <translation>oppgi --pitch på {least} eller mer</translation>
    </message>
    <message>
        <source>must be within a kilometre</source>
        <translation>må være innenfor en kilometer</translation>
    </message>
    <message>
        <source>not used: {bytes} bytes behind the {facets} facets that the header states</source>
        <translation>ikke brukt: {bytes} byte etter de {facets} fasettene filhodet angir</translation>
    </message>
    <message>
        <source>under G93 a way from an unknown place has no speed</source>
        <translation>under G93 har en vei fra et ukjent sted ingen hastighet</translation>
    </message>
    <message>
        <source>the table turns while the nozzle goes to its start</source>
        <translation>bordet dreier mens dysen går til starten</translation>
    </message>
    <message>
        <source>the nozzle is not above its start: its way has no speed</source>
        <translation>dysen er ikke over starten sin: veien har ingen hastighet</translation>
    </message>
    <message>
        <source>the nozzle&apos;s height beside the print</source>
        <translation>dysens høyde ved siden av printen</translation>
    </message>
    <message>
        <source>at least {height:.1f}</source>
        <translation>minst {height:.1f}</translation>
    </message>
    <message>
        <source>the heat of {tool}</source>
        <translation>oppvarmingen av {tool}</translation>
    </message>
    <message>
        <source>the payload</source>
        <translation>nyttelasten</translation>
    </message>
    <message>
        <source>the payload is not set</source>
        <translation>nyttelasten er ikke satt</translation>
    </message>
    <message>
        <source>the payload&apos;s centre, mm</source>
        <translation>nyttelastens tyngdepunkt, mm</translation>
    </message>
    <message>
        <source>a payload&apos;s centre is no sensible place</source>
        <translation>et nyttelasttyngdepunkt er ikke et fornuftig sted</translation>
    </message>
    <message>
        <source>this text does not go to the extruder as those before it</source>
        <translation>denne teksten går ikke til ekstruderen slik de før den gjør</translation>
    </message>
    <message>
        <source>the head is {tip:.3g} wide at its tip and {end:.3g} at its other end: its nozzle seems to point away from the part</source>
        <translation>hodet er {tip:.3g} bredt ved spissen og {end:.3g} i den andre enden: dysen ser ut til å peke bort fra delen</translation>
    </message>
    <message>
        <source>turn the head of process {process} over</source>
        <translation>snu hodet i prosessen {process}</translation>
    </message>
    <message>
        <source>the plates of machine {one} ({cell}) and machine {two} ({other}) overlap by {depth:.1f} ({area:.0f})</source>
        <translation>byggeplatene til maskin {one} ({cell}) og maskin {two} ({other}) overlapper med {depth:.1f} ({area:.0f})</translation>
    </message>
    <message>
        <source>{volume:.1f} extruded at rest are left out, from line {line} on</source>
        <translation>{volume:.1f} ekstrudert i ro utelates, fra linje {line}</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded by the printer&apos;s own code are left out, from line {line} on</source>
        <translation>{volume:.0f} ekstrudert av printerens egen kode utelates, fra linje {line}</translation>
    </message>
    <message>
        <source>the file states the filament diameter &apos;{text}&apos;: {diameter} assumed for values that cannot be used; for another one set `pathsFlow`</source>
        <translation>filen angir filamentdiameteren &apos;{text}&apos;: {diameter} antas for verdier som ikke kan brukes; for en annen, sett `pathsFlow`</translation>
    </message>
    <message>
        <source>the program ends here, beads that follow in line {line} would not be printed</source>
        <translation>programmet slutter her, strenger som følger på linje {line} ville ikke bli printet</translation>
    </message>
    <message>
        <source>remove the end (M2, M30, M112), or everything that follows it</source>
        <translation>fjern slutten (M2, M30, M112), eller alt som følger etter den</translation>
    </message>
    <message numerus="yes">
        <source>{count} settings have no effect on the tool-paths of a file: {keys}</source>
        <translation>
            <numerusform>{count} innstilling har ingen virkning på verktøybanene i en fil: {keys}</numerusform>
            <numerusform>{count} innstillinger har ingen virkning på verktøybanene i en fil: {keys}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the job has {count} tools: its first tool prints the file&apos;s beads of {tools}</source>
        <translation>
            <numerusform>jobben har {count} verktøy: det første verktøyet printer filens strenger for {tools}</numerusform>
            <numerusform>jobben har {count} verktøy: det første verktøyet printer filens strenger for {tools}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} entries of the element &apos;{name}&apos;</source>
        <translation>
            <numerusform>ikke brukt: {count} forekomst av elementet &apos;{name}&apos;</numerusform>
            <numerusform>ikke brukt: {count} forekomster av elementet &apos;{name}&apos;</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>divided into triangles: {count} facets of more than three vertices, the first in line {line}</source>
        <translation>
            <numerusform>delt i trekanter: {count} fasett med mer enn tre hjørnepunkter, på linje {line}</numerusform>
            <numerusform>delt i trekanter: {count} fasetter med mer enn tre hjørnepunkter, den første på linje {line}</numerusform>
        </translation>
    </message>
    <message>
        <source>two joints are named &apos;{joint}&apos;</source>
        <translation>to ledd heter &apos;{joint}&apos;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the limits of its safety controller leave no room</source>
        <translation>leddet &apos;{joint}&apos;: grensene fra sikkerhetsstyringen gir ikke plass</translation>
    </message>
    <message>
        <source>the time runs backwards, from {before:.3f} to {after:.3f} after the first row</source>
        <translation>tiden går bakover, fra {before:.3f} til {after:.3f} etter første rad</translation>
    </message>
    <message>
        <source>record one run in one file</source>
        <translation>registrer én kjøring i én fil</translation>
    </message>
    <message>
        <source>not used: the material or colour of objects and triangles, from line {line} of {where}</source>
        <translation>ikke brukt: materialet eller fargen på objekter og trekanter, fra linje {line} i {where}</translation>
    </message>
    <message>
        <source>not used: the recommended extension &apos;{name}&apos; ({where})</source>
        <translation>ikke brukt: den anbefalte utvidelsen &apos;{name}&apos; ({where})</translation>
    </message>
    <message>
        <source>not used: the unit {unit} of {where}: its lengths are taken in {main}, the unit of the main model</source>
        <translation>ikke brukt: enheten {unit} i {where}: lengdene tolkes i {main}, hovedmodellens enhet</translation>
    </message>
    <message>
        <source>not used: the layer &apos;{path}&apos;, which is not in the list of layers</source>
        <translation>ikke brukt: laget &apos;{path}&apos;, som ikke er i listen over lag</translation>
    </message>
    <message>
        <source>the name of the folder is empty</source>
        <translation>mappenavnet er tomt</translation>
    </message>
    <message>
        <source>name a folder for the results</source>
        <translation>oppgi en mappe for resultatene</translation>
    </message>
    <message>
        <source>beads of {least} to {most} do not fit a nozzle of {nozzle}</source>
        <translation>strenger på {least} til {most} passer ikke til en dyse på {nozzle}</translation>
    </message>
    <message>
        <source>check nozzleDiameterMm and beadWidthMm</source>
        <translation>kontroller nozzleDiameterMm og beadWidthMm</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no pair x,radius</source>
        <translation>&apos;{text}&apos; er ikke et par x,radius</translation>
    </message>
    <message>
        <source>contains no points</source>
        <translation>inneholder ingen punkter</translation>
    </message>
    <message>
        <source>give numbers in mm, separated by commas: x,y,z</source>
        <translation>oppgi tall i mm, atskilt med komma: x,y,z</translation>
    </message>
    <message>
        <source>is no result of this kind of job, and would be replaced</source>
        <translation>er ikke et resultat av denne typen jobb, og ville bli erstattet</translation>
    </message>
    <message>
        <source>choose another folder, or give --replace</source>
        <translation>velg en annen mappe, eller oppgi --replace</translation>
    </message>
    <message>
        <source>give it for the job: --set {key}=...</source>
        <translation>oppgi det for jobben: --set {key}=...</translation>
    </message>
    <message>
        <source>one mesh</source>
        <translation>én mesh</translation>
    </message>
    <message>
        <source>one mesh; read by a program of its own</source>
        <translation>én mesh; leses av et eget program</translation>
    </message>
    <message>
        <source>several parts, or tool-paths (build files)</source>
        <translation>flere deler, eller verktøybaner (build-filer)</translation>
    </message>
    <message>
        <source>solid cells, drawn as text</source>
        <translation>massive celler, tegnet som tekst</translation>
    </message>
    <message>
        <source>tool-paths of a slicer</source>
        <translation>verktøybaner fra en slicer</translation>
    </message>
    <message>
        <source>{key} is a setting of the job, not of a part</source>
        <translation>{key} er en innstilling for jobben, ikke for en del</translation>
    </message>
    <message>
        <source>use one of these formats: {formats}</source>
        <translation>bruk et av disse formatene: {formats}</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not a part</source>
        <translation>prosjektet til en stasjon med flere maskiner, ikke en del</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, &apos;verify&apos; or &apos;resume&apos;; a part is a file of its own</source>
        <translation>gi det til &apos;together&apos;, &apos;verify&apos; eller &apos;resume&apos;; en del er en egen fil</translation>
    </message>
    <message>
        <source>a project, not a part</source>
        <translation>et prosjekt, ikke en del</translation>
    </message>
    <message>
        <source>give it to &apos;resume&apos;, &apos;verify&apos; or &apos;together&apos;; a part is a file of its own</source>
        <translation>gi det til &apos;resume&apos;, &apos;verify&apos; eller &apos;together&apos;; en del er en egen fil</translation>
    </message>
    <message>
        <source>not the file of a part</source>
        <translation>ikke filen til en del</translation>
    </message>
    <message>
        <source>the file ends within line {line}, without a line end: it may be cut there, and the part unfinished; export it again</source>
        <translation>filen slutter inne i linje {line}, uten linjeslutt: den kan være kappet der og delen uferdig; eksporter den på nytt</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is more than a kilometre away</source>
        <translation>&apos;{text}&apos; er mer enn en kilometer unna</translation>
    </message>
    <message>
        <source>give places in mm</source>
        <translation>oppgi steder i mm</translation>
    </message>
    <message>
        <source>there is no curve for tapes</source>
        <translation>det finnes ingen kurve for tape</translation>
    </message>
    <message>
        <source>this text goes nowhere: the connection &apos;{name}&apos; is not open</source>
        <translation>denne teksten går ingen steder: forbindelsen &apos;{name}&apos; er ikke åpen</translation>
    </message>
    <message>
        <source>a connection needs an address and a port</source>
        <translation>en forbindelse krever en adresse og en port</translation>
    </message>
    <message>
        <source>this file moves the arm before it states the payload</source>
        <translation>denne filen beveger armen før den angir nyttelasten</translation>
    </message>
    <message>
        <source>this file sets the flow before it states the range of the output</source>
        <translation>denne filen setter materialstrømmen før den angir utgangens område</translation>
    </message>
    <message>
        <source>G28 with a number goes to a place first: give letters alone, or none</source>
        <translation>G28 med et tall går til et sted først: oppgi bare bokstaver, eller ingen</translation>
    </message>
    <message>
        <source>G94 is missing before this motion: after a run that was stopped its F would be read as a time</source>
        <translation>G94 mangler før denne bevegelsen: etter en avbrutt kjøring ville F bli lest som en tid</translation>
    </message>
    <message>
        <source>change the places of the machines in their table</source>
        <translation>endre maskinenes plasseringer i tabellen</translation>
    </message>
    <message>
        <source>every two machines can work together, but no order of work was found for all</source>
        <translation>to og to maskiner kan arbeide sammen, men ingen arbeidsrekkefølge ble funnet for alle</translation>
    </message>
    <message>
        <source>give a bead or a line for each machine, in their order</source>
        <translation>oppgi en streng eller en linje for hver maskin, i maskinenes rekkefølge</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, or the job.voluta of one machine here</source>
        <translation>gi den til &apos;together&apos;, eller oppgi job.voluta for én maskin her</translation>
    </message>
    <message>
        <source>increase the minimum distance of moving arms, or place the machines further apart</source>
        <translation>øk minsteavstanden for armer i bevegelse, eller plasser maskinene lenger fra hverandre</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>det er en mappe</translation>
    </message>
    <message>
        <source>no order of work keeps the machines apart: {first} of machine {one} and {second} of machine {two} hinder each other</source>
        <translation>ingen arbeidsrekkefølge holder maskinene fra hverandre: {first} på maskin {one} og {second} på maskin {two} hindrer hverandre</translation>
    </message>
    <message>
        <source>no program of it passed that states the arm</source>
        <translation>ingen av programmene som angir armen, besto</translation>
    </message>
    <message>
        <source>not the project of a station</source>
        <translation>ikke prosjektet til en stasjon</translation>
    </message>
    <message>
        <source>place the machines further apart if they stand at two plates</source>
        <translation>plasser maskinene lenger fra hverandre hvis de står ved to byggeplater</translation>
    </message>
    <message>
        <source>place the machines further apart, or the parts further from the border</source>
        <translation>plasser maskinene lenger fra hverandre, eller delene lenger fra grensen</translation>
    </message>
    <message>
        <source>place the machines further apart, the parts further from the border, or the arms at rest further from it</source>
        <translation>plasser maskinene lenger fra hverandre, delene lenger fra grensen, eller armene i ro lenger fra den</translation>
    </message>
    <message>
        <source>see the report of that machine</source>
        <translation>se rapporten for den maskinen</translation>
    </message>
    <message>
        <source>the file of the station is truncated</source>
        <translation>stasjonens fil er avkortet</translation>
    </message>
    <message>
        <source>the folder holds no program of the station</source>
        <translation>mappen inneholder ikke noe program for stasjonen</translation>
    </message>
    <message>
        <source>the header of the station&apos;s file is damaged</source>
        <translation>hodet i stasjonens fil er skadet</translation>
    </message>
    <message>
        <source>the part of machine {one} or {two} is inside the part, the plate or an obstacle of the other</source>
        <translation>delen til maskin {one} eller {two} er inne i den andres del, byggeplate eller en hindring</translation>
    </message>
    <message>
        <source>the place of a machine is damaged</source>
        <translation>plasseringen til en maskin er skadet</translation>
    </message>
    <message>
        <source>the program is refused</source>
        <translation>programmet er avvist</translation>
    </message>
    <message>
        <source>the project is not of machines that work together</source>
        <translation>prosjektet gjelder ikke maskiner som arbeider sammen</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not of one job</source>
        <translation>prosjektet til en stasjon med flere maskiner, ikke til én jobb</translation>
    </message>
    <message>
        <source>the rules of the station are damaged</source>
        <translation>stasjonens regler er skadet</translation>
    </message>
    <message>
        <source>the station has no machines</source>
        <translation>stasjonen har ingen maskiner</translation>
    </message>
    <message>
        <source>write the programs of all machines again</source>
        <translation>skriv programmene til alle maskiner på nytt</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} ({layer})</source>
        <translation>{body} på maskin {one} møter {obstacle} på maskin {two} ({layer})</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} after {time}; collisions of the machines: {collisions}</source>
        <translation>{body} på maskin {one} møter {obstacle} på maskin {two} etter {time}; kollisjoner mellom maskinene: {collisions}</translation>
    </message>
    <message>
        <source>{places} places for {machines} machines</source>
        <translation>{places} plasseringer for {machines} maskiner</translation>
    </message>
    <message>
        <source>bead {bead} is printed: this rest begins with bead {first}</source>
        <translation>streng {bead} er printet: denne resten begynner med streng {first}</translation>
    </message>
    <message>
        <source>beads have the numbers of the whole print</source>
        <translation>strengene har numrene fra hele printen</translation>
    </message>
    <message>
        <source>the place of a machine</source>
        <translation>plasseringen til en maskin</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Godta</translation>
    </message>
    <message>
        <source>How far the printed part may differ from the requested one before the plan is marked. Never changes what is safe to run.</source>
        <translation>Hvor mye den printede delen kan avvike fra den ønskede før planen merkes. Endrer aldri hva som er trygt å kjøre.</translation>
    </message>
    <message>
        <source>In this job; the verification report lists it</source>
        <translation>I denne jobben; verifikasjonsrapporten oppgir det</translation>
    </message>
    <message numerus="yes">
        <source>Nothing that was checked endangers robot or cell: {checks} checks of the part are beyond their limits.</source>
        <translation>
            <numerusform>Ingenting som ble kontrollert, setter robot eller celle i fare: {checks} kontroll av delen er utenfor grensen.</numerusform>
            <numerusform>Ingenting som ble kontrollert, setter robot eller celle i fare: {checks} kontroller av delen er utenfor grensene.</numerusform>
        </translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kvalitet</translation>
    </message>
    <message>
        <source>Safe to run, but it does not print the part as asked.</source>
        <translation>Trygt å kjøre, men det printer ikke delen som ønsket.</translation>
    </message>
    <message>
        <source>accepted differences</source>
        <translation>godtatte avvik</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>utkast</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>masse</translation>
    </message>
    <message>
        <source>overfill</source>
        <translation>overfylling</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>kvalitet</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>strikt</translation>
    </message>
    <message>
        <source>uncovered</source>
        <translation>udekket</translation>
    </message>
    <message>
        <source>unsupported</source>
        <translation>uten støtte</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>vanlig</translation>
    </message>
    <message>
        <source>{length:.1f} of bead ({share:.2f}) is unsupported</source>
        <translation>{length:.1f} streng ({share:.2f}) er uten støtte</translation>
    </message>
    <message>
        <source>{quality}; accepted: {shares}</source>
        <translation>{quality}; godtatt: {shares}</translation>
    </message>
    <message>
        <source>How a part whose surface has wide openings or no thickness is handled: close openings that are flat or small and refuse others, refuse it, close the openings with patches, thicken the surface to a wall two beads wide, or print it as one wall, one bead wide.</source>
        <translation>Hvordan en del der overflaten har vide åpninger eller ingen tykkelse, behandles: lukk åpninger som er flate eller små, og avvis andre, avvis den, lukk åpningene med lapper, gjør overflaten tykkere til en vegg på to strengers bredde, eller print den som én vegg, én streng bred.</translation>
    </message>
    <message>
        <source>Shares that are accepted in this job beyond the quality&apos;s limits: uncovered, unsupported, overfill, mass and thin, such as uncovered=0.05, mass=0.04. Verification reports list them.</source>
        <translation>Andeler som godtas i denne jobben utover kvalitetens grenser: uncovered, unsupported, overfill, mass og thin, for eksempel uncovered=0.05, mass=0.04. Verifikasjonsrapporter oppgir dem.</translation>
    </message>
    <message>
        <source>The spiral follows the largest contour of each layer; holes and other contours are left out.</source>
        <translation>Spiralen følger den største konturen i hvert lag; hull og andre konturer utelates.</translation>
    </message>
    <message>
        <source>Thin: {share:.1f} of the part is narrower than the narrowest bead and stays open; at most {limit:.4g} allowed.</source>
        <translation>Tynt: {share:.1f} av delen er smalere enn den smaleste strengen og forblir åpent; høyst {limit:.4g} tillatt.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisk</translation>
    </message>
    <message>
        <source>check these places in the view; move the part on the plate if they matter</source>
        <translation>kontroller disse stedene i visningen; flytt delen på byggeplaten hvis de betyr noe</translation>
    </message>
    <message>
        <source>choose a process with narrower beads, or slice the part again with wider ones</source>
        <translation>velg en prosess med smalere strenger, eller slice delen på nytt med bredere</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for; the tool-paths are printed as they are</source>
        <translation>velg prosessen som filen ble slicet for; verktøybanene printes som de er</translation>
    </message>
    <message>
        <source>export the file again in millimetres, at the size to be printed</source>
        <translation>eksporter filen på nytt i millimeter, i størrelsen som skal printes</translation>
    </message>
    <message>
        <source>in line {line} first</source>
        <translation>først på linje {line}</translation>
    </message>
    <message>
        <source>in no single line</source>
        <translation>ikke på noen enkelt linje</translation>
    </message>
    <message>
        <source>look at that line: export the file again without it, with straight lines or arcs (G1, G2, G3)</source>
        <translation>se på den linjen: eksporter filen på nytt uten den, med rette linjer eller buer (G1, G2, G3)</translation>
    </message>
    <message>
        <source>move the part on the plate, or slice it again for a lower speed there</source>
        <translation>flytt delen på byggeplaten, eller slice den på nytt for lavere hastighet der</translation>
    </message>
    <message>
        <source>move the part on the plate, or use another cell; its tool-paths are printed as they are</source>
        <translation>flytt delen på byggeplaten, eller bruk en annen celle; verktøybanene printes som de er</translation>
    </message>
    <message>
        <source>move the part on the plate, use a slimmer print head, or allow less clearance</source>
        <translation>flytt delen på byggeplaten, bruk et slankere skrivehode, eller tillat mindre klaring</translation>
    </message>
    <message>
        <source>outer contour alone</source>
        <translation>bare ytre kontur</translation>
    </message>
    <message>
        <source>plan again with more clearance, or move the part on the plate</source>
        <translation>planlegg på nytt med større klaring, eller flytt delen på byggeplaten</translation>
    </message>
    <message>
        <source>see its report</source>
        <translation>se rapporten</translation>
    </message>
    <message>
        <source>see the remedies in the job of that machine</source>
        <translation>se tiltakene i jobben til den maskinen</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, its beads and what is left out have {read:.0f}; they part {line}</source>
        <translation>filen ekstruderer {stated:.0f} etter E-ordene sine, strengene og det som utelates, har {read:.0f}; de avviker fra hverandre {line}</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, the tool-paths taken from it have {read:.0f}; they part {line}</source>
        <translation>filen ekstruderer {stated:.0f} etter E-ordene sine, verktøybanene hentet fra den har {read:.0f}; de avviker fra hverandre {line}</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>tynt</translation>
    </message>
    <message>
        <source>use a cell whose arm can tilt the nozzle, or print the paths on the plate</source>
        <translation>bruk en celle der armen kan tilte dysen, eller print banene på byggeplaten</translation>
    </message>
    <message>
        <source>use a cell with a larger plate, or slice the part again at a smaller size</source>
        <translation>bruk en celle med større byggeplate, eller slice delen på nytt i mindre størrelse</translation>
    </message>
    <message numerus="yes">
        <source>{share:.2f} of the part ({volume:.3g}) is narrower than the narrowest bead ({bead:.3g}) and stays open, at {places} places, mostly around this point</source>
        <translation>
            <numerusform>{share:.2f} av delen ({volume:.3g}) er smalere enn den smaleste strengen ({bead:.3g}) og forblir åpent, på {places} sted, her</numerusform>
            <numerusform>{share:.2f} av delen ({volume:.3g}) er smalere enn den smaleste strengen ({bead:.3g}) og forblir åpent, på {places} steder, mest rundt dette punktet</numerusform>
        </translation>
    </message>
    <message>
        <source>choose another pattern or another share, or a quality that accepts longer bridges</source>
        <translation>velg et annet mønster eller en annen andel, eller en kvalitet som godtar lengre broer</translation>
    </message>
    <message>
        <source>its lines branch below skins that would sag between them</source>
        <translation>linjene forgrener seg under hud som ville sige mellom dem</translation>
    </message>
    <message>
        <source>sparse infill fills {found:.0f} of the interior instead of {asked:.0f}: {reason}</source>
        <translation>glissent fyll fyller {found:.0f} av det indre i stedet for {asked:.0f}: {reason}</translation>
    </message>
    <message>
        <source>the interior is too small for its lines, or they cannot lie any closer</source>
        <translation>det indre er for lite for linjene, eller de kan ikke ligge tettere</translation>
    </message>
    <message>
        <source>Bead width, length that it bridges with a sag of up to 0.2 mm; and so on, in mm. Quality usual and draft accept it. Those of the program&apos;s materials are estimates: replace them by those of a test print.</source>
        <translation>Strengbredde, lengden den bygger bro over med et sig på opptil 0,2 mm; og så videre, i mm. Kvalitetene usual og draft godtar det. Verdiene for programmets materialer er anslag: erstatt dem med verdier fra en testprint.</translation>
    </message>
    <message>
        <source>Maximum distance between waypoints along a tool-path; plain G-code has fewer where beads are straight.</source>
        <translation>Største avstand mellom banepunkter langs en verktøybane; enkel G-kode har færre der strengene er rette.</translation>
    </message>
    <message>
        <source>Share of the speed of a wall that overhangs the layer below by that share of its width.</source>
        <translation>Andel av hastigheten for en vegg som henger ut over laget under med den andelen av bredden.</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), turn the part, or use planar or curved mode</source>
        <translation>legg til støtter (`supports=auto`), roter delen, eller bruk modus planar eller curved</translation>
    </message>
    <message>
        <source>bridges with a little sag</source>
        <translation>broer med litt sig</translation>
    </message>
    <message>
        <source>choose a plate with a size, or type the number of copies</source>
        <translation>velg en byggeplate med størrelse, eller skriv antall kopier</translation>
    </message>
    <message>
        <source>is above 1000 mm: check the unit</source>
        <translation>er over 1000 mm: kontroller enheten</translation>
    </message>
    <message>
        <source>is more than with less overhang</source>
        <translation>er mer enn med mindre overheng</translation>
    </message>
    <message>
        <source>is not wider than the bead before it</source>
        <translation>er ikke bredere enn strengen før</translation>
    </message>
    <message>
        <source>must be a pair of bead width and length</source>
        <translation>må være et par av strengbredde og lengde</translation>
    </message>
    <message>
        <source>must have four shares, for 25, 50, 75 and 100 % of the width</source>
        <translation>må ha fire andeler, for 25, 50, 75 og 100 % av bredden</translation>
    </message>
    <message>
        <source>speed of walls, 100 % overhang</source>
        <translation>hastighet for vegger, 100 % overheng</translation>
    </message>
    <message>
        <source>speed of walls, 25 % overhang</source>
        <translation>hastighet for vegger, 25 % overheng</translation>
    </message>
    <message>
        <source>speed of walls, 50 % overhang</source>
        <translation>hastighet for vegger, 50 % overheng</translation>
    </message>
    <message>
        <source>speed of walls, 75 % overhang</source>
        <translation>hastighet for vegger, 75 % overheng</translation>
    </message>
    <message>
        <source>the plate is made as large as the parts need</source>
        <translation>byggeplaten gjøres så stor som delene trenger</translation>
    </message>
    <message>
        <source>write the program again, or use smaller cells for the part&apos;s map</source>
        <translation>skriv programmet på nytt, eller bruk mindre celler for delens kart</translation>
    </message>
    <message>
        <source>allow larger facets, or export less detail</source>
        <translation>tillat større fasetter, eller eksporter færre detaljer</translation>
    </message>
    <message>
        <source>cannot be read: voluta-cad-reader is missing beside this program</source>
        <translation>kan ikke leses: voluta-cad-reader mangler ved siden av dette programmet</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>kopier eller eksporter den på nytt</translation>
    </message>
    <message>
        <source>export the solid from the CAD program</source>
        <translation>eksporter legemet fra CAD-programmet</translation>
    </message>
    <message>
        <source>give it the ending .stl</source>
        <translation>gi den endelsen .stl</translation>
    </message>
    <message>
        <source>has no solid and no surface</source>
        <translation>har verken legeme eller flate</translation>
    </message>
    <message>
        <source>has only curves, no solid and no surface</source>
        <translation>har bare kurver, verken legeme eller flate</translation>
    </message>
    <message>
        <source>is an STL, not a STEP or IGES file</source>
        <translation>er en STL, ikke en STEP- eller IGES-fil</translation>
    </message>
    <message>
        <source>is cut short: {lacking}</source>
        <translation>er avkortet: {lacking}</translation>
    </message>
    <message>
        <source>is damaged: Open CASCADE cannot read it</source>
        <translation>er skadet: Open CASCADE kan ikke lese den</translation>
    </message>
    <message>
        <source>needs more than 4 GB of memory to read</source>
        <translation>trenger mer enn 4 GB minne for å leses</translation>
    </message>
    <message>
        <source>not a STEP or IGES file</source>
        <translation>ikke en STEP- eller IGES-fil</translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} curves</source>
        <translation>
            <numerusform>utelatt: én kurve</numerusform>
            <numerusform>utelatt: {n} kurver</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} surfaces without facets</source>
        <translation>
            <numerusform>utelatt: én flate uten fasetter</numerusform>
            <numerusform>utelatt: {n} flater uten fasetter</numerusform>
        </translation>
    </message>
    <message>
        <source>one or several solids; read by a program of its own</source>
        <translation>ett eller flere legemer; leses av et eget program</translation>
    </message>
    <message>
        <source>open the hollow or turn the part; without supports (`supports=none`, `rimSupports=none`) the hollow&apos;s roof is unsupported</source>
        <translation>åpne hulrommet eller roter delen; uten støtte (`supports=none`, `rimSupports=none`) er taket i hulrommet uten støtte</translation>
    </message>
    <message>
        <source>surfaces are read as facets, at most {chord:.3g} off</source>
        <translation>flater leses som fasetter, høyst {chord:.3g} unna</translation>
    </message>
    <message>
        <source>takes longer than {time:.0f} to read</source>
        <translation>tar mer enn {time:.0f} å lese</translation>
    </message>
    <message>
        <source>the end of a STEP file is missing</source>
        <translation>slutten av en STEP-fil mangler</translation>
    </message>
    <message>
        <source>the last line of an IGES file is missing, or names other numbers of lines</source>
        <translation>siste linje i en IGES-fil mangler, eller oppgir andre linjeantall</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a preset&apos;s id</source>
        <translation>&apos;{id}&apos; kan ikke være id for en forhåndsinnstilling</translation>
    </message>
    <message>
        <source>&apos;{key}&apos; is not a setting of presets</source>
        <translation>&apos;{key}&apos; er ingen innstilling for forhåndsinnstillinger</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of layers</source>
        <translation>&apos;{text}&apos; er ingen liste over lag</translation>
    </message>
    <message>
        <source>Fill of what is meant to be solid: mean along the view, for beads with round edges</source>
        <translation>Fylling av det som skal være massivt: middel langs synsretningen, for strenger med runde kanter</translation>
    </message>
    <message>
        <source>Overhang
mm²</source>
        <translation>Overheng
mm²</translation>
    </message>
    <message>
        <source>Unprinted
voxels</source>
        <translation>Voksler
uten utskrift</translation>
    </message>
    <message>
        <source>a film of {length} cannot be made</source>
        <translation>en film på {length} kan ikke lages</translation>
    </message>
    <message>
        <source>a preset &apos;{id}&apos; comes with the program</source>
        <translation>en forhåndsinnstilling &apos;{id}&apos; følger med programmet</translation>
    </message>
    <message>
        <source>a preset &apos;{label}&apos; comes with the program</source>
        <translation>en forhåndsinnstilling &apos;{label}&apos; følger med programmet</translation>
    </message>
    <message>
        <source>a preset needs a name</source>
        <translation>en forhåndsinnstilling må ha et navn</translation>
    </message>
    <message>
        <source>add supports, make sparse infill denser, rotate the part, or choose mode auto</source>
        <translation>legg til støtte, gjør glissent fyll tettere, roter delen, eller velg modus auto</translation>
    </message>
    <message>
        <source>choose a smaller dovetail, another direction or another plane</source>
        <translation>velg en mindre svalehale, en annen retning eller et annet plan</translation>
    </message>
    <message>
        <source>choose a smaller pin or another plane</source>
        <translation>velg en mindre tapp eller et annet plan</translation>
    </message>
    <message>
        <source>choose another folder, or check the space on the disk</source>
        <translation>velg en annen mappe, eller sjekk plassen på disken</translation>
    </message>
    <message>
        <source>drawing the film</source>
        <translation>tegner filmen</translation>
    </message>
    <message>
        <source>format {format} has no command for {event}</source>
        <translation>formatet {format} har ingen kommando for {event}</translation>
    </message>
    <message>
        <source>give numbers, such as 12, 40</source>
        <translation>oppgi tall, som 12, 40</translation>
    </message>
    <message>
        <source>import the parent first, or name another one</source>
        <translation>importer forelderen først, eller oppgi en annen</translation>
    </message>
    <message>
        <source>in their home poses machines {one} and {two} are too close to each other</source>
        <translation>i hvilestillingene er maskinene {one} og {two} for nær hverandre</translation>
    </message>
    <message>
        <source>infill tool</source>
        <translation>verktøy for fyll</translation>
    </message>
    <message>
        <source>move the plane into the part</source>
        <translation>flytt planet inn i delen</translation>
    </message>
    <message>
        <source>move them apart, or change a home pose</source>
        <translation>flytt dem fra hverandre, eller endre en hvilestilling</translation>
    </message>
    <message>
        <source>must not be blank</source>
        <translation>må ikke være tomt</translation>
    </message>
    <message>
        <source>name another parent</source>
        <translation>oppgi en annen forelder</translation>
    </message>
    <message>
        <source>name it &apos;{id}&apos;</source>
        <translation>kall den &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>no platform below the overhang: {area:.3g}</source>
        <translation>ingen plattform under overhenget: {area:.3g}</translation>
    </message>
    <message>
        <source>no room in the section for a dovetail of {width}, {height} high</source>
        <translation>det er ikke plass i snittet til en svalehale på {width}, {height} høy</translation>
    </message>
    <message>
        <source>no room in the section for a pin of {diameter}, {depth} deep</source>
        <translation>det er ikke plass i snittet til en tapp på {diameter}, {depth} dyp</translation>
    </message>
    <message>
        <source>pauses before layers</source>
        <translation>pauser før lag</translation>
    </message>
    <message>
        <source>preset &apos;{id}&apos; is its own parent, through its parents</source>
        <translation>forhåndsinnstillingen &apos;{id}&apos; er sin egen forelder, gjennom foreldrene</translation>
    </message>
    <message>
        <source>repair the part, or move the plane</source>
        <translation>reparer delen, eller flytt planet</translation>
    </message>
    <message>
        <source>small contact with the plate: {foot:.3g}; uncut, the part has {whole:.3g#}</source>
        <translation>liten kontakt med platen: {foot:.3g}; udelt har delen {whole:.3g#}</translation>
    </message>
    <message>
        <source>support tool</source>
        <translation>verktøy for støtte</translation>
    </message>
    <message>
        <source>the bead below is covered after {time:.1f}, before the minimum layer time of {limit:.1f}; on {length:.0f} of beads in all</source>
        <translation>strengen under dekkes etter {time:.1f}, før minste lagtid på {limit:.1f}; i alt på {length:.0f} av strenger</translation>
    </message>
    <message>
        <source>the cutter cuts into the fixture below the block</source>
        <translation>fresen skjærer inn i oppspenningen under blokken</translation>
    </message>
    <message>
        <source>the film cannot be written</source>
        <translation>filmen kan ikke skrives</translation>
    </message>
    <message>
        <source>the id &apos;{id}&apos; is not the name of the file</source>
        <translation>id-en &apos;{id}&apos; er ikke navnet på filen</translation>
    </message>
    <message>
        <source>the joint cannot be cut out of this mesh</source>
        <translation>skjøten kan ikke skjæres ut av dette nettet</translation>
    </message>
    <message>
        <source>the parent &apos;{parent}&apos; of preset &apos;{id}&apos; does not exist</source>
        <translation>forelderen &apos;{parent}&apos; til forhåndsinnstillingen &apos;{id}&apos; finnes ikke</translation>
    </message>
    <message>
        <source>the plane does not cut the part</source>
        <translation>planet skjærer ikke delen</translation>
    </message>
    <message>
        <source>there is a preset &apos;{label}&apos; already</source>
        <translation>det finnes allerede en forhåndsinnstilling &apos;{label}&apos;</translation>
    </message>
    <message>
        <source>type a name</source>
        <translation>skriv et navn</translation>
    </message>
    <message>
        <source>unknown preset &apos;{id}&apos;</source>
        <translation>ukjent forhåndsinnstilling &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>use a smaller cutter or a smaller stepover, or rotate the part</source>
        <translation>bruk en mindre fres eller et mindre sideskritt, eller roter delen</translation>
    </message>
    <message>
        <source>x,y,z in the part&apos;s file, for example 1,0,0: reports the strength for a load in this direction. Empty: no load.</source>
        <translation>x,y,z i delens fil, for eksempel 1,0,0: oppgir styrken for en last i denne retningen. Tomt: ingen last.</translation>
    </message>
    <message>
        <source>the film cannot be written: FFmpeg has no encoder for VP9</source>
        <translation>filmen kan ikke skrives: FFmpeg har ingen koder for VP9</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from &apos;{parent}&apos;, which does not exist</source>
        <translation>&apos;{id}&apos; arver fra &apos;{parent}&apos;, som ikke finnes</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from itself, through its parents</source>
        <translation>&apos;{id}&apos; arver fra seg selv, gjennom foreldrene</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is incomplete</source>
        <translation>&apos;{text}&apos; er ufullstendig</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an event of a layer</source>
        <translation>&apos;{text}&apos; er ingen hendelse for et lag</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} {number} is out of range</source>
        <translation>&apos;{text}&apos;: {field} {number} er utenfor området</translation>
    </message>
    <message>
        <source>At a stop the pendant shows no text: the controller sends it to the sender of the frames, which has to show it.</source>
        <translation>Ved en stopp viser håndterminalen ingen tekst: styringen sender den til avsenderen av rammene, som må vise den.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boks</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Skjær bort</translation>
    </message>
    <message>
        <source>Cylinder along Z</source>
        <translation>Sylinder langs Z</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Dybde</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Retning X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Retning Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Retning Z</translation>
    </message>
    <message>
        <source>Flat layers along a direction</source>
        <translation>Flate lag langs en retning</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Fra</translation>
    </message>
    <message>
        <source>Height (Z)</source>
        <translation>Høyde (Z)</translation>
    </message>
    <message>
        <source>Layers along the surface</source>
        <translation>Lag langs overflaten</translation>
    </message>
    <message>
        <source>Layers around the rest</source>
        <translation>Lag rundt resten</translation>
    </message>
    <message>
        <source>Layers that turn to a direction</source>
        <translation>Lag som dreier mot en retning</translation>
    </message>
    <message>
        <source>Middle X</source>
        <translation>Midtpunkt X</translation>
    </message>
    <message>
        <source>Middle Y</source>
        <translation>Midtpunkt Y</translation>
    </message>
    <message>
        <source>Middle Z</source>
        <translation>Midtpunkt Z</translation>
    </message>
    <message>
        <source>Numbers of layers of the part, separated by commas: before each of them the arm goes beside the part and waits until the operator continues, for example to put in an insert. Then it primes the nozzle there.</source>
        <translation>Delens lagnumre atskilt med komma: før hvert av dem går armen til siden for delen og venter til operatøren fortsetter, for eksempel for å legge inn en innsats. Deretter primer den dysen der.</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>Egne innstillinger</translation>
    </message>
    <message>
        <source>Painted surface</source>
        <translation>Malt overflate</translation>
    </message>
    <message>
        <source>Pauses before layers</source>
        <translation>Pauser før lag</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Range of heights over the plate</source>
        <translation>Høydeområde over byggeplaten</translation>
    </message>
    <message>
        <source>Skin below the upper surface</source>
        <translation>Hud under den øvre overflaten</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kule</translation>
    </message>
    <message>
        <source>Steepest slope (degrees)</source>
        <translation>Bratteste helling (grader)</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Til</translation>
    </message>
    <message>
        <source>a change of colour</source>
        <translation>et fargebytte</translation>
    </message>
    <message>
        <source>a change to extruder {number}</source>
        <translation>et bytte til ekstruder {number}</translation>
    </message>
    <message>
        <source>a painted fuzzy skin</source>
        <translation>en malt ru overflate</translation>
    </message>
    <message>
        <source>a painted seam</source>
        <translation>en malt søm</translation>
    </message>
    <message>
        <source>a pause</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>a spiral has no regions</source>
        <translation>en spiral har ingen regioner</translation>
    </message>
    <message>
        <source>a statement of your own</source>
        <translation>en egen setning</translation>
    </message>
    <message>
        <source>a tool changes before a layer, not at a height</source>
        <translation>et verktøy byttes før et lag, ikke ved en høyde</translation>
    </message>
    <message>
        <source>add it from its file again</source>
        <translation>legg den til fra filen på nytt</translation>
    </message>
    <message>
        <source>change the tool where the file was made</source>
        <translation>bytt verktøyet der filen ble laget</translation>
    </message>
    <message>
        <source>check what it does on the controller; leave it out of `layerEvents` if you do not need it</source>
        <translation>kontroller hva den gjør på styringen; utelat den fra `layerEvents` hvis den ikke trengs</translation>
    </message>
    <message>
        <source>choose a process without corrections, or remove the regions</source>
        <translation>velg en prosess uten korreksjoner, eller fjern regionene</translation>
    </message>
    <message>
        <source>correct the setting; layers are counted for each part</source>
        <translation>rett innstillingen; lagene telles for hver del</translation>
    </message>
    <message>
        <source>custom G-code</source>
        <translation>egen G-kode</translation>
    </message>
    <message>
        <source>event</source>
        <translation>hendelse</translation>
    </message>
    <message>
        <source>events before layers</source>
        <translation>hendelser før lag</translation>
    </message>
    <message>
        <source>format {format} has outputs {first} to {last}, not {number}</source>
        <translation>formatet {format} har utgangene {first} til {last}, ikke {number}</translation>
    </message>
    <message>
        <source>give a steeper slope</source>
        <translation>oppgi en brattere helling</translation>
    </message>
    <message>
        <source>give a tilted direction</source>
        <translation>oppgi en skrå retning</translation>
    </message>
    <message>
        <source>give the lower height first</source>
        <translation>oppgi den laveste høyden først</translation>
    </message>
    <message>
        <source>give the number of the layer</source>
        <translation>oppgi nummeret på laget</translation>
    </message>
    <message>
        <source>give {field} from {least} to {most}</source>
        <translation>oppgi {field} fra {least} til {most}</translation>
    </message>
    <message>
        <source>height {height}</source>
        <translation>høyde {height}</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>er ikke et JSON-objekt</translation>
    </message>
    <message>
        <source>layers of region {region} turn to a vertical direction</source>
        <translation>lagene i region {region} dreier mot en loddrett retning</translation>
    </message>
    <message>
        <source>layers that turn by {angle} within the region are {thin:.2f} to {thick:.2f} thick, outside the limits</source>
        <translation>lag som dreier {angle} innenfor regionen, er {thin:.2f} til {thick:.2f} tykke, utenfor grensene</translation>
    </message>
    <message>
        <source>line {line}: the print pauses before bead {bead} in layer {layer}: {text} ({command})</source>
        <translation>linje {line}: utskriften tar pause før streng {bead} i lag {layer}: {text} ({command})</translation>
    </message>
    <message>
        <source>make it deeper, or use a process with lower layers</source>
        <translation>gjør den dypere, eller bruk en prosess med lavere lag</translation>
    </message>
    <message>
        <source>make the region higher or narrower, or turn by less</source>
        <translation>gjør regionen høyere eller smalere, eller drei mindre</translation>
    </message>
    <message>
        <source>make the region smaller</source>
        <translation>gjør regionen mindre</translation>
    </message>
    <message>
        <source>make the region smaller, or move it</source>
        <translation>gjør regionen mindre, eller flytt den</translation>
    </message>
    <message>
        <source>make the regions smaller, or move them up</source>
        <translation>gjør regionene mindre, eller flytt dem opp</translation>
    </message>
    <message>
        <source>mode {mode} prints on the part: it has no regions</source>
        <translation>modus {mode} skriver ut på delen: den har ingen regioner</translation>
    </message>
    <message>
        <source>move the plane further into the part</source>
        <translation>flytt planet lenger inn i delen</translation>
    </message>
    <message>
        <source>move the plane into a body, or split the part into its bodies</source>
        <translation>flytt planet inn i et legeme, eller del delen opp i legemene</translation>
    </message>
    <message>
        <source>no change of the tool before layer {layer}: the part has {layers} layers</source>
        <translation>intet verktøybytte før lag {layer}: delen har {layers} lag</translation>
    </message>
    <message>
        <source>no {what} before {place} of part {part}: the part has {layers} layers</source>
        <translation>ingen {what} før {place} i del {part}: delen har {layers} lag</translation>
    </message>
    <message>
        <source>no {what} before {place}: the print ends with layer {layers}</source>
        <translation>ingen {what} før {place}: utskriften slutter med lag {layers}</translation>
    </message>
    <message>
        <source>nobody but you knows what the statement is for</source>
        <translation>bare du vet hva setningen er til</translation>
    </message>
    <message>
        <source>not used, as they are damaged: {what} (&apos;{member}&apos;): {why}</source>
        <translation>ikke brukt fordi de er skadet: {what} (&apos;{member}&apos;): {why}</translation>
    </message>
    <message>
        <source>not used: invalid settings of region &apos;{region}&apos; from the file: {settings}</source>
        <translation>ikke brukt: ugyldige innstillinger for region &apos;{region}&apos; fra filen: {settings}</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file, which has no settings</source>
        <translation>ikke brukt: region &apos;{region}&apos; fra filen, som ikke har innstillinger</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file: its mesh is not closed</source>
        <translation>ikke brukt: region &apos;{region}&apos; fra filen: nettet er ikke lukket</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height (&apos;{member}&apos;)</source>
        <translation>ikke brukt: innstillinger for høydeområder (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height of object {number}, which does not exist (&apos;{member}&apos;)</source>
        <translation>ikke brukt: innstillinger for høydeområder for objekt {number}, som ikke finnes (&apos;{member}&apos;)</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height: the objects of the file are one part</source>
        <translation>ikke brukt: innstillinger for høydeområder: objektene i filen er én del</translation>
    </message>
    <message>
        <source>not used: settings of region &apos;{region}&apos; from the file without a counterpart: {settings}</source>
        <translation>ikke brukt: innstillinger for region &apos;{region}&apos; fra filen uten motstykke: {settings}</translation>
    </message>
    <message>
        <source>not used: the range of heights from {from} to {to} in the file, which is empty</source>
        <translation>ikke brukt: høydeområdet fra {from} til {to} i filen, som er tomt</translation>
    </message>
    <message>
        <source>not used: tool {tool} of region &apos;{region}&apos; from the file: the job has {tools}</source>
        <translation>ikke brukt: verktøy {tool} for region &apos;{region}&apos; fra filen: jobben har {tools}</translation>
    </message>
    <message>
        <source>not used: {count} further events at heights (&apos;{member}&apos;)</source>
        <translation>ikke brukt: {count} hendelser til ved høyder (&apos;{member}&apos;)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} further regions of the file</source>
        <translation>
            <numerusform>ikke brukt: {count} region til fra filen</numerusform>
            <numerusform>ikke brukt: {count} regioner til fra filen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops before the first bead, since programs begin with a question</source>
        <translation>
            <numerusform>ikke brukt: {count} stopp før den første strengen, siden programmer begynner med et spørsmål</numerusform>
            <numerusform>ikke brukt: {count} stopp før den første strengen, siden programmer begynner med et spørsmål</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} (&apos;{member}&apos;)</source>
        <translation>ikke brukt: {event} i en høyde på {height} (&apos;{member}&apos;)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, from line {line} of {where})</source>
        <translation>
            <numerusform>ikke brukt: {paint} på {count} trekant i &apos;{object}&apos; ({attribute}, fra linje {line} i {where})</numerusform>
            <numerusform>ikke brukt: {paint} på {count} trekanter i &apos;{object}&apos; ({attribute}, fra linje {line} i {where})</numerusform>
        </translation>
    </message>
    <message>
        <source>output {number} is used by the program itself</source>
        <translation>utgang {number} brukes av selve programmet</translation>
    </message>
    <message>
        <source>paint it in the window, or give a body</source>
        <translation>mal den i vinduet, eller oppgi et legeme</translation>
    </message>
    <message>
        <source>painted colours</source>
        <translation>malte farger</translation>
    </message>
    <message>
        <source>painted supports</source>
        <translation>malt støtte</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pause</translation>
    </message>
    <message>
        <source>presets hold settings of layers, beads, tool-paths, cooling and quality</source>
        <translation>forhåndsinnstillinger inneholder innstillinger for lag, strenger, verktøybaner, kjøling og kvalitet</translation>
    </message>
    <message>
        <source>process {process} corrects sizes: layers of regions have no corrections</source>
        <translation>prosess {process} korrigerer mål: lag i regioner har ingen korreksjoner</translation>
    </message>
    <message>
        <source>region</source>
        <translation>region</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: its mesh is open, and was closed</source>
        <translation>region &apos;{region}&apos; fra filen: nettet er åpent og ble lukket</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: the skin is as thick as the larger one of top and bottom</source>
        <translation>region &apos;{region}&apos; fra filen: huden er så tykk som den største av topp og bunn</translation>
    </message>
    <message numerus="yes">
        <source>region &apos;{region}&apos; from the file: {count} settings</source>
        <translation>
            <numerusform>region &apos;{region}&apos; fra filen: {count} innstilling</numerusform>
            <numerusform>region &apos;{region}&apos; fra filen: {count} innstillinger</numerusform>
        </translation>
    </message>
    <message>
        <source>region &apos;{text}&apos; has no painted surface</source>
        <translation>regionen &apos;{text}&apos; har ingen malt overflate</translation>
    </message>
    <message>
        <source>region &apos;{text}&apos;: &apos;{setting}&apos; is no setting</source>
        <translation>region &apos;{text}&apos;: &apos;{setting}&apos; er ingen innstilling</translation>
    </message>
    <message>
        <source>region {region} cannot be separated from the part: one of them is not closed or intersects itself</source>
        <translation>region {region} kan ikke skilles fra delen: en av dem er ikke lukket eller skjærer seg selv</translation>
    </message>
    <message>
        <source>region {region} contains the whole part: nothing carries its layers</source>
        <translation>region {region} inneholder hele delen: ingenting bærer lagene</translation>
    </message>
    <message>
        <source>region {region} cuts away the whole part</source>
        <translation>region {region} skjærer bort hele delen</translation>
    </message>
    <message>
        <source>region {region} follows no surface: it has no layers of its own</source>
        <translation>region {region} følger ingen overflate: den har ingen egne lag</translation>
    </message>
    <message>
        <source>region {region} has no mesh</source>
        <translation>region {region} har ikke noe nett</translation>
    </message>
    <message>
        <source>region {region} is thinner than the lowest layer ({least})</source>
        <translation>region {region} er tynnere enn det laveste laget ({least})</translation>
    </message>
    <message>
        <source>region {region}: no face of the part is as flat as that</source>
        <translation>region {region}: ingen flate på delen er så flat</translation>
    </message>
    <message>
        <source>regions take away what the part stands on: the rest of it begins {gap:.3g} above its place</source>
        <translation>regioner fjerner det delen står på: resten begynner {gap:.3g} over plassen sin</translation>
    </message>
    <message>
        <source>remove the regions, or choose another mode</source>
        <translation>fjern regionene, eller velg en annen modus</translation>
    </message>
    <message>
        <source>remove the regions, or plan layers of the part (`givenToolPaths=false`)</source>
        <translation>fjern regionene, eller planlegg lag for delen (`givenToolPaths=false`)</translation>
    </message>
    <message>
        <source>remove the regions, or set spiral to false</source>
        <translation>fjern regionene, eller sett spiral til false</translation>
    </message>
    <message>
        <source>repair the part, or move the region a little</source>
        <translation>reparer delen, eller flytt regionen litt</translation>
    </message>
    <message>
        <source>setting an output</source>
        <translation>setting av en utgang</translation>
    </message>
    <message>
        <source>settings of a region: {keys}</source>
        <translation>innstillinger for en region: {keys}</translation>
    </message>
    <message>
        <source>template G-code</source>
        <translation>G-kode fra mal</translation>
    </message>
    <message>
        <source>the body of a region is not closed</source>
        <translation>legemet til en region er ikke lukket</translation>
    </message>
    <message>
        <source>the plane leaves a slab of {thickness} at {place}, thinner than a layer</source>
        <translation>planet etterlater en skive på {thickness} ved {place}, tynnere enn et lag</translation>
    </message>
    <message>
        <source>the plane passes between the bodies of the part and cuts none</source>
        <translation>planet går mellom legemene i delen og skjærer ingen av dem</translation>
    </message>
    <message>
        <source>the range of heights from {from} to {to} is empty</source>
        <translation>høydeområdet fra {from} til {to} er tomt</translation>
    </message>
    <message>
        <source>the statement &apos;{text}&apos; is one of format {wanted}, not of {format}</source>
        <translation>setningen &apos;{text}&apos; hører til formatet {wanted}, ikke {format}</translation>
    </message>
    <message>
        <source>the tool-paths of a file have no regions</source>
        <translation>verktøybanene i en fil har ingen regioner</translation>
    </message>
    <message>
        <source>the tools of a file&apos;s tool-paths are its own: none changes before a layer</source>
        <translation>verktøyene til verktøybanene i en fil er filens egne: ingen byttes før et lag</translation>
    </message>
    <message>
        <source>unknown parameter {key}</source>
        <translation>ukjent parameter {key}</translation>
    </message>
    <message>
        <source>unknown parent &apos;{id}&apos;</source>
        <translation>ukjent forelder &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>unknown region &apos;{name}&apos;</source>
        <translation>ukjent region &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>unknown use &apos;{name}&apos; of a region</source>
        <translation>ukjent bruk &apos;{name}&apos; av en region</translation>
    </message>
    <message>
        <source>unsupported voxels in flat layers: {missed} of {voxels} ({share:.1f}); no layer below carries them</source>
        <translation>voksler uten støtte i flate lag: {missed} av {voxels} ({share:.1f}); ingen lag under bærer dem</translation>
    </message>
    <message>
        <source>use &apos;{text}&apos; of a region has no direction</source>
        <translation>bruken &apos;{text}&apos; av en region har ingen retning</translation>
    </message>
    <message>
        <source>use another output</source>
        <translation>bruk en annen utgang</translation>
    </message>
    <message>
        <source>write {form}, lengths in mm</source>
        <translation>skriv {form}, lengder i mm</translation>
    </message>
    <message>
        <source>your own statement, which nothing checks: {statement}</source>
        <translation>egen setning, som ingenting kontrollerer: {statement}</translation>
    </message>
    <message>
        <source>{key} is a setting of the part, not of a region</source>
        <translation>{key} er en innstilling for delen, ikke for en region</translation>
    </message>
    <message>
        <source>{name}; changed: {settings}</source>
        <translation>{name}; endret: {settings}</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>&apos;{code}&apos; is missing before the line: it would run ahead of the arm</source>
        <translation>&apos;{code}&apos; mangler før linjen: den ville kjøre foran armen</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; has characters that controllers do not know</source>
        <translation>&apos;{text}&apos; har tegn som styringer ikke kjenner</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: a pause&apos;s text has at most {limit} characters</source>
        <translation>&apos;{text}&apos;: teksten til en pause har høyst {limit} tegn</translation>
    </message>
    <message>
        <source>a stop shows no text</source>
        <translation>et stopp viser ingen tekst</translation>
    </message>
    <message>
        <source>shorten the text</source>
        <translation>forkort teksten</translation>
    </message>
    <message>
        <source>write English letters, digits and signs; in a pause&apos;s text no quotes</source>
        <translation>bruk engelske bokstaver, sifre og tegn; ingen anførselstegn i teksten til en pause</translation>
    </message>
    <message numerus="yes">
        <source>{waits} pauses and waits above the part: the arm reaches no place beside it, nothing is primed, and material may drip on the part</source>
        <translation>
            <numerusform>{waits} pause eller venting over delen: armen når ingen plass ved siden av den, ingenting klargjøres, og materiale kan dryppe på delen</numerusform>
            <numerusform>{waits} pauser og ventinger over delen: armen når ingen plass ved siden av den, ingenting klargjøres, og materiale kan dryppe på delen</numerusform>
        </translation>
    </message>
    <message>
        <source>a text is shown without a stop</source>
        <translation>en tekst vises uten stopp</translation>
    </message>
    <message>
        <source>a module that reads G-code has no commands for stops, waits, tools and outputs</source>
        <translation>en modul som leser G-kode har ingen kommandoer for stopp, venting, verktøy og utganger</translation>
    </message>
    <message>
        <source>give the cell a place for purges or a home pose beside the plate, or move the part on the plate</source>
        <translation>gi cellen en spyleplass eller en hvilestilling ved siden av byggeplaten, eller flytt delen på byggeplaten</translation>
    </message>
    <message>
        <source>&apos;Close&apos; is missing behind the text</source>
        <translation>&apos;Close&apos; mangler etter teksten</translation>
    </message>
    <message>
        <source>&apos;Close&apos; without its &apos;Open&apos; before it</source>
        <translation>&apos;Close&apos; uten tilhørende &apos;Open&apos; foran</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;{name}&apos; mellom PVTEnter og PVTExit</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no point of a curve</source>
        <translation>&apos;{part}&apos; er ikke et punkt på en kurve</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement &apos;{text}&apos; {effect}</source>
        <translation>&apos;{word}&apos; i setningen &apos;{text}&apos; {effect}</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement before {place}, &apos;{text}&apos;, {effect}</source>
        <translation>&apos;{word}&apos; i setningen før {place}, &apos;{text}&apos;, {effect}</translation>
    </message>
    <message>
        <source>Across
layers MPa</source>
        <translation>På tvers av
lag MPa</translation>
    </message>
    <message>
        <source>Add a skin</source>
        <translation>Legg til en hud</translation>
    </message>
    <message>
        <source>Along
stress %</source>
        <translation>Langs
spenning %</translation>
    </message>
    <message>
        <source>Break-away columns below overhangs beyond the overhang angle, in mode curved below voxels that growth would miss. A region without them blocks them.</source>
        <translation>Avbrekkbare søyler under overheng utover overhengsvinkelen, i modus curved under voksler som veksten ellers ville miste. En region uten dem blokkerer dem.</translation>
    </message>
    <message>
        <source>Deflec-
tion mm</source>
        <translation>Ned-
bøyning mm</translation>
    </message>
    <message>
        <source>Factor of the speed of the part&apos;s beads, within the flow of the extruder and the speed of bridges.</source>
        <translation>Faktor for hastigheten til delens strenger, innenfor ekstruderens materialstrøm og brohastigheten.</translation>
    </message>
    <message>
        <source>For infill along a field: a direction x,y,z, or x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them. Empty: along the stress between regions that hold the part and regions with a force.</source>
        <translation>For fyll langs et felt: en retning x,y,z, eller x,y,z,dx,dy,dz i mm på byggeplaten, atskilt med mellomrom eller linjeskift, eller en fil med dem. Tomt: langs spenningene mellom regioner som holder delen, og regioner med en kraft.</translation>
    </message>
    <message>
        <source>Force X</source>
        <translation>Kraft X</translation>
    </message>
    <message>
        <source>Force Y</source>
        <translation>Kraft Y</translation>
    </message>
    <message>
        <source>Force Z</source>
        <translation>Kraft Z</translation>
    </message>
    <message>
        <source>Force on the part</source>
        <translation>Kraft på delen</translation>
    </message>
    <message>
        <source>Held under load</source>
        <translation>Holdt fast under last</translation>
    </message>
    <message>
        <source>In a region: closed beads that pass through it begin there, or never do if they can begin elsewhere.</source>
        <translation>I en region: lukkede strenger som går gjennom den, begynner der, eller aldri hvis de kan begynne et annet sted.</translation>
    </message>
    <message>
        <source>In flat layers the region reaches half of it into the part around it, in every other layer the part reaches as far into the region, so that both hold each other.</source>
        <translation>I flate lag går regionen halve verdien inn i delen rundt; i annethvert lag går delen like langt inn i regionen, så de holder hverandre fast.</translation>
    </message>
    <message>
        <source>Region {number}</source>
        <translation>Region {number}</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements, which nothing checks.</source>
        <translation>Trygt å kjøre, bortsett fra egne setninger, som ingenting kontrollerer.</translation>
    </message>
    <message>
        <source>Three curved layers along the upper surface, over the flat ones</source>
        <translation>Tre krumme lag langs den øvre overflaten, over de flate</translation>
    </message>
    <message>
        <source>What happens before layers of the part, separated by semicolons. Each begins with a layer (12) or a height in mm (z5.5): 12 pause TEXT; 20 wait SECONDS; 30 output NUMBER on; 35 photo OUTPUT SECONDS; 40 tool NUMBER; 50 statement FORMAT LINE.</source>
        <translation>Det som skjer før lag i delen, atskilt med semikolon. Hvert begynner med et lag (12) eller en høyde i mm (z5.5): 12 pause TEKST; 20 wait SEKUNDER; 30 output NUMMER on; 35 photo UTGANG SEKUNDER; 40 tool NUMMER; 50 statement FORMAT LINJE.</translation>
    </message>
    <message>
        <source>a line for a wait differs from the line before in its last number</source>
        <translation>en linje for venting skiller seg fra linjen før i det siste tallet</translation>
    </message>
    <message>
        <source>a region with a force contains nothing of the part that is held</source>
        <translation>en region med en kraft inneholder ingenting av delen som holdes fast</translation>
    </message>
    <message>
        <source>a skin of layers along the surface has none</source>
        <translation>en hud av lag langs overflaten har ingen</translation>
    </message>
    <message>
        <source>a statement of your own sets &apos;{name}&apos;, which the program uses itself</source>
        <translation>en egen setning setter &apos;{name}&apos;, som programmet selv bruker</translation>
    </message>
    <message>
        <source>add a second region of that shape for its settings</source>
        <translation>legg til en region til med samme form for innstillingene</translation>
    </message>
    <message>
        <source>along a field</source>
        <translation>langs et felt</translation>
    </message>
    <message>
        <source>always</source>
        <translation>alltid</translation>
    </message>
    <message>
        <source>changes a temperature</source>
        <translation>endrer en temperatur</translation>
    </message>
    <message>
        <source>changes the extruder</source>
        <translation>endrer ekstruderen</translation>
    </message>
    <message>
        <source>changes the order of the program&apos;s lines</source>
        <translation>endrer rekkefølgen på programmets linjer</translation>
    </message>
    <message>
        <source>changes the origin, the tool or the units</source>
        <translation>endrer origo, verktøyet eller enhetene</translation>
    </message>
    <message>
        <source>deflection under the forces</source>
        <translation>nedbøyning under kreftene</translation>
    </message>
    <message>
        <source>field of the infill</source>
        <translation>felt for fyllet</translation>
    </message>
    <message>
        <source>found no equilibrium of the part under its load</source>
        <translation>fant ingen likevekt for delen under lasten</translation>
    </message>
    <message>
        <source>from the file: {event} at a height of {height}</source>
        <translation>fra filen: {event} i en høyde på {height}</translation>
    </message>
    <message>
        <source>give a direction x,y,z or samples x,y,z,dx,dy,dz, or the part regions that hold it and regions with a force</source>
        <translation>oppgi en retning x,y,z eller punkter x,y,z,dx,dy,dz, eller gi delen regioner som holder den, og regioner med en kraft</translation>
    </message>
    <message>
        <source>give a region where the part is fixed the use &apos;hold&apos;</source>
        <translation>gi en region der delen er festet, bruken &apos;hold&apos;</translation>
    </message>
    <message>
        <source>give it as a skin or a painted surface, or use it for settings</source>
        <translation>oppgi den som hud eller malt overflate, eller bruk den til innstillinger</translation>
    </message>
    <message>
        <source>give, for example, 12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript LINE</source>
        <translation>oppgi for eksempel 12 pause; 20 pause Legg inn mutteren; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript LINJE</translation>
    </message>
    <message>
        <source>hold the part in more places</source>
        <translation>hold delen fast på flere steder</translation>
    </message>
    <message>
        <source>infill along the stress</source>
        <translation>fyll langs spenningene</translation>
    </message>
    <message>
        <source>interlock of a region</source>
        <translation>sammenlåsing av en region</translation>
    </message>
    <message>
        <source>is above &apos;alongMPa&apos;</source>
        <translation>er over &apos;alongMPa&apos;</translation>
    </message>
    <message>
        <source>is above {limit}</source>
        <translation>er over {limit}</translation>
    </message>
    <message>
        <source>leave it out: the plan moves the arm</source>
        <translation>utelat den: det er planen som beveger armen</translation>
    </message>
    <message>
        <source>machine {machine} is {verdict}: {reason}</source>
        <translation>maskin {machine} er {verdict}: {reason}</translation>
    </message>
    <message>
        <source>move it into the part, paint it, or remove it</source>
        <translation>flytt den inn i delen, mal den, eller fjern den</translation>
    </message>
    <message>
        <source>move it onto the part, or make it larger</source>
        <translation>flytt den inn på delen, eller gjør den større</translation>
    </message>
    <message>
        <source>move them onto the part, or make them larger</source>
        <translation>flytt dem inn på delen, eller gjør dem større</translation>
    </message>
    <message>
        <source>moves the arm, or changes how it moves</source>
        <translation>beveger armen, eller endrer hvordan den beveger seg</translation>
    </message>
    <message>
        <source>never</source>
        <translation>aldri</translation>
    </message>
    <message numerus="yes">
        <source>not used, as it is damaged: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, {where})</source>
        <translation>
            <numerusform>ikke brukt, fordi det er skadet: {paint} på {count} trekant i &apos;{object}&apos; ({attribute}, {where})</numerusform>
            <numerusform>ikke brukt, fordi det er skadet: {paint} på {count} trekanter i &apos;{object}&apos; ({attribute}, {where})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops behind the last bead, where the print is done</source>
        <translation>
            <numerusform>ikke brukt: {count} stopp etter den siste strengen, der utskriften er ferdig</numerusform>
            <numerusform>ikke brukt: {count} stopp etter den siste strengen, der utskriften er ferdig</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} in the file: the part ends at {top}</source>
        <translation>ikke brukt: {event} i en høyde på {height} i filen: delen slutter ved {top}</translation>
    </message>
    <message>
        <source>nothing of the part is within the regions that hold it</source>
        <translation>ingenting av delen er innenfor regionene som holder den</translation>
    </message>
    <message>
        <source>paint whole faces</source>
        <translation>mal hele flater</translation>
    </message>
    <message>
        <source>put it into a routine on the controller, and call that</source>
        <translation>legg den i en rutine på styringen, og kall rutinen</translation>
    </message>
    <message>
        <source>region {region} asks for supports, which mode {mode} does not have</source>
        <translation>region {region} ber om støtte, som modus {mode} ikke har</translation>
    </message>
    <message>
        <source>region {region} asks for supports: its own layers have none</source>
        <translation>region {region} ber om støtte: dens egne lag har ingen</translation>
    </message>
    <message>
        <source>region {region} carries the load: it has no settings</source>
        <translation>region {region} bærer lasten: den har ingen innstillinger</translation>
    </message>
    <message>
        <source>region {region} is outside the part, behind later regions, or not painted: it has no effect</source>
        <translation>region {region} ligger utenfor delen, bak senere regioner, eller er ikke malt: den har ingen virkning</translation>
    </message>
    <message>
        <source>region {region}: half of no face of the part is painted</source>
        <translation>region {region}: ingen flate på delen er malt til minst halvparten</translation>
    </message>
    <message>
        <source>safe to run but for its own statements, which nothing checks</source>
        <translation>trygg å kjøre, bortsett fra dens egne setninger, som ingenting kontrollerer</translation>
    </message>
    <message>
        <source>safe to run, but does not print its part as asked</source>
        <translation>trygg å kjøre, men printer ikke delen sin som ønsket</translation>
    </message>
    <message>
        <source>seam here</source>
        <translation>søm her</translation>
    </message>
    <message>
        <source>set `supports=none` for the region, or choose another mode</source>
        <translation>sett `supports=none` for regionen, eller velg en annen modus</translation>
    </message>
    <message>
        <source>set it in the cell before the program starts</source>
        <translation>angi det i cellen før programmet starter</translation>
    </message>
    <message>
        <source>set it in the process</source>
        <translation>angi det i prosessen</translation>
    </message>
    <message>
        <source>set the temperatures of the material</source>
        <translation>angi materialets temperaturer</translation>
    </message>
    <message>
        <source>sets an output</source>
        <translation>setter en utgang</translation>
    </message>
    <message>
        <source>speed factor</source>
        <translation>hastighetsfaktor</translation>
    </message>
    <message>
        <source>stops or ends the program</source>
        <translation>stopper eller avslutter programmet</translation>
    </message>
    <message>
        <source>tension across layers</source>
        <translation>strekk på tvers av lagene</translation>
    </message>
    <message>
        <source>there are regions with a force, but none that holds the part</source>
        <translation>det finnes regioner med en kraft, men ingen som holder delen</translation>
    </message>
    <message>
        <source>there is no field of directions for the infill</source>
        <translation>det finnes ikke noe retningsfelt for fyllet</translation>
    </message>
    <message>
        <source>under all overhangs</source>
        <translation>under alle overheng</translation>
    </message>
    <message>
        <source>use another name</source>
        <translation>bruk et annet navn</translation>
    </message>
    <message>
        <source>{share:.0f} of the surface are gentle slopes with steps of {mean:.2g} on average</source>
        <translation>{share:.0f} av overflaten er slake skråninger med trinn på {mean:.2g} i snitt</translation>
    </message>
    <message>
        <source>a force acts only where the part is held</source>
        <translation>en kraft virker bare der delen holdes</translation>
    </message>
    <message>
        <source>infill across the stress</source>
        <translation>fyll på tvers av spenningen</translation>
    </message>
    <message>
        <source>may do anything: Voluta does not know it</source>
        <translation>kan gjøre hva som helst: Voluta kjenner det ikke</translation>
    </message>
    <message>
        <source>move the region with the force away from the one that holds</source>
        <translation>flytt området med kraften bort fra det som holder</translation>
    </message>
    <message>
        <source>the flow is not 0 while the extruder is off</source>
        <translation>strømmen er ikke 0 mens ekstruderen er av</translation>
    </message>
    <message>
        <source>the part has no volume to be loaded</source>
        <translation>delen har ikke noe volum som kan belastes</translation>
    </message>
    <message>
        <source>use a region of its own for the supports, whose use is settings</source>
        <translation>bruk et eget område for støttene, med bruken innstillinger</translation>
    </message>
    <message>
        <source>use an event for it, for example 12 pause Put in the nut</source>
        <translation>bruk en hendelse, for eksempel 12 pause Put in the nut</translation>
    </message>
    <message>
        <source>use an event for it, for example 30 output 3 on</source>
        <translation>bruk en hendelse, for eksempel 30 output 3 on</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no direction</source>
        <translation>&apos;{text}&apos; er ikke en retning</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} &apos;{word}&apos; is not a number</source>
        <translation>&apos;{text}&apos;: {field} &apos;{word}&apos; er ikke et tall</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} is no whole number</source>
        <translation>&apos;{text}&apos;: {field} er ikke et heltall</translation>
    </message>
    <message>
        <source>Before layer (0: automatic)</source>
        <translation>Før lag (0: automatisk)</translation>
    </message>
    <message>
        <source>Inserted part</source>
        <translation>Innsats</translation>
    </message>
    <message>
        <source>Searches for a better orientation of the part: with the smallest overhanging area, with the fewest voxels missed by growth, along the axes, so that the projections on XY and XZ leave the least area of their bounding rectangles empty (blanks for milling), with the smallest overhanging area after the part is cut into pieces (mode planar), or with the least tension across the layers under the load of its regions.</source>
        <translation>Søker etter en bedre orientering av delen: med minst overhengende areal, med færrest voksler tapt i veksten, langs aksene, slik at projeksjonene på XY og XZ etterlater minst tomt areal i de omsluttende rektanglene (emner for fresing), med minst overhengende areal etter at delen er kuttet i stykker (modus planar), eller med minst strekk på tvers av lagene under lasten fra regionene.</translation>
    </message>
    <message>
        <source>`orient=leastTension` needs a region that pushes the part</source>
        <translation>`orient=leastTension` trenger en region som skyver på delen</translation>
    </message>
    <message>
        <source>add a statement for {format} at that place, or use {formats}</source>
        <translation>legg til en setning for {format} på det stedet, eller bruk {formats}</translation>
    </message>
    <message>
        <source>beads lie above its place before the print pauses</source>
        <translation>strenger ligger over plassen dens før utskriften tar pause</translation>
    </message>
    <message>
        <source>beads lie in its place</source>
        <translation>strenger ligger på plassen dens</translation>
    </message>
    <message>
        <source>figures</source>
        <translation>tallene</translation>
    </message>
    <message>
        <source>found no equilibrium of the beads</source>
        <translation>fant ingen likevekt for strengene</translation>
    </message>
    <message>
        <source>give forces that do not cancel each other</source>
        <translation>oppgi krefter som ikke opphever hverandre</translation>
    </message>
    <message>
        <source>give regions with the uses &apos;hold&apos; and &apos;load&apos;</source>
        <translation>oppgi regioner med brukene &apos;hold&apos; og &apos;load&apos;</translation>
    </message>
    <message>
        <source>give three numbers, x,y,z, of which one is not 0</source>
        <translation>oppgi tre tall, x,y,z, der ett ikke er 0</translation>
    </message>
    <message>
        <source>inserted part</source>
        <translation>innsats</translation>
    </message>
    <message>
        <source>it is narrower than half a bead of {width}</source>
        <translation>den er smalere enn en halv streng på {width}</translation>
    </message>
    <message>
        <source>it is too thin for a layer of its own</source>
        <translation>den er for tynn til et eget lag</translation>
    </message>
    <message>
        <source>it is too thin to meet a layer</source>
        <translation>den er for tynn til å treffe et lag</translation>
    </message>
    <message>
        <source>it stands above the first layer after it, so the head keeps away from it</source>
        <translation>den rager over det første laget etter den, så hodet holder seg unna den</translation>
    </message>
    <message>
        <source>its interlock of {width} reaches through it in {crossed} of {layers} layers</source>
        <translation>sammenlåsingen på {width} når tvers gjennom den i {crossed} av {layers} lag</translation>
    </message>
    <message>
        <source>later regions hold in all of it</source>
        <translation>senere regioner gjelder overalt i den</translation>
    </message>
    <message>
        <source>layers along given planes have no supports: those asked for are left out</source>
        <translation>lag langs gitte plan har ingen støtter: de som er bedt om, utelates</translation>
    </message>
    <message>
        <source>least tension across layers</source>
        <translation>minst strekk på tvers av lagene</translation>
    </message>
    <message>
        <source>make it larger, or the layers thinner</source>
        <translation>gjør den større, eller lagene tynnere</translation>
    </message>
    <message>
        <source>make it wider, or use a finer nozzle</source>
        <translation>gjør den bredere, eller bruk en finere dyse</translation>
    </message>
    <message>
        <source>material {material} states no elasticity</source>
        <translation>materialet {material} angir ingen elastisitet</translation>
    </message>
    <message>
        <source>move it down the list of regions</source>
        <translation>flytt den ned i listen over regioner</translation>
    </message>
    <message>
        <source>no bead is under stress</source>
        <translation>ingen streng er under spenning</translation>
    </message>
    <message>
        <source>no effect of region {region}: {reason}</source>
        <translation>region {region} har ingen virkning: {reason}</translation>
    </message>
    <message>
        <source>nothing is below it when the print pauses</source>
        <translation>ingenting er under den når utskriften tar pause</translation>
    </message>
    <message>
        <source>nothing is printed after it: the print does not pause for it</source>
        <translation>ingenting skrives ut etter den: utskriften tar ikke pause for den</translation>
    </message>
    <message>
        <source>remove `layerPlanes`, or set `supports=none`</source>
        <translation>fjern `layerPlanes`, eller sett `supports=none`</translation>
    </message>
    <message>
        <source>run it on the controller if the rest needs it</source>
        <translation>kjør den på styringen hvis resten trenger den</translation>
    </message>
    <message>
        <source>set a smaller `interlockMm`, or make the region larger</source>
        <translation>sett en mindre `interlockMm`, eller gjør regionen større</translation>
    </message>
    <message>
        <source>stiffness and tensions</source>
        <translation>stivhet og strekk</translation>
    </message>
    <message>
        <source>tape {process} or the plastic around it states no elasticity</source>
        <translation>tapen {process} eller plasten rundt den angir ingen elastisitet</translation>
    </message>
    <message numerus="yes">
        <source>the field is perpendicular to {patches} patches of the layers, filled with straight lines</source>
        <translation>
            <numerusform>feltet står vinkelrett på {patches} lagflate, som fylles med rette linjer</numerusform>
            <numerusform>feltet står vinkelrett på {patches} lagflater, som fylles med rette linjer</numerusform>
        </translation>
    </message>
    <message>
        <source>the infill is not along a field</source>
        <translation>fyllet går ikke langs et felt</translation>
    </message>
    <message>
        <source>the infill of region {region} is not along a field</source>
        <translation>fyllet i region {region} går ikke langs et felt</translation>
    </message>
    <message>
        <source>the inserted part {insert} does not fit: {reason}</source>
        <translation>innsatsen {insert} passer ikke: {reason}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): tension across its layers {tension:.2g} MPa instead of {tensionBefore:.2g}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>delen ble rotert {angle:.0f} om ({x}, {y}, {z}): strekk på tvers av lagene {tension:.2g} MPa i stedet for {tensionBefore:.2g}, overheng {overhang:.0f} i stedet for {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the rest does not run your statement before its beginning: {statement}</source>
        <translation>resten kjører ikke setningen din fra før den begynner: {statement}</translation>
    </message>
    <message>
        <source>turn the part, or choose another field or infill</source>
        <translation>roter delen, eller velg et annet felt eller fyll</translation>
    </message>
    <message>
        <source>turn the part, or let the region have supports if the overhang sags</source>
        <translation>roter delen, eller la regionen få støtter hvis overhenget siger</translation>
    </message>
    <message>
        <source>unknown {figures} under the forces: {reason}</source>
        <translation>{figures} under kreftene er ukjente: {reason}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle} where regions block supports; here is most of it</source>
        <translation>{area:.3g} henger over med mer enn {angle} der regioner blokkerer støtter; det meste er her</translation>
    </message>
    <message>
        <source>give the material its elasticity</source>
        <translation>oppgi materialets elastisitet</translation>
    </message>
    <message>
        <source>give the modulus and the share of its fibres, and the elasticity of the plastic</source>
        <translation>oppgi modulen og andelen for fibrene, og plastens elastisitet</translation>
    </message>
    <message>
        <source>it is thinner than a layer, which leaves no room for it</source>
        <translation>den er tynnere enn et lag, som ikke gir den plass</translation>
    </message>
    <message>
        <source>it reaches below the plate</source>
        <translation>den når under platen</translation>
    </message>
    <message>
        <source>it takes the place of {other}</source>
        <translation>den tar plassen til {other}</translation>
    </message>
    <message>
        <source>move its region on the Prepare page</source>
        <translation>flytt regionen dens på siden Klargjør</translation>
    </message>
    <message>
        <source>move its region, or choose the layer before which it is put in</source>
        <translation>flytt regionen dens, eller velg laget den legges inn før</translation>
    </message>
    <message>
        <source>no effect of {key}: {reason}</source>
        <translation>{key} har ingen virkning: {reason}</translation>
    </message>
    <message>
        <source>set `infill=field`, or remove the field</source>
        <translation>sett `infill=field`, eller fjern feltet</translation>
    </message>
</context>
<context>
    <name>EventMarks</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause: %1</source>
        <translation>Pause: %1</translation>
    </message>
    <message>
        <source>Wait: %1 s</source>
        <translation>Vent: %1 s</translation>
    </message>
    <message>
        <source>Output %1 on</source>
        <translation>Utgang %1 på</translation>
    </message>
    <message>
        <source>Output %1 off</source>
        <translation>Utgang %1 av</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Verktøy %1</translation>
    </message>
    <message>
        <source>Before layer %1: %2</source>
        <translation>Før lag %1: %2</translation>
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
        <translation>Radius på dysespissen</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>Kjeglevinkel</translation>
    </message>
    <message>
        <source>Cone height</source>
        <translation>Kjeglehøyde</translation>
    </message>
    <message>
        <source>Block width</source>
        <translation>Blokkbredde</translation>
    </message>
    <message>
        <source>Block height</source>
        <translation>Blokkhøyde</translation>
    </message>
</context>
<context>
    <name>LayerEvents</name>
    <message>
        <source>The next plan pauses before layer %1.</source>
        <translation>Neste plan tar pause før lag %1.</translation>
    </message>
    <message>
        <source>The next plan does not pause before layer %1.</source>
        <translation>Neste plan tar ikke pause før lag %1.</translation>
    </message>
    <message>
        <source>The next plan has the event before layer %1.</source>
        <translation>Neste plan har hendelsen før lag %1.</translation>
    </message>
</context>
<context>
    <name>LegendFigures</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Travel and waits</source>
        <translation>Forflytning og venting</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>Alle innstillinger</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>innstilling</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>betydning</translation>
    </message>
    <message>
        <source>range</source>
        <translation>område</translation>
    </message>
    <message>
        <source>default</source>
        <translation>standard</translation>
    </message>
    <message>
        <source>key</source>
        <translation>nøkkel</translation>
    </message>
    <message>
        <source>All findings</source>
        <translation>Alle funn</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>funn</translation>
    </message>
    <message>
        <source>what would help</source>
        <translation>hva som hjelper</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Innhold</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>Algoritmer</translation>
    </message>
</context>
<context>
    <name>MillForm</name>
    <message>
        <source>Cutter diameter</source>
        <translation>Fresdiameter</translation>
    </message>
    <message>
        <source>The cutter has a round end</source>
        <translation>Fresen har rund ende</translation>
    </message>
    <message>
        <source>0: side load of the material; less leaves lower ridges</source>
        <translation>0: materialets sidesteg; mindre gir lavere rygger</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>etter materiale</translation>
    </message>
    <message>
        <source>Roughing depth</source>
        <translation>Grovfresdybde</translation>
    </message>
    <message>
        <source>Depth of one pass that stays above the part</source>
        <translation>Dybden på ett pass som blir over delen</translation>
    </message>
    <message>
        <source>Across the lines; more than the cutter&apos;s diameter</source>
        <translation>På tvers av linjene; mer enn fresens diameter</translation>
    </message>
    <message>
        <source>Along the lines, with the ends that hold the block; more than the cutter&apos;s diameter</source>
        <translation>Langs linjene, med endene som holder emnet; mer enn fresens diameter</translation>
    </message>
    <message>
        <source>Thickness that is milled away over the whole part</source>
        <translation>Tykkelsen som freses bort over hele delen</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Klaring</translation>
    </message>
    <message>
        <source>Height of rapid moves above the block</source>
        <translation>Høyden på ilgang over emnet</translation>
    </message>
    <message>
        <source>Of the contour, at the part&apos;s lower end along y; cut by hand</source>
        <translation>Av konturen, ved delens nedre ende langs y; kappes for hånd</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Sideskritt</translation>
    </message>
    <message>
        <source>Stock beyond the part, y</source>
        <translation>Emne utenfor delen, y</translation>
    </message>
    <message>
        <source>Stock beyond the part, x</source>
        <translation>Emne utenfor delen, x</translation>
    </message>
    <message>
        <source>Stock above and below</source>
        <translation>Emne over og under</translation>
    </message>
    <message>
        <source>Holding tab</source>
        <translation>Holdetapp</translation>
    </message>
</context>
<context>
    <name>MillPicture</name>
    <message>
        <source>Block</source>
        <translation>Emne</translation>
    </message>
    <message>
        <source>Rapid moves</source>
        <translation>Ilgang</translation>
    </message>
    <message>
        <source>Side A, roughing</source>
        <translation>Side A, grovfresing</translation>
    </message>
    <message>
        <source>Side A, finishing</source>
        <translation>Side A, finfresing</translation>
    </message>
    <message>
        <source>Side B, roughing</source>
        <translation>Side B, grovfresing</translation>
    </message>
    <message>
        <source>Side B, finishing</source>
        <translation>Side B, finfresing</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
</context>
<context>
    <name>ModeSwitch</name>
    <message>
        <source>This way of building does not support that platform.</source>
        <translation>Denne byggemåten støtter ikke den plattformen.</translation>
    </message>
    <message>
        <source>This way of building places the part itself: the search for an orientation does not apply.</source>
        <translation>Denne byggemåten plasserer delen selv: søket etter orientering gjelder ikke.</translation>
    </message>
    <message>
        <source>This way of building needs the scale as a number.</source>
        <translation>Denne byggemåten trenger skalaen som et tall.</translation>
    </message>
    <message>
        <source>The platform file %1 is missing.</source>
        <translation>Plattformfilen %1 mangler.</translation>
    </message>
    <message>
        <source>This way of building needs a cell with a rotating rod.</source>
        <translation>Denne byggemåten trenger en celle med roterende stang.</translation>
    </message>
    <message>
        <source>This cell rotates a rod: this way of building needs one with a plate.</source>
        <translation>Denne cellen roterer en stang: denne byggemåten trenger en med byggeplate.</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>on</source>
        <translation>på</translation>
    </message>
    <message>
        <source>off</source>
        <translation>av</translation>
    </message>
    <message>
        <source>Range: %1 to %2</source>
        <translation>Område: %1 til %2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Standard: %1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Nøkkel: %1</translation>
    </message>
</context>
<context>
    <name>PresetBar</name>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Lagre</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Lagre &amp;som…</translation>
    </message>
    <message>
        <source>D&amp;iscard changes</source>
        <translation>For&amp;kast endringer</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>Gi nytt &amp;navn…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Slett…</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>Sa&amp;mmenlign med…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Eksporter…</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>&amp;Importer…</translation>
    </message>
</context>
<context>
    <name>Quote</name>
    <message>
        <source>Quote: %1</source>
        <translation>Tilbud: %1</translation>
    </message>
    <message>
        <source>Price: %1</source>
        <translation>Pris: %1</translation>
    </message>
    <message>
        <source>printed in %1, %2 g of material</source>
        <translation>skrevet ut på %1, %2 g materiale</translation>
    </message>
    <message>
        <source>The price of a material is missing.</source>
        <translation>Prisen på et materiale mangler.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Størrelse</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>%1, %2 g at %3 per kg: %4</source>
        <translation>%1, %2 g à %3 per kg: %4</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maskin</translation>
    </message>
    <message>
        <source>%1 at %2 per hour: %3</source>
        <translation>%1 à %2 per time: %3</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Oppsett</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Påslag</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>Pris</translation>
    </message>
</context>
<context>
    <name>Resume</name>
    <message>
        <source>Bead %1 of %2</source>
        <translation>Streng %1 av %2</translation>
    </message>
</context>
<context>
    <name>SettingWords</name>
    <message>
        <source>quality, resolution, thickness, fine, coarse, detail</source>
        <translation>kvalitet, oppløsning, tykkelse, fin, grov, detalj, quality, resolution</translation>
    </message>
    <message>
        <source>line width, extrusion width, nozzle, bead</source>
        <translation>linjebredde, ekstruderingsbredde, dyse, streng, line width, extrusion width</translation>
    </message>
    <message>
        <source>first layer, adhesion, line width, extrusion width</source>
        <translation>første lag, feste, heft, linjebredde, ekstruderingsbredde, first layer, line width</translation>
    </message>
    <message>
        <source>retract, ooze, stringing, oozing</source>
        <translation>tilbaketrekking, retract, siving, tråder, stringing, oozing</translation>
    </message>
    <message>
        <source>resolution, point distance, segment length</source>
        <translation>oppløsning, punktavstand, segmentlengde, resolution</translation>
    </message>
    <message>
        <source>perimeter, perimeters, shell, shells, outline, contour, strength</source>
        <translation>perimeter, perimetre, skall, omriss, kontur, styrke, shell, outline, wall</translation>
    </message>
    <message>
        <source>fill, pattern, solid, interior</source>
        <translation>fyll, infill, mønster, massiv, indre</translation>
    </message>
    <message>
        <source>fill, percent, solid, hollow, strength, interior</source>
        <translation>fyll, infill, prosent, massiv, hul, styrke, indre</translation>
    </message>
    <message>
        <source>fill, infill, gyroid, honeycomb, grid</source>
        <translation>fyll, infill, gyroide, gyroid, bikake, honeycomb, rutenett, grid</translation>
    </message>
    <message>
        <source>roof, skin, top surface, shell</source>
        <translation>tak, hud, toppflate, skall, skin, top surface, shell</translation>
    </message>
    <message>
        <source>floor, skin, bottom surface, shell</source>
        <translation>gulv, bunn, hud, bunnflate, skall, skin, bottom surface, shell</translation>
    </message>
    <message>
        <source>roof, floor, top, bottom, shell</source>
        <translation>tak, gulv, topp, bunn, skall, top, bottom, shell</translation>
    </message>
    <message>
        <source>orientation, rotation</source>
        <translation>orientering, rotasjon</translation>
    </message>
    <message>
        <source>overhang, support, support material, bridge, hanging</source>
        <translation>overheng, støtte, støttemateriale, bro, hengende, overhang, support, bridge</translation>
    </message>
    <message>
        <source>overhang, support material, hanging, edge</source>
        <translation>overheng, støttemateriale, hengende, kant, overhang, support</translation>
    </message>
    <message>
        <source>support, bridge, hanging, tilt</source>
        <translation>støtte, bro, hengende, tilt, support, bridge</translation>
    </message>
    <message>
        <source>skirt, purge, priming, start line, prime line</source>
        <translation>skjørt, skirt, spyling, purge, priming, startlinje, primelinje, prime line</translation>
    </message>
    <message>
        <source>skirt, purge, start line</source>
        <translation>skjørt, skirt, spyling, purge, startlinje</translation>
    </message>
    <message>
        <source>adhesion, skirt, raft, warping, lifting, bed</source>
        <translation>feste, heft, skjørt, skirt, brim, raft, flåte, vridning, warping, løfting, byggeplate, bed</translation>
    </message>
    <message>
        <source>zipper, start point, z seam, scar</source>
        <translation>glidelås, startpunkt, z-søm, z seam, arr</translation>
    </message>
    <message>
        <source>thin, narrow, detail</source>
        <translation>tynn, smal, detalj</translation>
    </message>
    <message>
        <source>vase, spiralize, continuous</source>
        <translation>vase, spiral, spiralize, sammenhengende</translation>
    </message>
    <message>
        <source>vase</source>
        <translation>vase</translation>
    </message>
    <message>
        <source>cooling, fan, temperature, overheating</source>
        <translation>kjøling, vifte, temperatur, overoppheting, cooling, fan</translation>
    </message>
    <message>
        <source>cooling, temperature, fan, pause, wait, overheating</source>
        <translation>kjøling, temperatur, vifte, pause, venting, overoppheting, cooling, fan</translation>
    </message>
    <message>
        <source>temperature, adhesion, cold joint, interlayer</source>
        <translation>temperatur, feste, heft, kald skjøt, mellom lag, interlayer</translation>
    </message>
    <message>
        <source>strength, force, stress</source>
        <translation>styrke, kraft, spenning</translation>
    </message>
    <message>
        <source>perimeter, feed rate, velocity</source>
        <translation>perimeter, mating, hastighet, fart, feed rate</translation>
    </message>
    <message>
        <source>fill, feed rate, velocity</source>
        <translation>fyll, infill, mating, hastighet, fart, feed rate</translation>
    </message>
    <message>
        <source>overhang, feed rate, velocity</source>
        <translation>overheng, mating, hastighet, fart, overhang, feed rate</translation>
    </message>
    <message>
        <source>adhesion, feed rate, velocity, bed</source>
        <translation>feste, heft, mating, hastighet, byggeplate, bed, feed rate</translation>
    </message>
    <message>
        <source>z hop, travel, retract, hop</source>
        <translation>z-hopp, z hop, tomkjøring, travel, tilbaketrekking, retract, hopp</translation>
    </message>
    <message>
        <source>stringing, ooze, seam</source>
        <translation>tråder, stringing, siving, ooze, søm, seam</translation>
    </message>
    <message>
        <source>tool orientation, spin</source>
        <translation>verktøyorientering, rotasjon, spinn</translation>
    </message>
    <message>
        <source>tool orientation, angle</source>
        <translation>verktøyorientering, vinkel</translation>
    </message>
    <message>
        <source>collision, distance, safety, robot</source>
        <translation>kollisjon, avstand, sikkerhet, robot</translation>
    </message>
    <message>
        <source>collision, distance, safety, nozzle</source>
        <translation>kollisjon, avstand, sikkerhet, dyse</translation>
    </message>
    <message>
        <source>collision, check</source>
        <translation>kollisjon, kontroll, sjekk</translation>
    </message>
    <message>
        <source>configuration, flip, elbow, wrist</source>
        <translation>konfigurasjon, flip, albue, håndledd</translation>
    </message>
    <message>
        <source>acceleration, vibration, smooth</source>
        <translation>akselerasjon, vibrasjon, jevn, glatt</translation>
    </message>
    <message>
        <source>rotate, orientation, auto orient, lay flat</source>
        <translation>roter, orientering, automatisk orientering, legg flatt, auto orient</translation>
    </message>
    <message>
        <source>repair, hole, mesh, thin, shell</source>
        <translation>reparer, reparasjon, hull, mesh, tynn, skall</translation>
    </message>
    <message>
        <source>variable layer height, quality</source>
        <translation>variabel laghøyde, kvalitet, variable layer height</translation>
    </message>
    <message>
        <source>variable layer height, quality, adaptive</source>
        <translation>variabel laghøyde, kvalitet, adaptiv, variable layer height</translation>
    </message>
    <message>
        <source>extruder, nozzle, multi material, head</source>
        <translation>ekstruder, dyse, flermateriale, multi material, hode</translation>
    </message>
    <message>
        <source>extruder, multi material, soluble</source>
        <translation>ekstruder, flermateriale, multi material, løselig</translation>
    </message>
    <message>
        <source>extruder, multi material, fill</source>
        <translation>ekstruder, flermateriale, multi material, fyll, infill</translation>
    </message>
    <message>
        <source>extruder, multi material</source>
        <translation>ekstruder, flermateriale, multi material</translation>
    </message>
    <message>
        <source>tool change, wipe tower, multi material, colour change</source>
        <translation>verktøybytte, tool change, avstrykstårn, wipe tower, flermateriale, fargebytte</translation>
    </message>
    <message>
        <source>carbon, continuous fibre, reinforcement, strength</source>
        <translation>karbon, kontinuerlig fiber, armering, styrke</translation>
    </message>
    <message>
        <source>resolution, grid</source>
        <translation>oppløsning, rutenett, grid</translation>
    </message>
    <message>
        <source>split program, memory</source>
        <translation>del program, minne</translation>
    </message>
    <message>
        <source>simplify, tolerance</source>
        <translation>forenkle, toleranse</translation>
    </message>
    <message>
        <source>G2, G3, circle</source>
        <translation>G2, G3, sirkel, bue</translation>
    </message>
    <message>
        <source>tolerance, strict, draft</source>
        <translation>toleranse, strikt, streng, utkast</translation>
    </message>
    <message>
        <source>strategy, slicing, non-planar, way of building</source>
        <translation>strategi, slicing, ikke-plan, non-planar, byggemåte</translation>
    </message>
    <message>
        <source>plate, bed, build plate, table, rod</source>
        <translation>plate, byggeplate, bed, bord, stang</translation>
    </message>
    <message>
        <source>robot, arm, machine, printer, nozzle, head</source>
        <translation>robot, arm, maskin, printer, dyse, hode</translation>
    </message>
    <message>
        <source>nozzle, tool, extruder, speed, feed rate, bead, head, temperature</source>
        <translation>dyse, verktøy, ekstruder, hastighet, mating, feed rate, streng, hode, temperatur</translation>
    </message>
    <message>
        <source>temperature, filament, plastic, heat, hot end, bed, fan, cooling, price, cost, flow, retraction</source>
        <translation>temperatur, filament, plast, varme, hot end, byggeplate, bed, vifte, kjøling, pris, kostnad, materialstrøm, flow, tilbaketrekking, retraction</translation>
    </message>
    <message>
        <source>tool, second nozzle, extruder, multi material, tool change, colour</source>
        <translation>verktøy, andre dyse, ekstruder, flermateriale, multi material, verktøybytte, farge</translation>
    </message>
    <message>
        <source>scheme, curved, algorithm</source>
        <translation>metode, krum, algoritme</translation>
    </message>
    <message>
        <source>random, repeatable</source>
        <translation>tilfeldig, repeterbar</translation>
    </message>
    <message>
        <source>as process</source>
        <translation>som prosessen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>no brim</source>
        <translation>ingen brem</translation>
    </message>
    <message>
        <source>as the part</source>
        <translation>som delen</translation>
    </message>
    <message>
        <source>no tapes</source>
        <translation>ingen tape</translation>
    </message>
    <message>
        <source>all that fit</source>
        <translation>alle som får plass</translation>
    </message>
    <message>
        <source>only waits</source>
        <translation>venter bare</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>ingen grense</translation>
    </message>
    <message>
        <source>one bead</source>
        <translation>én streng</translation>
    </message>
    <message>
        <source>never</source>
        <translation>aldri</translation>
    </message>
    <message>
        <source>as format</source>
        <translation>som formatet</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisk</translation>
    </message>
    <message>
        <source>pause, stop, colour change, insert, M600</source>
        <translation>pause, stopp, fargebytte, innsats, M600</translation>
    </message>
</context>
<context>
    <name>SizesDialog</name>
    <message>
        <source>Length</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Slot length</source>
        <translation>Sporlengde</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>Sporbredde</translation>
    </message>
    <message>
        <source>Hole diameter</source>
        <translation>Hulldiameter</translation>
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
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>This character is not possible here. Enter a number: %1.</source>
        <translation>Dette tegnet er ikke mulig her. Skriv inn et tall: %1.</translation>
    </message>
    <message>
        <source>%1 is not possible here: %2 is used. Range: %3.</source>
        <translation>%1 er ikke mulig her: %2 brukes. Område: %3.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>endring av %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>tilbakestilling av %1</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>tilbakestilling av alle parametere</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>skalering av delen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>åpning av %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>tillegg av %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>duplisering av %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>fjerning av %1</translation>
    </message>
    <message>
        <source>Change print order</source>
        <translation>endring av printrekkefølge</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>ordning av deler</translation>
    </message>
    <message>
        <source>Paste %1 parts</source>
        <translation>innliming av %1 deler</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>innliming av %1</translation>
    </message>
    <message>
        <source>Remove %1 parts</source>
        <translation>fjerning av %1 deler</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Gi %1 nytt navn</translation>
    </message>
</context>
<context>
    <name>voluta::document::Opening</name>
    <message>
        <source>the rest of %1</source>
        <translation>resten av %1</translation>
    </message>
</context>
<context>
    <name>voluta::document::RecentFiles</name>
    <message>
        <source>%1 no longer exists. It was removed from the list.</source>
        <translation>%1 finnes ikke lenger. Filen er fjernet fra listen.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Saving</name>
    <message>
        <source>There is nothing to save yet. Open a part first.</source>
        <translation>Det er ingenting å lagre ennå. Åpne en del først.</translation>
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
        <translation>Plattform</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Prosess</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startverdi</translation>
    </message>
    <message>
        <source>Another seed may find other travel paths; the same seed always gives the same result.</source>
        <translation>En annen startverdi kan finne andre tomkjøringsbaner; samme startverdi gir alltid samme resultat.</translation>
    </message>
    <message>
        <source>Your own cells are JSON files in %1</source>
        <translation>Egne celler er JSON-filer i %1</translation>
    </message>
    <message>
        <source>Your own processes are JSON files in %1</source>
        <translation>Egne prosesser er JSON-filer i %1</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Your own materials are JSON files in %1</source>
        <translation>Egne materialer er JSON-filer i %1</translation>
    </message>
    <message>
        <source>Edit processes</source>
        <translation>Rediger prosesser</translation>
    </message>
    <message>
        <source>Edit materials</source>
        <translation>Rediger materialer</translation>
    </message>
    <message>
        <source>Growth scheme</source>
        <translation>Vekstmetode</translation>
    </message>
    <message>
        <source>How the part is divided into layers</source>
        <translation>Hvordan delen deles i lag</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterForm</name>
    <message>
        <source>Simple</source>
        <translation>Enkel</translation>
    </message>
    <message>
        <source>Show the most important and the changed parameters</source>
        <translation>Vis de viktigste og de endrede parameterne</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Show every parameter</source>
        <translation>Vis alle parametere</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tilbakestill alle</translation>
    </message>
    <message>
        <source>Reset every parameter to its default</source>
        <translation>Sett alle parametere til standardverdi</translation>
    </message>
    <message>
        <source>No matching parameter.</source>
        <translation>Ingen parameter passer.</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Print</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Forskning</translation>
    </message>
    <message>
        <source>Search settings</source>
        <translation>Søk i innstillinger</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterRow</name>
    <message>
        <source>Reset to %1</source>
        <translation>Tilbakestill til %1</translation>
    </message>
    <message>
        <source>Files (%1)</source>
        <translation>Filer (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle filer (*)</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Velg en fil</translation>
    </message>
</context>
<context>
    <name>voluta::forms::PlatformEditor</name>
    <message>
        <source>Body to print on</source>
        <translation>Legeme å printe på</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Velg en fil…</translation>
    </message>
    <message>
        <source>A closed mesh, positioned as in the part&apos;s file</source>
        <translation>En lukket mesh, plassert som i delens fil</translation>
    </message>
    <message>
        <source>%1
Click to choose another one</source>
        <translation>%1
Klikk for å velge en annen</translation>
    </message>
    <message>
        <source>Stepped: x,radius points</source>
        <translation>Trinnvis: punkter x,radius</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Hexagonal, across corners</source>
        <translation>Sekskantet, over hjørnene</translation>
    </message>
    <message>
        <source>%1 sides, across corners</source>
        <translation>%1 sider, over hjørnene</translation>
    </message>
    <message>
        <source>Shape of the rod</source>
        <translation>Stangens form</translation>
    </message>
    <message>
        <source>Profile of the rod</source>
        <translation>Stangens profil</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm; a step has two pairs at one x</source>
        <translation>Par av x og radius i mm; et trinn har to par med samme x</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesher (%1);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Surface on which the print begins</source>
        <translation>Overflaten printen begynner på</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ToolRows</name>
    <message>
        <source>Add tool</source>
        <translation>Legg til verktøy</translation>
    </message>
    <message>
        <source>Adds a second nozzle or material, for some parts, supports, pieces or the interior. The program stops for each change.</source>
        <translation>Legger til en andre dyse eller et andre materiale, for noen deler, støtter, stykker eller det indre. Programmet stopper ved hvert bytte.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Verktøy %1</translation>
    </message>
    <message>
        <source>Process of tool %1</source>
        <translation>Prosess for verktøy %1</translation>
    </message>
    <message>
        <source>Material of tool %1</source>
        <translation>Materiale for verktøy %1</translation>
    </message>
    <message>
        <source>Remove tool %1</source>
        <translation>Fjern verktøy %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ComparePanel</name>
    <message>
        <source>Cells</source>
        <translation>Celler</translation>
    </message>
    <message>
        <source>Compares these cells; none selected: the job&apos;s own</source>
        <translation>Sammenligner disse cellene; ingen valgt: jobbens egen</translation>
    </message>
    <message>
        <source>Open a part first.</source>
        <translation>Åpne en del først.</translation>
    </message>
    <message>
        <source>Select what to compare.</source>
        <translation>Velg hva som skal sammenlignes.</translation>
    </message>
    <message>
        <source>Plans: %1</source>
        <translation>Planer: %1</translation>
    </message>
    <message>
        <source>Ways of building</source>
        <translation>Byggemåter</translation>
    </message>
    <message>
        <source>Growth of curved layers</source>
        <translation>Vekst av krumme lag</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>Plattformer</translation>
    </message>
    <message>
        <source>Delete removes the selected one from the list</source>
        <translation>Delete fjerner den valgte fra listen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Legg til</translation>
    </message>
    <message>
        <source>Also compare with this platform</source>
        <translation>Sammenlign også med denne plattformen</translation>
    </message>
    <message>
        <source>Plan up to</source>
        <translation>Planlegg fram til</translation>
    </message>
    <message>
        <source>verified programs</source>
        <translation>verifiserte programmer</translation>
    </message>
    <message>
        <source>missed voxels and pieces</source>
        <translation>tapte voksler og stykker</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Plans them one after the other, in the background</source>
        <translation>Planlegger dem etter tur, i bakgrunnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Stops; completed rows are kept</source>
        <translation>Stopper; ferdige rader beholdes</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Vekter</translation>
    </message>
    <message>
        <source>Ways without blocking findings rank first, then the lowest score: each figure as a share of the column&apos;s largest, times its weight.</source>
        <translation>Byggemåter uten blokkerende funn rangeres først, deretter laveste poengsum: hvert tall som andel av kolonnens største, ganger vekten.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Tilbakestill</translation>
    </message>
    <message>
        <source>Restore the default weights</source>
        <translation>Gjenopprett standardvektene</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CompareTable</name>
    <message>
        <source>Best</source>
        <translation>Best</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>I bruk</translation>
    </message>
    <message>
        <source>Rank, and the score below it: lower is better</source>
        <translation>Rang, og poengsummen under: lavere er bedre</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Plass</translation>
    </message>
    <message>
        <source>Way of building</source>
        <translation>Byggemåte</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CursorInfo</name>
    <message>
        <source>Line %1</source>
        <translation>Linje %1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linje</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Dyse</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Helning</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Ledd</translation>
    </message>
    <message>
        <source>The nozzle&apos;s tip, from the middle of the platform</source>
        <translation>Dysens spiss, fra midten av plattformen</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotasjon</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Skrevet ut</translation>
    </message>
    <message>
        <source>About X, Y and Z of the platform, from the upright nozzle</source>
        <translation>Om X, Y og Z på plattformen, fra loddrett dyse</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CutPanel</name>
    <message>
        <source>Cut</source>
        <translation>Skjær</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Skjær %1</translation>
    </message>
    <message>
        <source>Perpendicular to</source>
        <translation>Vinkelrett på</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posisjon</translation>
    </message>
    <message>
        <source>Distance from the lowest point of the part along the axis</source>
        <translation>Avstand fra delens laveste punkt langs aksen</translation>
    </message>
    <message>
        <source>Tilt about %1</source>
        <translation>Helning om %1</translation>
    </message>
    <message>
        <source>Parallel to a face</source>
        <translation>Parallelt med en flate</translation>
    </message>
    <message>
        <source>Then click the face; the plane goes through the clicked point</source>
        <translation>Klikk så på flaten; planet går gjennom punktet</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behold</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>Begge halvdeler</translation>
    </message>
    <message>
        <source>Lower half</source>
        <translation>Nedre halvdel</translation>
    </message>
    <message>
        <source>Upper half</source>
        <translation>Øvre halvdel</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Skjøt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Dowels</source>
        <translation>Dybler</translation>
    </message>
    <message>
        <source>Pegs</source>
        <translation>Tapper</translation>
    </message>
    <message>
        <source>Dovetail</source>
        <translation>Svalehale</translation>
    </message>
    <message>
        <source>Dowels: loose pins in holes of both halves. Pegs: pins of the lower half. Dovetail: a tongue of the lower half in a groove.</source>
        <translation>Dybler: løse pinner i hull i begge halvdeler. Tapper: pinner på nedre halvdel. Svalehale: en fjær på nedre halvdel i et spor.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diameter</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Dybde</translation>
    </message>
    <message>
        <source>Height of the tongue</source>
        <translation>Høyden på fjæren</translation>
    </message>
    <message>
        <source>Of a pin in each half</source>
        <translation>For en pinne i hver halvdel</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Klaring</translation>
    </message>
    <message>
        <source>Gap on every side of a pin or of the tongue</source>
        <translation>Mellomrom på hver side av en pinne eller fjæren</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Antall</translation>
    </message>
    <message>
        <source>Pins in each section, if there is room</source>
        <translation>Pinner i hvert snitt, hvis det er plass</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Retning</translation>
    </message>
    <message>
        <source>In which the dovetail slides, from the horizontal</source>
        <translation>Som svalehalen glir i, fra vannrett</translation>
    </message>
    <message>
        <source>Lay halves on their cut face</source>
        <translation>Legg halvdelene på snittflaten</translation>
    </message>
    <message>
        <source>A half with pegs or a tongue keeps its orientation</source>
        <translation>En halvdel med tapper eller fjær beholder retningen</translation>
    </message>
    <message>
        <source>Show apart</source>
        <translation>Vis fra hverandre</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Lukk</translation>
    </message>
</context>
<context>
    <name>voluta::panels::EffectCard</name>
    <message>
        <source>Undo</source>
        <translation>Angre</translation>
    </message>
    <message>
        <source>Takes the remedy back, and shows the plan before it</source>
        <translation>Angrer tiltaket, og viser planen før det</translation>
    </message>
    <message>
        <source>Hide this</source>
        <translation>Skjul dette</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ExportPanel</name>
    <message>
        <source>Replay of %1</source>
        <translation>Gjenspilling av %1</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Gjenspilling</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Velg minst ett format.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Velg en mappe.</translation>
    </message>
    <message>
        <source>Folder for the programs</source>
        <translation>Mappe for programmene</translation>
    </message>
    <message>
        <source>Refused programs</source>
        <translation>Avviste programmer</translation>
    </message>
    <message>
        <source>The replay refused some of the programs. Never run them on a robot.</source>
        <translation>Gjenspillingen avviste noen av programmene. Kjør dem aldri på en robot.</translation>
    </message>
    <message>
        <source>For inspection only, they can be saved as:</source>
        <translation>Kun til inspeksjon kan de lagres som:</translation>
    </message>
    <message>
        <source>Save them too</source>
        <translation>Lagre dem også</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Utelat</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>Formater</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>Programtekst</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Mappe</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Bla gjennom…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksporter</translation>
    </message>
    <message>
        <source>%1 options</source>
        <translation>Valg for %1</translation>
    </message>
    <message>
        <source>Blocked plan</source>
        <translation>Blokkert plan</translation>
    </message>
    <message>
        <source>The plan has blocking findings: %1</source>
        <translation>Planen har blokkerende funn: %1</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Eksporter likevel</translation>
    </message>
    <message>
        <source>Not as asked</source>
        <translation>Ikke som ønsket</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>Trygt å kjøre, ikke som ønsket: %1</translation>
    </message>
    <message>
        <source>The part will differ from the requested one there. To export without this question, accept it in the list of findings.</source>
        <translation>Delen vil avvike fra den ønskede der. For å eksportere uten dette spørsmålet, godta det i listen over funn.</translation>
    </message>
    <message>
        <source>Do not run the programs before these are solved.</source>
        <translation>Ikke kjør programmene før disse er løst.</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Ikke kontrollert</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>Trygt å kjøre, bortsett fra egne setninger: %1</translation>
    </message>
    <message>
        <source>Nothing checks what they do. Try them on the controller with the arm clear first.</source>
        <translation>Ingenting kontrollerer hva de gjør. Prøv dem først på styringen med armen i fri stilling.</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsModel</name>
    <message>
        <source>Blocked: %1</source>
        <translation>Blokkerende: %1</translation>
    </message>
    <message>
        <source>Worth knowing: %1</source>
        <translation>Verdt å vite: %1</translation>
    </message>
    <message>
        <source>at %1, %2, %3 mm</source>
        <translation>ved %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>before the change</source>
        <translation>før endringen</translation>
    </message>
    <message>
        <source>Not as asked: %1</source>
        <translation>Ikke som ønsket: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n sted</numerusform>
            <numerusform>%n steder</numerusform>
        </translation>
    </message>
    <message>
        <source>Not checked: %1</source>
        <translation>Ikke kontrollert: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsPanel</name>
    <message>
        <source>Findings</source>
        <translation>Funn</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Funn (%1)</translation>
    </message>
    <message>
        <source>%1 blocking, %2 for information</source>
        <translation>%1 blokkerende, %2 til informasjon</translation>
    </message>
    <message>
        <source>Blocked (%1)</source>
        <translation>Blokkerende (%1)</translation>
    </message>
    <message>
        <source>No blocking findings.</source>
        <translation>Ingen blokkerende funn.</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Ingen problemer funnet.</translation>
    </message>
    <message>
        <source>No findings yet.</source>
        <translation>Ingen funn ennå.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Move the camera, the sliders and the robot there</source>
        <translation>Flytt kameraet, glidebryterne og roboten dit</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Ikke kontrollert: %1.</translation>
    </message>
    <message>
        <source>No problems found so far.</source>
        <translation>Ingen problemer funnet så langt.</translation>
    </message>
    <message>
        <source>%1 blocking, %2 not as asked, %3 for information</source>
        <translation>%1 blokkerende, %2 ikke som ønsket, %3 til informasjon</translation>
    </message>
    <message>
        <source>Not as asked (%1)</source>
        <translation>Ikke som ønsket (%1)</translation>
    </message>
    <message>
        <source>Blocked (%1), not as asked (%2)</source>
        <translation>Blokkerende (%1), ikke som ønsket (%2)</translation>
    </message>
    <message>
        <source>Show only findings that block, or by which the part differs</source>
        <translation>Vis bare funn som blokkerer, eller som gjør delen annerledes</translation>
    </message>
    <message>
        <source>What helps: %1</source>
        <translation>Hva som hjelper: %1</translation>
    </message>
    <message>
        <source>Place %1 of %2</source>
        <translation>Sted %1 av %2</translation>
    </message>
    <message>
        <source>Show next</source>
        <translation>Vis neste</translation>
    </message>
    <message>
        <source>Apply and plan:</source>
        <translation>Bruk og planlegg:</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FormatList</name>
    <message>
        <source>%1, foreign</source>
        <translation>%1, fremmed</translation>
    </message>
    <message>
        <source>For another maker&apos;s controller: where the nozzle goes, not how this robot moves</source>
        <translation>For en annen produsents styring: hvor dysen går, ikke hvordan denne roboten beveger seg</translation>
    </message>
    <message>
        <source>Not replayed yet</source>
        <translation>Ikke gjenspilt ennå</translation>
    </message>
    <message>
        <source>Passed: the replay found no errors</source>
        <translation>Bestått: gjenspillingen fant ingen feil</translation>
    </message>
    <message>
        <source>Refused by the replay: %1</source>
        <translation>Avvist av gjenspillingen: %1</translation>
    </message>
    <message>
        <source>Not replayed since the change</source>
        <translation>Ikke gjenspilt etter endringen</translation>
    </message>
    <message>
        <source>Not passed, the plan is blocked: %1</source>
        <translation>Ikke bestått, planen er blokkert: %1</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>Trygt å kjøre, ikke som ønsket: %1</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>Trygt å kjøre, bortsett fra egne setninger: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FrameForm</name>
    <message>
        <source>Place</source>
        <translation>Plassering</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotasjon</translation>
    </message>
    <message>
        <source>About the fixed X, then Y, then Z axis</source>
        <translation>Om den faste X-, så Y-, så Z-aksen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanter</translation>
    </message>
    <message>
        <source>Place along %1</source>
        <translation>Plassering langs %1</translation>
    </message>
    <message>
        <source>Turn about %1</source>
        <translation>Rotasjon om %1</translation>
    </message>
    <message>
        <source>Edge along %1</source>
        <translation>Kant langs %1</translation>
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
        <translation>Hode, %1 × ⌀ %2 mm</translation>
    </message>
    <message>
        <source>Bead, %1 × %2 mm</source>
        <translation>Streng, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Head, nozzle and bead, to scale</source>
        <translation>Hode, dyse og streng, i målestokk</translation>
    </message>
    <message>
        <source>Left: profile of the head, used for collision checks. Right: its tip with a bead of the usual width and height.</source>
        <translation>Til venstre: hodets profil, brukt til kollisjonskontroll. Til høyre: spissen med en streng av vanlig bredde og høyde.</translation>
    </message>
    <message>
        <source>The head&apos;s sections do not rise from the tip.</source>
        <translation>Hodets tverrsnitt stiger ikke fra spissen.</translation>
    </message>
</context>
<context>
    <name>voluta::panels::HeadTable</name>
    <message>
        <source>Height [mm]</source>
        <translation>Høyde [mm]</translation>
    </message>
    <message>
        <source>Radius [mm]</source>
        <translation>Radius [mm]</translation>
    </message>
    <message>
        <source>Sections of the head from the tip up. Two rows of the same height are a step.</source>
        <translation>Hodets tverrsnitt fra spissen og oppover. To rader med samme høyde er et trinn.</translation>
    </message>
    <message>
        <source>Sections of the head</source>
        <translation>Hodets tverrsnitt</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Legg til rad</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Fjern rad</translation>
    </message>
    <message>
        <source>Reset head</source>
        <translation>Tilbakestill hode</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ItemForm</name>
    <message>
        <source>Choose a colour</source>
        <translation>Velg en farge</translation>
    </message>
</context>
<context>
    <name>voluta::panels::JogPanel</name>
    <message>
        <source>Joints</source>
        <translation>Ledd</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Dyse</translation>
    </message>
    <message>
        <source>The tip on the platform, and rotations about X, Y and Z (A, B, C) from the upright nozzle</source>
        <translation>Spissen på plattformen, og rotasjoner om X, Y og Z (A, B, C) fra loddrett dyse</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Step of X, Y and Z</source>
        <translation>Steg for X, Y og Z</translation>
    </message>
    <message>
        <source>Step of A, B and C</source>
        <translation>Steg for A, B og C</translation>
    </message>
    <message>
        <source>Back to the plan</source>
        <translation>Tilbake til planen</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>Ledd %1</translation>
    </message>
    <message>
        <source>%1 one step less</source>
        <translation>%1 ett steg mindre</translation>
    </message>
    <message>
        <source>%1 one step more</source>
        <translation>%1 ett steg mer</translation>
    </message>
</context>
<context>
    <name>voluta::panels::LayerInfo</name>
    <message>
        <source>Layer</source>
        <translation>Lag</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Lagflater</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Areal</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tykkelse</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengde</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Banepunkter</translation>
    </message>
    <message>
        <source>Minimum, mean and maximum</source>
        <translation>Minimum, snitt og maksimum</translation>
    </message>
</context>
<context>
    <name>voluta::panels::MeshPanel</name>
    <message>
        <source>Repair the mesh</source>
        <translation>Reparer meshen</translation>
    </message>
    <message>
        <source>Closes holes, orients triangles and removes duplicates, as far as the shape is not in doubt</source>
        <translation>Lukker hull, orienterer trekanter og fjerner duplikater, så langt formen ikke er i tvil</translation>
    </message>
    <message>
        <source>No part is open.</source>
        <translation>Ingen del er åpen.</translation>
    </message>
    <message>
        <source>The mesh is not watertight.</source>
        <translation>Meshen er ikke tett.</translation>
    </message>
    <message>
        <source>The mesh is watertight.</source>
        <translation>Meshen er tett.</translation>
    </message>
    <message>
        <source>The mesh is watertight, but has defects.</source>
        <translation>Meshen er tett, men har feil.</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Trekanter: %1</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Funnet</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Reparert</translation>
    </message>
    <message>
        <source>Remains</source>
        <translation>Gjenstår</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ObjectTree</name>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Plattform</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Dyse</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Byggeplate</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Skjul</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Part and cell</source>
        <translation>Del og celle</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PaintForm</name>
    <message>
        <source>Paint with</source>
        <translation>Mal med</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pensel</translation>
    </message>
    <message>
        <source>Whole faces</source>
        <translation>Hele flater</translation>
    </message>
    <message>
        <source>Up to edges of</source>
        <translation>Inntil kanter på</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Paint on the part. Shift or the right button erases.</source>
        <translation>Mal på delen. Shift eller høyre knapp visker ut.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rektangel</translation>
    </message>
    <message>
        <source>Drag a rectangle: it paints what you see in it. Shift or the right button erases.</source>
        <translation>Dra et rektangel: det maler det du ser i det. Shift eller høyre knapp visker ut.</translation>
    </message>
    <message>
        <source>Layers while the brush rests</source>
        <translation>Lag mens penselen hviler</translation>
    </message>
    <message>
        <source>One second after a stroke, the layers are made again in the background</source>
        <translation>Ett sekund etter et strøk lages lagene på nytt i bakgrunnen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PartList</name>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Size [mm]</source>
        <translation>Størrelse [mm]</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Legg til…</translation>
    </message>
    <message>
        <source>Adds a part from a file beside the others</source>
        <translation>Legger en del fra en fil ved siden av de andre</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliser</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part with its settings</source>
        <translation>Legger til en kopi av den valgte delen med innstillingene</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Removes the selected part; can be undone</source>
        <translation>Fjerner den valgte delen; kan angres</translation>
    </message>
    <message>
        <source>Print order</source>
        <translation>Printrekkefølge</translation>
    </message>
    <message>
        <source>One after another</source>
        <translation>Én etter én</translation>
    </message>
    <message>
        <source>Layer by layer</source>
        <translation>Lag for lag</translation>
    </message>
    <message>
        <source>One after another: each part is finished before the next begins. Layer by layer: all parts grow together.</source>
        <translation>Én etter én: hver del gjøres ferdig før neste begynner. Lag for lag: alle deler vokser sammen.</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Ordne</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>Flytter alle deler ved siden av hverandre, med plass til skrivehodet</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PiecesPanel</name>
    <message>
        <source>Printed as number %1, on piece %2</source>
        <translation>Printes som nummer %1, på stykke %2</translation>
    </message>
    <message>
        <source>Printed as number %1, on the plate</source>
        <translation>Printes som nummer %1, på byggeplaten</translation>
    </message>
    <message>
        <source>Needs support: %1, uncut %2</source>
        <translation>Trenger støtte: %1, ukuttet %2</translation>
    </message>
    <message>
        <source>With this cut: %1 need support. Press Plan.</source>
        <translation>Med dette kuttet: %1 trenger støtte. Trykk Planlegg.</translation>
    </message>
    <message>
        <source>With this cut: about %1 need support</source>
        <translation>Med dette kuttet: ca. %1 trenger støtte</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Stykke</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volum</translation>
    </message>
    <message>
        <source>Risky</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>In print order; each piece is listed below the one it is printed on</source>
        <translation>I printrekkefølge; hvert stykke står under det det printes på</translation>
    </message>
    <message>
        <source>Area that needs support when the piece is printed from its base</source>
        <translation>Areal som trenger støtte når stykket printes fra underlaget sitt</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Avstand</translation>
    </message>
    <message>
        <source>Moves each piece away from the one it is printed on</source>
        <translation>Flytter hvert stykke bort fra det det printes på</translation>
    </message>
    <message>
        <source>Base planes</source>
        <translation>Basisplan</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Søk på nytt</translation>
    </message>
    <message>
        <source>Keep these cuts</source>
        <translation>Behold disse kuttene</translation>
    </message>
    <message>
        <source>Discards your cuts and searches for others</source>
        <translation>Forkaster kuttene dine og søker etter andre</translation>
    </message>
    <message>
        <source>Keeps these cuts: they become your own and are not searched again</source>
        <translation>Beholder disse kuttene: de blir dine egne og søkes ikke på nytt</translation>
    </message>
    <message>
        <source>Pick root</source>
        <translation>Velg rot</translation>
    </message>
    <message>
        <source>Then click a point on the piece to print first</source>
        <translation>Klikk så et punkt på stykket som skal printes først</translation>
    </message>
    <message>
        <source>Click a piece to see its base plane and to move that cut.</source>
        <translation>Klikk et stykke for å se basisplanet og flytte det kuttet.</translation>
    </message>
    <message>
        <source>Drag the arrow to move the cut, a ring to tilt it. Esc deselects.</source>
        <translation>Dra pilen for å flytte kuttet, en ring for å tilte det. Esc opphever valget.</translation>
    </message>
    <message>
        <source>This piece is on the plate: it has no cut to move.</source>
        <translation>Dette stykket er på byggeplaten: det har ikke noe kutt å flytte.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numre</translation>
    </message>
    <message>
        <source>In the picture, in print order</source>
        <translation>I bildet, i printrekkefølge</translation>
    </message>
    <message>
        <source>Shows where each piece is cut</source>
        <translation>Viser hvor hvert stykke er kuttet</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PlacementPanel</name>
    <message>
        <source>Drop to plate</source>
        <translation>Senk til byggeplaten</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Sentrer</translation>
    </message>
    <message>
        <source>Reset placement</source>
        <translation>Tilbakestill plassering</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Flytt</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Roter</translation>
    </message>
    <message>
        <source>About the fixed axes: first X, then Y, then Z</source>
        <translation>Om de faste aksene: først X, så Y, så Z</translation>
    </message>
    <message>
        <source>Height of the lowest point above the plate</source>
        <translation>Høyden på det laveste punktet over byggeplaten</translation>
    </message>
    <message>
        <source>Centre of the part along %1</source>
        <translation>Delens sentrum langs %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Flytt %1</translation>
    </message>
    <message>
        <source>Rotate about the fixed axis %1; X comes first, then Y, then Z</source>
        <translation>Roter om den faste aksen %1; X først, så Y, så Z</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>Roter %1</translation>
    </message>
    <message>
        <source>Rotate by -90° about %1, from the present orientation</source>
        <translation>Roter -90° om %1, fra gjeldende orientering</translation>
    </message>
    <message>
        <source>Rotate by 90° about %1, from the present orientation</source>
        <translation>Roter 90° om %1, fra gjeldende orientering</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Scale in percent</source>
        <translation>Skala i prosent</translation>
    </message>
    <message>
        <source>Scale as a factor</source>
        <translation>Skala som faktor</translation>
    </message>
    <message>
        <source>Fit to reach</source>
        <translation>Tilpass til rekkevidde</translation>
    </message>
    <message>
        <source>Scale down, if necessary, to the size that the arm reaches everywhere</source>
        <translation>Skalerer ned om nødvendig, til størrelsen armen når overalt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Størrelse</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>Legg på flate</translation>
    </message>
    <message>
        <source>Then click the face to place on the plate</source>
        <translation>Klikk så flaten som skal ligge mot byggeplaten</translation>
    </message>
    <message>
        <source>Put the centre of the part over the centre of the plate</source>
        <translation>Sett delens sentrum over byggeplatens sentrum</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Tilbakestill</translation>
    </message>
    <message>
        <source>Position and size as in the file</source>
        <translation>Posisjon og størrelse som i filen</translation>
    </message>
    <message>
        <source>Size along %1. A new size scales the part as a whole.</source>
        <translation>Størrelse langs %1. En ny størrelse skalerer hele delen.</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Størrelse langs %1</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>Millimeter eller tommer</translation>
    </message>
    <message>
        <source>Unit of the size</source>
        <translation>Enhet for størrelsen</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ProgramFacts</name>
    <message>
        <source>Assumptions about the controller</source>
        <translation>Antakelser om styringen</translation>
    </message>
    <message>
        <source>%1 in one file</source>
        <translation>%1 i én fil</translation>
    </message>
    <message>
        <source>%1 in %2 files</source>
        <translation>%1 i %2 filer</translation>
    </message>
    <message>
        <source>Time on the controller: %1, as planned</source>
        <translation>Tid på styringen: %1, som planlagt</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % more than the planned time of %2</source>
        <translation>Tid på styringen: %1, %3 % mer enn planlagt tid på %2</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % less than the planned time of %2</source>
        <translation>Tid på styringen: %1, %3 % mindre enn planlagt tid på %2</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ReachPanel</name>
    <message>
        <source>Calculating…</source>
        <translation>Beregner…</translation>
    </message>
    <message>
        <source>No part on a plate.</source>
        <translation>Ingen del på en byggeplate.</translation>
    </message>
    <message>
        <source>The part is off the plate.</source>
        <translation>Delen er utenfor byggeplaten.</translation>
    </message>
    <message>
        <source>Fully reachable upright.</source>
        <translation>Helt nåbar i loddrett stilling.</translation>
    </message>
    <message>
        <source>%1 % reachable upright.</source>
        <translation>%1 % nåbart loddrett.</translation>
    </message>
    <message>
        <source>With up to %1° of tilt: %2 %.</source>
        <translation>Med opptil %1° tilt: %2 %.</translation>
    </message>
    <message>
        <source>There %1 % is reachable upright, %2 % tilted</source>
        <translation>Der er %1 % nåbart loddrett, %2 % tiltet</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Rekkevidde</translation>
    </message>
    <message>
        <source>Reach of the head over the whole height of the part; collisions with printed material are not checked</source>
        <translation>Hodets rekkevidde over hele delens høyde; kollisjoner med printet materiale kontrolleres ikke</translation>
    </message>
    <message>
        <source>Show on plate</source>
        <translation>Vis på byggeplaten</translation>
    </message>
    <message>
        <source>Move to best place</source>
        <translation>Flytt til beste sted</translation>
    </message>
</context>
<context>
    <name>voluta::panels::RegionsPanel</name>
    <message>
        <source>Regions</source>
        <translation>Regioner</translation>
    </message>
    <message>
        <source>Regions of %1</source>
        <translation>Regioner i %1</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>Gi region nytt navn</translation>
    </message>
    <message>
        <source>Use of a region</source>
        <translation>Bruk av en region</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Endre region</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Endre %1</translation>
    </message>
    <message>
        <source>Delete region</source>
        <translation>Slett region</translation>
    </message>
    <message>
        <source>Order of regions</source>
        <translation>Rekkefølge på regioner</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Bruk</translation>
    </message>
    <message>
        <source>Where regions overlap, the lower one in the list holds. Double-click renames.</source>
        <translation>Der regioner overlapper, gjelder den nederste i listen. Dobbeltklikk gir nytt navn.</translation>
    </message>
    <message>
        <source>A region is printed by settings, or in layers, of its own.</source>
        <translation>En region skrives ut med egne innstillinger eller i egne lag.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Legg til</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slett</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Flytt opp</translation>
    </message>
    <message>
        <source>Move down: where regions overlap, the lower one holds</source>
        <translation>Flytt ned: der regioner overlapper, gjelder den nederste</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Flytt ned</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Innstillinger</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Lukk</translation>
    </message>
    <message>
        <source>Only a skin or a painted surface says which faces the layers follow</source>
        <translation>Bare en hud eller en malt overflate angir hvilke flater lagene følger</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ResumeBar</name>
    <message>
        <source>Resume from here…</source>
        <translation>Gjenoppta herfra…</translation>
    </message>
    <message>
        <source>Opens the rest of a print that was stopped there as a new project</source>
        <translation>Åpner resten av en print som ble stanset der, som et nytt prosjekt</translation>
    </message>
</context>
<context>
    <name>voluta::panels::VerdictTable</name>
    <message>
        <source>Coverage</source>
        <translation>Dekning</translation>
    </message>
    <message>
        <source>Unsupported</source>
        <translation>Uten støtte</translation>
    </message>
    <message>
        <source>Overfill</source>
        <translation>Overfylling</translation>
    </message>
    <message>
        <source>Mass error</source>
        <translation>Massefeil</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisjoner</translation>
    </message>
    <message>
        <source>Limit violations</source>
        <translation>Grensebrudd</translation>
    </message>
    <message>
        <source>Path deviation</source>
        <translation>Baneavvik</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Måltall</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Verdi</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grense</translation>
    </message>
    <message>
        <source>Within limit</source>
        <translation>Innenfor grensen</translation>
    </message>
    <message>
        <source>Outside limit</source>
        <translation>Utenfor grensen</translation>
    </message>
    <message>
        <source>Not checked since the change</source>
        <translation>Ikke kontrollert etter endringen</translation>
    </message>
    <message>
        <source>Less than half supported</source>
        <translation>Mindre enn halvt støttet</translation>
    </message>
    <message>
        <source>Longest unsupported run</source>
        <translation>Lengste strekk uten støtte</translation>
    </message>
    <message>
        <source>Flow error</source>
        <translation>Feil i materialstrøm</translation>
    </message>
    <message>
        <source>Time on the controller</source>
        <translation>Tid på styringen</translation>
    </message>
    <message>
        <source>Differences from the plan</source>
        <translation>Avvik fra planen</translation>
    </message>
    <message>
        <source>Outside limit, not refused</source>
        <translation>Utenfor grensen, ikke avvist</translation>
    </message>
    <message>
        <source>Thin and open</source>
        <translation>Tynt og åpent</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WayCard</name>
    <message>
        <source>Contact %1 mm²</source>
        <translation>Kontakt %1 mm²</translation>
    </message>
    <message>
        <source>Missed voxels %1</source>
        <translation>Tapte voksler %1</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Ca. %1</translation>
    </message>
    <message>
        <source>contact %1 mm², overhang %2 mm²
%3 mm high
%4 of %5 voxels missed in one growth pass
about %6, estimated from size, walls and infill without supports</source>
        <translation>kontakt %1 mm², overheng %2 mm²
%3 mm høy
%4 av %5 voksler tapt i én vekstrunde
ca. %6, anslått ut fra størrelse, vegger og fyll uten støtter</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WaysList</name>
    <message>
        <source>Calculating…</source>
        <translation>Beregner…</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>ingen funnet</translation>
    </message>
    <message>
        <source>custom orientation</source>
        <translation>egendefinert orientering</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>Orienteringer</translation>
    </message>
    <message>
        <source>Click one to orient the part that way</source>
        <translation>Klikk en for å orientere delen slik</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WrittenBar</name>
    <message>
        <source>Open report</source>
        <translation>Åpne rapport</translation>
    </message>
    <message>
        <source>The report to hand over: verdict, margins and hashes of the program</source>
        <translation>Rapporten som skal leveres: konklusjon, marginer og hasher for programmet</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Vis mappe</translation>
    </message>
    <message>
        <source>Opens the folder with the programs in the file manager</source>
        <translation>Åpner mappen med programmene i filbehandleren</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::JointPlots</name>
    <message>
        <source>Angle (°)</source>
        <translation>Vinkel (°)</translation>
    </message>
    <message>
        <source>Speed (°/s)</source>
        <translation>Hastighet (°/s)</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tid (s)</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Vinkel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Begge</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenser</translation>
    </message>
    <message>
        <source>Show the limits of the joints as dashed lines</source>
        <translation>Vis leddgrensene som stiplede linjer</translation>
    </message>
    <message>
        <source>Show joint %1</source>
        <translation>Vis ledd %1</translation>
    </message>
    <message>
        <source>Preparing the curves…</source>
        <translation>Forbereder kurvene…</translation>
    </message>
    <message>
        <source>Joint curves appear here once the motion is planned.</source>
        <translation>Leddkurver vises her når bevegelsen er planlagt.</translation>
    </message>
    <message>
        <source>No joint selected.</source>
        <translation>Ingen ledd valgt.</translation>
    </message>
    <message>
        <source>Show axis %1</source>
        <translation>Vis akse %1</translation>
    </message>
    <message>
        <source>Angle (°), position (mm)</source>
        <translation>Vinkel (°), posisjon (mm)</translation>
    </message>
    <message>
        <source>Speed (°/s, mm/s)</source>
        <translation>Hastighet (°/s, mm/s)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³)</source>
        <translation>Rykk (rad/s³)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³, mm/s³)</source>
        <translation>Rykk (rad/s³, mm/s³)</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Rykk</translation>
    </message>
    <message>
        <source>Earlier motion</source>
        <translation>Tidligere bevegelse</translation>
    </message>
    <message>
        <source>Show the jerk of the motion planned before, in pale colours, to compare</source>
        <translation>Vis rykket i bevegelsen som ble planlagt før, i bleke farger, for sammenligning</translation>
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
        <translation>Viste lag</translation>
    </message>
    <message>
        <source>No layers</source>
        <translation>Ingen lag</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3</source>
        <translation>Lag %1 til %2 av %3</translation>
    </message>
    <message>
        <source>Layers appear here once they are planned.</source>
        <translation>Lag vises her når de er planlagt.</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3. Up and down keys move the upper end, with Shift the lower one; a double click shows a single layer.</source>
        <translation>Lag %1 til %2 av %3. Pil opp og ned flytter øvre ende, med Shift den nedre; dobbeltklikk viser ett enkelt lag.</translation>
    </message>
    <message>
        <source>r %1 mm</source>
        <translation>r %1 mm</translation>
    </message>
    <message>
        <source>, a pause before the last</source>
        <translation>, en pause før det siste</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>Fjern pausen før lag %1</translation>
    </message>
    <message>
        <source>Pause before layer %1: the arm goes beside the part and waits, for example to put in an insert</source>
        <translation>Pause før lag %1: armen går til siden for delen og venter, for eksempel for å legge inn en innsats</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::TimelineBar</name>
    <message>
        <source>Wait: %1 s</source>
        <translation>Venting: %1 s</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>bevegelse %1</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Forrige lag</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Forrige bevegelse</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Spill av</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Neste bevegelse</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Neste lag</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Avspillingshastighet</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Moves of the layer</source>
        <translation>Lagets bevegelser</translation>
    </message>
    <message>
        <source>growth step %1</source>
        <translation>veksttrinn %1</translation>
    </message>
    <message>
        <source>Ten steps back</source>
        <translation>Ti trinn tilbake</translation>
    </message>
    <message>
        <source>Previous growth step</source>
        <translation>Forrige veksttrinn</translation>
    </message>
    <message>
        <source>Next growth step</source>
        <translation>Neste veksttrinn</translation>
    </message>
    <message>
        <source>Ten steps forward</source>
        <translation>Ti trinn fram</translation>
    </message>
    <message>
        <source>Growth steps</source>
        <translation>Veksttrinn</translation>
    </message>
    <message>
        <source>Printing time so far / planned time</source>
        <translation>Printtid så langt / planlagt tid</translation>
    </message>
    <message>
        <source>Time-line</source>
        <translation>Tidslinje</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::MachinesView</name>
    <message>
        <source>View of the machines</source>
        <translation>Visning av maskinene</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::ViewCube</name>
    <message>
        <source>Front</source>
        <translation>Foran</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Bak</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Venstre</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Høyre</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Topp</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Bunn</translation>
    </message>
    <message>
        <source>Click a face to look from there, drag to turn the view</source>
        <translation>Klikk en flate for å se derfra, dra for å dreie visningen</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::Viewport</name>
    <message>
        <source>View</source>
        <translation>Visning</translation>
    </message>
</context>
<context>
    <name>voluta::window::ArmImportDialog</name>
    <message>
        <source>Six axes with a spherical wrist, solved in closed form</source>
        <translation>Seks akser med sfærisk håndledd, løst i lukket form</translation>
    </message>
    <message>
        <source>Six axes, 2 to 4 parallel, solved in closed form</source>
        <translation>Seks akser, 2 til 4 parallelle, løst i lukket form</translation>
    </message>
    <message>
        <source>Six axes with an offset wrist, solved by a search</source>
        <translation>Seks akser med forskjøvet håndledd, løst ved søk</translation>
    </message>
    <message>
        <source>Six axes, solved numerically: plans take longer</source>
        <translation>Seks akser, løst numerisk: planer tar lengre tid</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Importer en robotarm</translation>
    </message>
    <message>
        <source>Nozzle on the arm, plate on a table</source>
        <translation>Dyse på armen, byggeplate på et bord</translation>
    </message>
    <message>
        <source>Plate on the arm, nozzle fixed</source>
        <translation>Byggeplate på armen, fast dyse</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flens</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmer</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leser…</translation>
    </message>
    <message>
        <source>Assumed:</source>
        <translation>Antatt:</translation>
    </message>
    <message>
        <source>An arm named %1 exists.</source>
        <translation>En arm med navnet %1 finnes allerede.</translation>
    </message>
    <message>
        <source>Replacing it loses the frames, obstacles and other changes in these files:</source>
        <translation>Hvis den erstattes, mistes koordinatsystemer, hindringer og andre endringer i disse filene:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstatt</translation>
    </message>
    <message>
        <source>Use another name</source>
        <translation>Bruk et annet navn</translation>
    </message>
    <message>
        <source>Found in the file</source>
        <translation>Funnet i filen</translation>
    </message>
</context>
<context>
    <name>voluta::window::BodyTree</name>
    <message>
        <source>Robot&apos;s base</source>
        <translation>Robotens base</translation>
    </message>
    <message>
        <source>Flange of %1</source>
        <translation>Flensen til %1</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Dyse</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Byggeplate</translation>
    </message>
    <message>
        <source>in the flange</source>
        <translation>i flensen</translation>
    </message>
    <message>
        <source>on the last axis</source>
        <translation>på den siste aksen</translation>
    </message>
    <message>
        <source>on the previous axis</source>
        <translation>på den forrige aksen</translation>
    </message>
    <message>
        <source>in the robot&apos;s base</source>
        <translation>i robotens base</translation>
    </message>
    <message>
        <source>Place for purges</source>
        <translation>Spyleplass</translation>
    </message>
</context>
<context>
    <name>voluta::window::CellEditor</name>
    <message>
        <source>in the flange</source>
        <translation>i flensen</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Rediger celle</translation>
    </message>
    <message>
        <source>Save as my cell</source>
        <translation>Lagre som egen celle</translation>
    </message>
    <message>
        <source>Mass on the flange before printing: the plate and its stem, or head and extruder</source>
        <translation>Massen på flensen før printing: byggeplaten og stammen, eller hode og ekstruder</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Ekstruder</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Nyttelast</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>Legg til boks</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Find home pose</source>
        <translation>Finn hjempositur</translation>
    </message>
    <message>
        <source>Finds the home pose with the greatest clearance, the nozzle over the plate</source>
        <translation>Finner hjemposituren med størst klaring, med dysen over byggeplaten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Angre</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Gjør om</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>ekstruder</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>nyttelast</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>flytting av %1</translation>
    </message>
    <message>
        <source>edges of %1</source>
        <translation>kantene til %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Select a body to move it</source>
        <translation>Velg et legeme for å flytte det</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>kontrollerer…</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Ingen problemer.</translation>
    </message>
    <message>
        <source>add a box</source>
        <translation>tillegg av boks</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>fjerning av %1</translation>
    </message>
    <message>
        <source>home pose</source>
        <translation>hjempositur</translation>
    </message>
    <message>
        <source>No collision-free home pose over the plate was found.</source>
        <translation>Fant ingen kollisjonsfri hjempositur over byggeplaten.</translation>
    </message>
    <message>
        <source>Replace the cell %1?</source>
        <translation>Erstatte cellen %1?</translation>
    </message>
    <message>
        <source>Add from file…</source>
        <translation>Legg til fra fil…</translation>
    </message>
    <message>
        <source>An obstacle from a drawing: a mesh, approximated by boxes, cylinders and capsules</source>
        <translation>En hindring fra en tegning: en mesh, tilnærmet med bokser, sylindre og kapsler</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Mål…</translation>
    </message>
    <message>
        <source>Computes the body&apos;s pose from points touched at the real cell</source>
        <translation>Beregner legemets positur fra punkter målt ved berøring i den virkelige cellen</translation>
    </message>
    <message>
        <source>Collision solids</source>
        <translation>Kollisjonslegemer</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Leser %1…</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>tillegg av %1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base, axes at 0</source>
        <translation>i robotens base, akser på 0</translation>
    </message>
    <message>
        <source>measure %1</source>
        <translation>måling av %1</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>Viser legemene som brukes til kollisjonskontroll, over armen</translation>
    </message>
    <message>
        <source>searching…</source>
        <translation>søker…</translation>
    </message>
    <message>
        <source>Discard the changes to this cell?</source>
        <translation>Forkaste endringene i denne cellen?</translation>
    </message>
    <message>
        <source>The last one is: %1.</source>
        <translation>Den siste er: %1.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Forkast</translation>
    </message>
    <message>
        <source>Add place for purges</source>
        <translation>Legg til spyleplass</translation>
    </message>
    <message>
        <source>Only a nozzle on the arm goes to a place for purges</source>
        <translation>Bare en dyse på armen går til en spyleplass</translation>
    </message>
    <message>
        <source>The cell has a place for purges: select it to move it</source>
        <translation>Cellen har en spyleplass: velg den for å flytte den</translation>
    </message>
    <message>
        <source>Where the nozzle&apos;s tip is when tools are changed and nozzles purged, instead of a place that the plan chooses</source>
        <translation>Der dysespissen er når verktøy byttes og dyser spyles, i stedet for et sted planen velger</translation>
    </message>
    <message>
        <source>add the place for purges</source>
        <translation>tillegg av spyleplass</translation>
    </message>
    <message>
        <source>Bodies of the cell</source>
        <translation>Legemene i cellen</translation>
    </message>
</context>
<context>
    <name>voluta::window::ChoicesEditor</name>
    <message>
        <source>growth</source>
        <translation>vekst</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>plattform</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>celle</translation>
    </message>
    <message>
        <source>process</source>
        <translation>prosess</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>startverdi</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>celle %1</translation>
    </message>
    <message>
        <source>platform %1</source>
        <translation>plattform %1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>prosess %1</translation>
    </message>
    <message>
        <source>scale %1</source>
        <translation>skala %1</translation>
    </message>
    <message>
        <source>the part&apos;s orientation unchanged</source>
        <translation>delens orientering uendret</translation>
    </message>
    <message>
        <source>rod shape</source>
        <translation>stangform</translation>
    </message>
    <message>
        <source>way of building</source>
        <translation>byggemåte</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Velg filen…</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Bruk %1</translation>
    </message>
    <message>
        <source>Which body is printed on? If none is chosen, the plate.</source>
        <translation>Hvilket legeme printes det på? Hvis ingen er valgt, byggeplaten.</translation>
    </message>
    <message>
        <source>Choose the body…</source>
        <translation>Velg legemet…</translation>
    </message>
    <message>
        <source>Changed with it: %1.</source>
        <translation>Endret sammen med det: %1.</translation>
    </message>
    <message>
        <source>choices that fit the way of building</source>
        <translation>valg som passer byggemåten</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>The first way of building and platform without blocking findings.</source>
        <translation>Den første byggemåten og plattformen uten blokkerende funn.</translation>
    </message>
    <message>
        <source>Rejected: %1.</source>
        <translation>Forkastet: %1.</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiale</translation>
    </message>
    <message>
        <source>%1 g/cm³</source>
        <translation>%1 g/cm³</translation>
    </message>
    <message>
        <source>nozzle %1 °C</source>
        <translation>dyse %1 °C</translation>
    </message>
    <message>
        <source>plate %1 °C</source>
        <translation>byggeplate %1 °C</translation>
    </message>
    <message>
        <source>fan %1 %</source>
        <translation>vifte %1 %</translation>
    </message>
    <message>
        <source>up to %1 mm³/s</source>
        <translation>opptil %1 mm³/s</translation>
    </message>
    <message>
        <source>tool added</source>
        <translation>verktøy lagt til</translation>
    </message>
    <message>
        <source>tool removed</source>
        <translation>verktøy fjernet</translation>
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
        <translation>Kommandoer og innstillinger</translation>
    </message>
    <message>
        <source>Find a command or a setting</source>
        <translation>Finn en kommando eller innstilling</translation>
    </message>
    <message>
        <source>No command and no setting has these words.</source>
        <translation>Ingen kommando eller innstilling har disse ordene.</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareItemsDialog</name>
    <message>
        <source>Compare</source>
        <translation>Sammenlign</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Felt</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Ingen forskjeller.</translation>
    </message>
    <message>
        <source>Differing fields: %1</source>
        <translation>Ulike felter: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePage</name>
    <message>
        <source>Nothing can be compared</source>
        <translation>Ingenting kan sammenlignes</translation>
    </message>
    <message>
        <source>Adopted: %1. Press Plan.</source>
        <translation>Tatt i bruk: %1. Trykk Planlegg.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePresetsDialog</name>
    <message>
        <source>Compare presets</source>
        <translation>Sammenlign forhåndsinnstillinger</translation>
    </message>
    <message>
        <source>First preset</source>
        <translation>Første forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Second preset</source>
        <translation>Andre forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation>Innstillinger som er ulike</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Innstilling</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Ingen forskjeller.</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>Innstillinger som er ulike: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareView</name>
    <message>
        <source>way of building</source>
        <translation>byggemåte</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planlegger</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Venter</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Ikke planlagt</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestått</translation>
    </message>
    <message>
        <source>No blocking findings</source>
        <translation>Ingen blokkerende funn</translation>
    </message>
    <message>
        <source>Blocked: %1</source>
        <translation>Blokkert: %1</translation>
    </message>
    <message>
        <source>Cannot be planned</source>
        <translation>Kan ikke planlegges</translation>
    </message>
    <message>
        <source>Planned in %1</source>
        <translation>Planlagt på %1</translation>
    </message>
    <message>
        <source>Out of date: the part or its settings have changed since.</source>
        <translation>Utdatert: delen eller innstillingene er endret siden.</translation>
    </message>
    <message>
        <source>Best: %1.</source>
        <translation>Best: %1.</translation>
    </message>
    <message>
        <source>As good: %1.</source>
        <translation>Like gode: %1.</translation>
    </message>
    <message>
        <source>None is best: all of them are blocked.</source>
        <translation>Ingen er best: alle er blokkert.</translation>
    </message>
    <message>
        <source>Which way of building suits this part?
Tick the ways to compare at the right, then press Compare.</source>
        <translation>Hvilken byggemåte passer denne delen?
Kryss av måtene som skal sammenlignes, til høyre, og trykk Sammenlign.</translation>
    </message>
    <message>
        <source>Adopt this way</source>
        <translation>Bruk denne måten</translation>
    </message>
    <message>
        <source>Builds the part as in the selected row; can be undone</source>
        <translation>Bygger delen som i den valgte raden; kan angres</translation>
    </message>
</context>
<context>
    <name>voluta::window::CopiesDialog</name>
    <message>
        <source>Number of copies</source>
        <translation>Antall kopier</translation>
    </message>
    <message>
        <source>Number of these parts on the plate; all parts are arranged anew</source>
        <translation>Antall av disse delene på byggeplaten; alle deler ordnes på nytt</translation>
    </message>
    <message>
        <source>&amp;Copies on the plate</source>
        <translation>&amp;Kopier på byggeplaten</translation>
    </message>
    <message>
        <source>&amp;Fill the plate</source>
        <translation>&amp;Fyll byggeplaten</translation>
    </message>
    <message>
        <source>As many copies as the plate has room for</source>
        <translation>Så mange kopier som byggeplaten har plass til</translation>
    </message>
</context>
<context>
    <name>voluta::window::CutTool</name>
    <message>
        <source>Calculating…</source>
        <translation>Beregner…</translation>
    </message>
    <message>
        <source>Lower half %1 cm³, upper half %2 cm³.</source>
        <translation>Nedre halvdel %1 cm³, øvre halvdel %2 cm³.</translation>
    </message>
    <message>
        <source>Pins: %1.</source>
        <translation>Pinner: %1.</translation>
    </message>
    <message>
        <source>Cutting…</source>
        <translation>Skjærer…</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Skjær</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Skjær %1</translation>
    </message>
    <message>
        <source>dowel</source>
        <translation>dybel</translation>
    </message>
    <message>
        <source>Split to parts</source>
        <translation>Del opp i deler</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Del opp %1</translation>
    </message>
    <message>
        <source>The mesh has more than %1 bodies.</source>
        <translation>Nettet har mer enn %1 legemer.</translation>
    </message>
    <message>
        <source>The part is one body.</source>
        <translation>Delen er ett legeme.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n del</numerusform>
            <numerusform>%n deler</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Their regions have moved with them.</source>
        <translation>%1. Regionene deres har flyttet seg med dem.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ExportPage</name>
    <message>
        <source>Open a part first.</source>
        <translation>Åpne en del først.</translation>
    </message>
    <message>
        <source>Planning is in progress.</source>
        <translation>Planlegging pågår.</translation>
    </message>
    <message>
        <source>Nothing has been planned yet. Press Plan.</source>
        <translation>Ingenting er planlagt ennå. Trykk Planlegg.</translation>
    </message>
    <message>
        <source>Programs are not saved in a project. Press Plan to generate them.</source>
        <translation>Programmer lagres ikke i et prosjekt. Trykk Planlegg for å generere dem.</translation>
    </message>
    <message>
        <source>The programs are out of date. Press Plan.</source>
        <translation>Programmene er utdaterte. Trykk Planlegg.</translation>
    </message>
    <message>
        <source>program formats</source>
        <translation>programformater</translation>
    </message>
    <message>
        <source>Files written to %1: %2</source>
        <translation>Filer skrevet til %1: %2</translation>
    </message>
    <message>
        <source>; refused and not written: %1</source>
        <translation>; avvist og ikke skrevet: %1</translation>
    </message>
    <message>
        <source>; the reports have no pictures: %1</source>
        <translation>; rapportene har ingen bilder: %1</translation>
    </message>
    <message>
        <source>The files are being written.</source>
        <translation>Filene skrives.</translation>
    </message>
    <message>
        <source>Nothing was exported</source>
        <translation>Ingenting ble eksportert</translation>
    </message>
    <message>
        <source>The replay refused all programs: %1.</source>
        <translation>Gjenspillingen avviste alle programmer: %1.</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>Erstatte filer?</translation>
    </message>
    <message>
        <source>These files already exist in %1:</source>
        <translation>Disse filene finnes allerede i %1:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstatt</translation>
    </message>
    <message>
        <source>This is the rest of a print made with other settings. Undo the change: Plan would plan the whole part again.</source>
        <translation>Dette er resten av en print laget med andre innstillinger. Angre endringen: Planlegg ville planlegge hele delen på nytt.</translation>
    </message>
    <message>
        <source>Slower on the controller by %1 s</source>
        <translation>%1 s langsommere på styringen</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>Linje %1, %2</translation>
    </message>
    <message>
        <source>Verify a program</source>
        <translation>Verifiser et program</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle filer (*)</translation>
    </message>
    <message>
        <source>Cannot open %1</source>
        <translation>Kan ikke åpne %1</translation>
    </message>
    <message>
        <source>No program on this computer is set up to open it.</source>
        <translation>Det er ikke satt opp noe program på denne datamaskinen som kan åpne den.</translation>
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
        <translation>Lengden på filmen. Hele utskriften vises, med like steg</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisk</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Foran</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Høyre</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Topp</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Lengde</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Størrelse</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visning</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>Lagr&amp;e…</translation>
    </message>
    <message>
        <source>Save the film</source>
        <translation>Lagre filmen</translation>
    </message>
    <message>
        <source>Films (*.webm)</source>
        <translation>Filmer (*.webm)</translation>
    </message>
</context>
<context>
    <name>voluta::window::FlowBar</name>
    <message>
        <source>nothing yet</source>
        <translation>ingenting ennå</translation>
    </message>
    <message>
        <source>running</source>
        <translation>kjører</translation>
    </message>
    <message>
        <source>done</source>
        <translation>ferdig</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>utdatert</translation>
    </message>
    <message>
        <source>blocked: see the findings</source>
        <translation>blokkert: se funnene</translation>
    </message>
    <message>
        <source>not as asked or not checked: see the findings</source>
        <translation>ikke som ønsket eller ikke kontrollert: se funnene</translation>
    </message>
</context>
<context>
    <name>voluta::window::HeadNumbersDialog</name>
    <message>
        <source>Head from a few numbers</source>
        <translation>Hode fra noen få tall</translation>
    </message>
    <message>
        <source>The head contains the corners of the square block.</source>
        <translation>Hodet omfatter hjørnene på den firkantede blokken.</translation>
    </message>
    <message>
        <source>Use this head</source>
        <translation>Bruk dette hodet</translation>
    </message>
</context>
<context>
    <name>voluta::window::Jogging</name>
    <message>
        <source>Collision: %1 and %2</source>
        <translation>Kollisjon: %1 og %2</translation>
    </message>
    <message>
        <source>Free: more than %1 mm between bodies</source>
        <translation>Fritt: mer enn %1 mm mellom legemene</translation>
    </message>
    <message>
        <source>Free: %1 mm between the nearest bodies</source>
        <translation>Fritt: %1 mm mellom de nærmeste legemene</translation>
    </message>
    <message>
        <source>The arm does not reach that pose within its joint limits. It stays here.</source>
        <translation>Armen når ikke den stillingen innenfor leddgrensene. Den blir stående her.</translation>
    </message>
    <message>
        <source>The printed part is not checked yet.</source>
        <translation>Den utskrevne delen er ikke kontrollert ennå.</translation>
    </message>
    <message>
        <source>Checking the pose…</source>
        <translation>Kontrollerer stillingen…</translation>
    </message>
</context>
<context>
    <name>voluta::window::JoinedMachines</name>
    <message>
        <source>Machine %1</source>
        <translation>Maskin %1</translation>
    </message>
    <message>
        <source>Waits %1 for machine %2</source>
        <translation>Venter %1 på maskin %2</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayerEventDialog</name>
    <message>
        <source>Event before layer %1</source>
        <translation>Hendelse før lag %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Venting</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Utgang</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Verktøy</translation>
    </message>
    <message>
        <source>Own statement</source>
        <translation>Egen setning</translation>
    </message>
    <message>
        <source>Shown to the operator; the arm waits until the operator continues</source>
        <translation>Vises til operatøren; armen venter til operatøren fortsetter</translation>
    </message>
    <message>
        <source>This line is written into programs of the format. Nothing checks it</source>
        <translation>Denne linjen skrives inn i programmer i formatet. Ingenting kontrollerer den</translation>
    </message>
    <message>
        <source>On</source>
        <translation>På</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>&amp;Hendelse</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>Te&amp;kst</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Varighet</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>&amp;Nummer</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>Verk&amp;tøy</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>&amp;Linje</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>The camera&apos;s output is on for this long; the arm waits beside the part</source>
        <translation>Kameraets utgang er på så lenge; armen venter ved siden av delen</translation>
    </message>
    <message>
        <source>Change of filament</source>
        <translation>Filamentbytte</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayersPage</name>
    <message>
        <source>Replaying growth: all layers shown</source>
        <translation>Spiller av veksten: alle lag vises</translation>
    </message>
    <message>
        <source>Pieces are always shown whole</source>
        <translation>Stykker vises alltid hele</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>Hendelse før dette laget…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>En pause, en venting, en utgang, et annet verktøy eller en egen linje</translation>
    </message>
</context>
<context>
    <name>voluta::window::LegendView</name>
    <message>
        <source>Click to show these beads</source>
        <translation>Klikk for å vise disse strengene</translation>
    </message>
    <message>
        <source>Click to hide these beads</source>
        <translation>Klikk for å skjule disse strengene</translation>
    </message>
</context>
<context>
    <name>voluta::window::LibraryDialog</name>
    <message>
        <source>Processes and materials</source>
        <translation>Prosesser og materialer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Lagre</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Forkast endringer</translation>
    </message>
    <message>
        <source>Use in this job</source>
        <translation>Bruk i denne jobben</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Sammenlign…</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Prosesser</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliser</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Gi nytt navn…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Slett…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksporter…</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>From a few numbers…</source>
        <translation>Fra noen få tall…</translation>
    </message>
    <message>
        <source>From a mesh…</source>
        <translation>Fra en mesh…</translation>
    </message>
    <message>
        <source>A drawing of the head with its nozzle pointing down: the largest radius at each height</source>
        <translation>En tegning av hodet med dysen pekende nedover: den største radien i hver høyde</translation>
    </message>
    <message>
        <source>%1 (in this job)</source>
        <translation>%1 (i denne jobben)</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Følger med programmet</translation>
    </message>
    <message>
        <source>Stored in this job</source>
        <translation>Lagret i denne jobben</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Egen</translation>
    </message>
    <message>
        <source>Comes with the program. Duplicate it to change it.</source>
        <translation>Følger med programmet. Dupliser for å endre.</translation>
    </message>
    <message>
        <source>Stored in this job, not in your library. Duplicate it to keep it.</source>
        <translation>Lagret i denne jobben, ikke i biblioteket ditt. Dupliser for å beholde.</translation>
    </message>
    <message>
        <source>Your own.</source>
        <translation>Egen.</translation>
    </message>
    <message>
        <source>Your own, based on %1; fields that differ are marked.</source>
        <translation>Egen, basert på %1; felter som avviker, er merket.</translation>
    </message>
    <message>
        <source>Cannot be saved: %1 %2</source>
        <translation>Kan ikke lagres: %1 %2</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Hode</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Ikke lagret ennå.</translation>
    </message>
    <message>
        <source>Save and use in this job</source>
        <translation>Lagre og bruk i denne jobben</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Gi nytt navn</translation>
    </message>
    <message>
        <source>Small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;:</source>
        <translation>Små bokstaver, sifre, &apos;-&apos;, &apos;_&apos; og &apos;.&apos;:</translation>
    </message>
    <message>
        <source>There is another &apos;%1&apos;.</source>
        <translation>Det finnes en annen &apos;%1&apos;.</translation>
    </message>
    <message>
        <source>Delete %1 and its file?</source>
        <translation>Slette %1 og filen?</translation>
    </message>
    <message>
        <source>Import a process</source>
        <translation>Importer en prosess</translation>
    </message>
    <message>
        <source>Import a material</source>
        <translation>Importer et materiale</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON-filer (*.json);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Replace your own %1?</source>
        <translation>Erstatte din egen %1?</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Eksporter %1</translation>
    </message>
    <message>
        <source>JSON files (*.json)</source>
        <translation>JSON-filer (*.json)</translation>
    </message>
    <message>
        <source>Head from a mesh</source>
        <translation>Hode fra en mesh</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>Lagre endringene?</translation>
    </message>
    <message>
        <source>The job uses another version of this process.</source>
        <translation>Jobben bruker en annen versjon av denne prosessen.</translation>
    </message>
    <message>
        <source>Sizes from a measured plate…</source>
        <translation>Mål fra en oppmålt plate…</translation>
    </message>
    <message>
        <source>Corrects the sizes of flat layers by those of a printed accuracy plate</source>
        <translation>Korrigerer målene på flate lag etter en printet nøyaktighetsplate</translation>
    </message>
    <message>
        <source>Does the nozzle point up in the drawing?</source>
        <translation>Peker dysen oppover på tegningen?</translation>
    </message>
    <message>
        <source>Turn it over</source>
        <translation>Snu det</translation>
    </message>
    <message>
        <source>Use it as drawn</source>
        <translation>Bruk som tegnet</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesher (%1);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Your own. It follows %1 in all fields that are not marked.</source>
        <translation>Egen. Følger %1 i alle felter som ikke er merket.</translation>
    </message>
</context>
<context>
    <name>voluta::window::LogDialog</name>
    <message>
        <source>Log</source>
        <translation>Logg</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kan ikke leses: %2.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Åpne mappen</translation>
    </message>
    <message>
        <source>No program on this computer opens the folder %1.</source>
        <translation>Det er ikke noe program på denne datamaskinen som åpner mappen %1.</translation>
    </message>
</context>
<context>
    <name>voluta::window::MachineTable</name>
    <message>
        <source>Job</source>
        <translation>Jobb</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotasjon</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Maskiner</translation>
    </message>
</context>
<context>
    <name>voluta::window::MainWindow</name>
    <message>
        <source>Part and cell</source>
        <translation>Del og celle</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Funn</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Lagre bildet</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kan ikke skrives. Velg en annen mappe.</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Stang</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 deler</translation>
    </message>
    <message>
        <source>Saved the film %1</source>
        <translation>Lagret filmen %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Håndbok</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Søk i håndboken</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Innhold</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Side i håndboken</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Tilbake</translation>
    </message>
</context>
<context>
    <name>voluta::window::MeasureDialog</name>
    <message>
        <source>One point per row, in mm, %1. Three rows x, y, z: origin, a point on X, a point in the XY plane. Or at least three rows of six: nominal point, touched point.</source>
        <translation>Ett punkt per rad, i mm, %1. Tre rader x, y, z: origo, et punkt på X, et punkt i XY-planet. Eller minst tre rader med seks: nominelt punkt, målt punkt.</translation>
    </message>
    <message>
        <source>At least four poses in which the tip touches the same point, tilted to different sides, one per row: the robot&apos;s joints, or x, y, z, qw, qx, qy, qz of the flange.</source>
        <translation>Minst fire positurer der spissen berører samme punkt, tiltet til ulike sider, én per rad: robotens ledd, eller x, y, z, qw, qx, qy, qz for flensen.</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Mål %1</translation>
    </message>
    <message>
        <source>Use this frame</source>
        <translation>Bruk dette koordinatsystemet</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rader</translation>
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
        <translation>Rund kant: radius %1, diameter %2</translation>
    </message>
    <message>
        <source>Round face: radius %1, diameter %2</source>
        <translation>Rund flate: radius %1, diameter %2</translation>
    </message>
    <message>
        <source>Ball: radius %1, diameter %2</source>
        <translation>Kule: radius %1, diameter %2</translation>
    </message>
    <message>
        <source>Corner: X %1, Y %2, Z %3</source>
        <translation>Hjørne: X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kant</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Flate</translation>
    </message>
    <message>
        <source>Wall behind the face: %1</source>
        <translation>Vegg bak flaten: %1</translation>
    </message>
    <message>
        <source>Distance: %1</source>
        <translation>Avstand: %1</translation>
    </message>
    <message>
        <source>X %1, Y %2, Z %3</source>
        <translation>X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Distance of the parallel faces: %1</source>
        <translation>Avstand mellom de parallelle flatene: %1</translation>
    </message>
    <message>
        <source>Angle: %1°</source>
        <translation>Vinkel: %1°</translation>
    </message>
    <message>
        <source>Click a corner, an edge or a face of the part.</source>
        <translation>Klikk på et hjørne, en kant eller en flate på delen.</translation>
    </message>
    <message>
        <source>Click a second place for distance and angle.</source>
        <translation>Klikk på et andre sted for avstand og vinkel.</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillDialog</name>
    <message>
        <source>Mill %1 from a block</source>
        <translation>Fres %1 fra et emne</translation>
    </message>
    <message>
        <source>Save G-code…</source>
        <translation>Lagre G-kode…</translation>
    </message>
    <message>
        <source>Compute passes</source>
        <translation>Beregn pass</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Milled block</source>
        <translation>Frest emne</translation>
    </message>
    <message>
        <source>Computing the passes and running them on the block…</source>
        <translation>Beregner passene og kjører dem på emnet…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Avbrutt.</translation>
    </message>
    <message>
        <source>Values have changed: compute the passes again.</source>
        <translation>Verdier er endret: beregn passene på nytt.</translation>
    </message>
    <message>
        <source>Passed: the program was read back and run on the block.</source>
        <translation>Bestått: programmet ble lest tilbake og kjørt på emnet.</translation>
    </message>
    <message>
        <source>Refused: %1 (%2)</source>
        <translation>Avvist: %1 (%2)</translation>
    </message>
    <message>
        <source>Block %1 × %2 × %3 mm</source>
        <translation>Emne %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Time %1, %2 moves</source>
        <translation>Tid %1, %2 bevegelser</translation>
    </message>
    <message>
        <source>Removed %1 of %2 cm³</source>
        <translation>Fjernet %1 av %2 cm³</translation>
    </message>
    <message>
        <source>Left on the part: at most %1 mm</source>
        <translation>Igjen på delen: høyst %1 mm</translation>
    </message>
    <message>
        <source>Missing from the part: at most %1 mm</source>
        <translation>Mangler på delen: høyst %1 mm</translation>
    </message>
    <message>
        <source>Save the G-code</source>
        <translation>Lagre G-koden</translation>
    </message>
    <message>
        <source>G-code (*.nc)</source>
        <translation>G-kode (*.nc)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message>
        <source>Not complete: %1 (%2)</source>
        <translation>Ikke fullstendig: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillForm</name>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Tenner</translation>
    </message>
    <message>
        <source>Lay the part down</source>
        <translation>Legg delen ned</translation>
    </message>
    <message>
        <source>Turns the part so that the least material is milled away; otherwise it keeps its orientation on the plate</source>
        <translation>Roterer delen slik at minst materiale freses bort; ellers beholder den orienteringen fra byggeplaten</translation>
    </message>
    <message>
        <source>%1 rpm, feed %2 mm/min, lines every %3 mm, fine passes of %4 mm</source>
        <translation>%1 o/min, mating %2 mm/min, linjer hver %3 mm, finpass på %4 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObjectMenus</name>
    <message>
        <source>Show its place</source>
        <translation>Vis stedet</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Kopier teksten</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Skjul</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Vis alt</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Vis bare dette</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Innstillinger</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksporter…</translation>
    </message>
    <message>
        <source>Select this part</source>
        <translation>Velg denne delen</translation>
    </message>
    <message>
        <source>Show all beads</source>
        <translation>Vis alle strenger</translation>
    </message>
    <message>
        <source>Show only layer %1</source>
        <translation>Vis bare lag %1</translation>
    </message>
    <message>
        <source>Show up to layer %1</source>
        <translation>Vis til og med lag %1</translation>
    </message>
    <message>
        <source>Show all layers</source>
        <translation>Vis alle lag</translation>
    </message>
    <message>
        <source>Go to this moment</source>
        <translation>Gå til dette øyeblikket</translation>
    </message>
    <message>
        <source>Hide beads of this kind</source>
        <translation>Skjul strenger av denne typen</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Filens enhet</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>tomme</translation>
    </message>
    <message>
        <source>unit of the file</source>
        <translation>filens enhet</translation>
    </message>
    <message>
        <source>Repair the mesh</source>
        <translation>Reparer nettet</translation>
    </message>
    <message>
        <source>repair the mesh</source>
        <translation>reparer nettet</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>nettet som lest</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObstacleImport</name>
    <message>
        <source>Obstacle from a file</source>
        <translation>Hindring fra fil</translation>
    </message>
    <message>
        <source>%1 is %2 mm long. Was it drawn in metres?</source>
        <translation>%1 er %2 mm lang. Ble den tegnet i meter?</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Mesher (%1);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::PageStack</name>
    <message>
        <source>Preview</source>
        <translation>Forhåndsvisning</translation>
    </message>
    <message>
        <source>Layers, paths and programs are not up to date yet: press Plan.</source>
        <translation>Lag, baner og programmer er ikke oppdatert ennå: trykk Planlegg.</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Utdatert</translation>
    </message>
    <message>
        <source>The settings have changed since: press Plan.</source>
        <translation>Innstillingene er endret siden: trykk Planlegg.</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Lag %1</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totalt</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartHandles</name>
    <message>
        <source>drop to plate</source>
        <translation>senking til byggeplaten</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>sentrering</translation>
    </message>
    <message>
        <source>lay on face</source>
        <translation>legging på flate</translation>
    </message>
    <message>
        <source>place on touched points</source>
        <translation>plassering på målte punkter</translation>
    </message>
    <message>
        <source>move</source>
        <translation>flytting</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotasjon</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartsView</name>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>Ordne deler</translation>
    </message>
    <message>
        <source>Arranging the copies…</source>
        <translation>Ordner kopiene…</translation>
    </message>
    <message>
        <source>Number of copies</source>
        <translation>Antall kopier</translation>
    </message>
    <message numerus="yes">
        <source>%n copies on the plate</source>
        <translation>
            <numerusform>%n kopi på byggeplaten</numerusform>
            <numerusform>%n kopier på byggeplaten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>voluta::window::PictureArea</name>
    <message>
        <source>The viewport needs OpenGL 3.2; this display offers %1. Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export work without a picture.</source>
        <translation>3D-visningen trenger OpenGL 3.2; denne skjermen tilbyr %1. Oppdater grafikkdriveren, eller sett LIBGL_ALWAYS_SOFTWARE=1. Planlegging og eksport virker uten bilde.</translation>
    </message>
</context>
<context>
    <name>voluta::window::PieceCuts</name>
    <message>
        <source>keep cuts</source>
        <translation>bevaring av kutt</translation>
    </message>
    <message>
        <source>search for cuts</source>
        <translation>søk etter kutt</translation>
    </message>
    <message>
        <source>move cut</source>
        <translation>flytting av kutt</translation>
    </message>
    <message>
        <source>pick root</source>
        <translation>valg av rot</translation>
    </message>
</context>
<context>
    <name>voluta::window::PreparePage</name>
    <message>
        <source>repair the mesh</source>
        <translation>reparasjon av meshen</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>mesh som lest</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Innstillinger</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>celle</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Rediger celle</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetBar</name>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (endret)</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Save, compare, export or import presets</source>
        <translation>Lagre, sammenlign, eksporter eller importer forhåndsinnstillinger</translation>
    </message>
    <message>
        <source>Preset menu</source>
        <translation>Meny for forhåndsinnstillinger</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetEditor</name>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON-filer (*.json);;Alle filer (*)</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>I dette prosjektet</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>Med programmet</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Dine egne</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Forhåndsinnstillinger</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1: %2 i stedet for %3</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>og %n til</numerusform>
            <numerusform>og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>Change preset</source>
        <translation>Bytt forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Settings of the preset were changed. Take the changes to %1?</source>
        <translation>Innstillinger i forhåndsinnstillingen er endret. Ta endringene med til %1?</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>&amp;Overfør</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Forkast</translation>
    </message>
    <message>
        <source>&amp;Keep this preset</source>
        <translation>&amp;Behold denne forhåndsinnstillingen</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Forhåndsinnstilling %1</translation>
    </message>
    <message>
        <source>Save preset %1</source>
        <translation>Lagre forhåndsinnstillingen %1</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1, egen</translation>
    </message>
    <message>
        <source>Save preset as</source>
        <translation>Lagre forhåndsinnstilling som</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Gi forhåndsinnstillingen nytt navn</translation>
    </message>
    <message>
        <source>Rename preset %1</source>
        <translation>Gi forhåndsinnstillingen %1 nytt navn</translation>
    </message>
    <message>
        <source>Delete preset</source>
        <translation>Slett forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Delete the preset %1? The settings of this project stay.</source>
        <translation>Slette forhåndsinnstillingen %1? Innstillingene i dette prosjektet blir stående.</translation>
    </message>
    <message>
        <source>Delete preset %1</source>
        <translation>Slett forhåndsinnstillingen %1</translation>
    </message>
    <message>
        <source>Discard changes of the preset</source>
        <translation>Forkast endringene i forhåndsinnstillingen</translation>
    </message>
    <message>
        <source>Present settings</source>
        <translation>Gjeldende innstillinger</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Eksporter %1</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Importer en forhåndsinnstilling</translation>
    </message>
    <message>
        <source>Replace your own preset %1?</source>
        <translation>Erstatte din egen forhåndsinnstilling %1?</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetNameDialog</name>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Lagre</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Gi nytt navn</translation>
    </message>
</context>
<context>
    <name>voluta::window::ProjectFiles</name>
    <message>
        <source>settings of the sample</source>
        <translation>innstillinger for eksemplet</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Åpner %1</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Klar. Trykk Planlegg.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Avbrutt.</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 kan ikke åpnes</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 er ikke lagret</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Åpne nylige</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpne</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>Åpnet %1</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Lagre prosjektet</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Voluta-prosjekter (*.voluta)</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Gjenopprett ulagret arbeid</translation>
    </message>
    <message>
        <source>Voluta ended unexpectedly. A copy of “%1” was saved on %2.</source>
        <translation>Voluta ble avsluttet uventet. En kopi av «%1» ble lagret %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Gjenopprett</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Forkast</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Senere</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ulagrede endringer</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>«%1» har ulagrede endringer.</translation>
    </message>
    <message>
        <source>Resume from here?</source>
        <translation>Gjenoppta herfra?</translation>
    </message>
    <message>
        <source>%1 % of the material counts as printed. The rest of “%2” opens as a new project.</source>
        <translation>%1 % av materialet regnes som printet. Resten av «%2» åpnes som et nytt prosjekt.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Gjenoppta</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Importer en robotarm</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf *.xml);;All files (*)</source>
        <translation>Robotbeskrivelser (*.urdf *.xml);;Alle filer (*)</translation>
    </message>
    <message>
        <source>No folder for your own robots: set HOME.</source>
        <translation>Ingen mappe for egne roboter: sett HOME.</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>celle</translation>
    </message>
    <message>
        <source>Imported: cell %1</source>
        <translation>Importert: celle %1</translation>
    </message>
    <message>
        <source>Add part</source>
        <translation>Legg til del</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>Deler (%1);;Alle filer (*)</translation>
    </message>
    <message>
        <source>One part?</source>
        <translation>Én del?</translation>
    </message>
    <message>
        <source>“%1” and “%2” in “%3” touch. Open the file as one part?</source>
        <translation>«%1» og «%2» i «%3» berører hverandre. Åpne filen som én del?</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>Én del</translation>
    </message>
    <message>
        <source>Several parts</source>
        <translation>Flere deler</translation>
    </message>
    <message>
        <source>Add or replace?</source>
        <translation>Legge til eller erstatte?</translation>
    </message>
    <message>
        <source>Add “%1” beside “%2”, or open it instead?</source>
        <translation>Legge til «%1» ved siden av «%2», eller åpne den i stedet?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Legg til</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstatt</translation>
    </message>
    <message>
        <source>Parts and projects (%1);;All files (*)</source>
        <translation>Deler og prosjekter (%1);;Alle filer (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::QuoteDialog</name>
    <message>
        <source>Quote</source>
        <translation>Tilbud</translation>
    </message>
    <message>
        <source>Price of each print, whatever its size</source>
        <translation>Pris for hver utskrift, uansett størrelse</translation>
    </message>
    <message>
        <source>Added to the cost</source>
        <translation>Legges til kostnaden</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kostnad</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Post</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Beløp</translation>
    </message>
    <message>
        <source>Machine, per hour</source>
        <translation>Maskin, per time</translation>
    </message>
    <message>
        <source>Set-up, per print</source>
        <translation>Oppsett, per utskrift</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Påslag</translation>
    </message>
    <message>
        <source>Save page…</source>
        <translation>Lagre siden…</translation>
    </message>
    <message>
        <source>A page for the customer, as PDF or HTML</source>
        <translation>En side til kunden, som PDF eller HTML</translation>
    </message>
    <message>
        <source>%1 g at %2 per kg</source>
        <translation>%1 g à %2 per kg</translation>
    </message>
    <message>
        <source>%1 g; its price is not known</source>
        <translation>%1 g; prisen er ukjent</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maskin</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Oppsett</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Plan the part first.</source>
        <translation>Planlegg delen først.</translation>
    </message>
    <message>
        <source>Enter the price of the material under Processes and materials.</source>
        <translation>Oppgi prisen på materialet under Prosesser og materialer.</translation>
    </message>
    <message>
        <source>Save page</source>
        <translation>Lagre siden</translation>
    </message>
    <message>
        <source>%1 quote</source>
        <translation>%1 tilbud</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;HTML (*.html)</source>
        <translation>PDF (*.pdf);;HTML (*.html)</translation>
    </message>
    <message>
        <source>Drawing the part…</source>
        <translation>Tegner delen…</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Lagret som %1.</translation>
    </message>
    <message>
        <source>Price of an hour of the machine, with power and operator; each cell has its own</source>
        <translation>Pris for en maskintime, med strøm og operatør; hver celle har sin egen</translation>
    </message>
</context>
<context>
    <name>voluta::window::ReachView</name>
    <message>
        <source>move to best place</source>
        <translation>flytting til beste sted</translation>
    </message>
</context>
<context>
    <name>voluta::window::RegionsTool</name>
    <message>
        <source>Move region</source>
        <translation>Flytt region</translation>
    </message>
    <message>
        <source>Paint region</source>
        <translation>Mal region</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Legg til region</translation>
    </message>
    <message>
        <source>Body of a region</source>
        <translation>Legeme for en region</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Nett (%1);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Leser %1…</translation>
    </message>
    <message>
        <source>Nothing is painted yet: the region has no effect.</source>
        <translation>Ingenting er malt ennå: regionen har ingen virkning.</translation>
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
        <translation>Ikke dekket</translation>
    </message>
    <message>
        <source>Printed in the air</source>
        <translation>Skrevet ut i luften</translation>
    </message>
    <message>
        <source>Overfilled</source>
        <translation>Overfylt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Applied: %1</source>
        <translation>Brukt: %1</translation>
    </message>
    <message>
        <source>It cannot be planned this way. Undo it, or try another remedy.</source>
        <translation>Det kan ikke planlegges slik. Angre, eller prøv et annet tiltak.</translation>
    </message>
    <message>
        <source>The figures follow when the plan is done.</source>
        <translation>Tallene kommer når planen er ferdig.</translation>
    </message>
    <message>
        <source>Plan to see its effect.</source>
        <translation>Planlegg for å se virkningen.</translation>
    </message>
    <message>
        <source>No longer found</source>
        <translation>Ikke lenger funnet</translation>
    </message>
    <message>
        <source>Unchanged: %1</source>
        <translation>Uendret: %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Før: %1</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Etter: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::RunDialog</name>
    <message>
        <source>Path %1 mm over %2 mm</source>
        <translation>Bane %1 mm over %2 mm</translation>
    </message>
    <message>
        <source>Speed %1 % over %2 mm</source>
        <translation>Hastighet %1 % over %2 mm</translation>
    </message>
    <message>
        <source>Flow %1 % over %2 mm</source>
        <translation>Materialstrøm %1 % over %2 mm</translation>
    </message>
    <message>
        <source>%1 mm of beads are missing</source>
        <translation>%1 mm streng mangler</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>Verste steder</translation>
    </message>
    <message>
        <source>Recorded run %1</source>
        <translation>Registrert kjøring %1</translation>
    </message>
    <message>
        <source>Comparing the record with the current plan…</source>
        <translation>Sammenligner registreringen med gjeldende plan…</translation>
    </message>
    <message>
        <source>Flow, recorded: mean %1 %, from %2 to %3 %</source>
        <translation>Materialstrøm, registrert: snitt %1 %, fra %2 til %3 %</translation>
    </message>
    <message>
        <source>Flow at this speed: mean %1 %, from %2 to %3 %</source>
        <translation>Materialstrøm ved denne hastigheten: snitt %1 %, fra %2 til %3 %</translation>
    </message>
    <message>
        <source>Path: mean %1 mm, greatest %2 mm</source>
        <translation>Bane: snitt %1 mm, størst %2 mm</translation>
    </message>
    <message>
        <source>Speed: mean %1 %, from %2 to %3 %</source>
        <translation>Hastighet: snitt %1 %, fra %2 til %3 %</translation>
    </message>
    <message>
        <source>Beads recorded: %1 of %2 mm</source>
        <translation>Registrerte strenger: %1 av %2 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::Runs</name>
    <message>
        <source>1 voxel, %1 missed</source>
        <translation>1 voksel, %1 tapt</translation>
    </message>
    <message>
        <source>%1 voxels, %2 missed</source>
        <translation>%1 voksler, %2 tapt</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 lag</translation>
    </message>
    <message>
        <source>1 waypoint</source>
        <translation>1 banepunkt</translation>
    </message>
    <message>
        <source>%1 waypoints</source>
        <translation>%1 banepunkter</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>replay passed</source>
        <translation>gjenspilling bestått</translation>
    </message>
    <message>
        <source>replay not passed</source>
        <translation>gjenspilling ikke bestått</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Klar. Trykk Planlegg.</translation>
    </message>
    <message>
        <source>Done. Blocking findings: %1.</source>
        <translation>Ferdig. Blokkerende funn: %1.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Ferdig.</translation>
    </message>
    <message>
        <source>Pieces updated. Press Plan for layers and paths.</source>
        <translation>Stykker oppdatert. Trykk Planlegg for lag og baner.</translation>
    </message>
    <message>
        <source>Voxels updated. Press Plan for layers and paths.</source>
        <translation>Voksler oppdatert. Trykk Planlegg for lag og baner.</translation>
    </message>
    <message>
        <source>Press Plan for layers and paths.</source>
        <translation>Trykk Planlegg for lag og baner.</translation>
    </message>
    <message>
        <source>Compared. Select a row to adopt it.</source>
        <translation>Sammenlignet. Velg en rad for å ta den i bruk.</translation>
    </message>
    <message>
        <source>Preview: %1, 1 growth step</source>
        <translation>Forhåndsvisning: %1, 1 veksttrinn</translation>
    </message>
    <message>
        <source>Preview: %1, %2 growth steps</source>
        <translation>Forhåndsvisning: %1, %2 veksttrinn</translation>
    </message>
    <message>
        <source>Preview: %1, improving layers</source>
        <translation>Forhåndsvisning: %1, lagene forbedres</translation>
    </message>
    <message>
        <source>Preview: %1. Press Plan.</source>
        <translation>Forhåndsvisning: %1. Trykk Planlegg.</translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation>Utdatert: %1</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 stykke</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 stykker</translation>
    </message>
    <message>
        <source>%1 mm² need support</source>
        <translation>%1 mm² trenger støtte</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 lag</translation>
    </message>
    <message>
        <source>Cancelled. The previous results are still shown.</source>
        <translation>Avbrutt. De forrige resultatene vises fortsatt.</translation>
    </message>
    <message>
        <source>Cancelled. Press Plan to start again.</source>
        <translation>Avbrutt. Trykk Planlegg for å starte på nytt.</translation>
    </message>
    <message>
        <source>The run failed: see the findings.</source>
        <translation>Kjøringen mislyktes: se funnene.</translation>
    </message>
    <message>
        <source>Cannot plan: correct the marked setting.</source>
        <translation>Kan ikke planlegge: rett den merkede innstillingen.</translation>
    </message>
    <message>
        <source>planned time %1</source>
        <translation>planlagt tid %1</translation>
    </message>
    <message>
        <source>time on the controller %1</source>
        <translation>tid på styringen %1</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 deler</translation>
    </message>
    <message>
        <source>1 tool change</source>
        <translation>1 verktøybytte</translation>
    </message>
    <message>
        <source>%1 tool changes</source>
        <translation>%1 verktøybytter</translation>
    </message>
    <message>
        <source>not passed: blocking findings</source>
        <translation>ikke bestått: blokkerende funn</translation>
    </message>
    <message>
        <source>safe to run, not as asked</source>
        <translation>trygt å kjøre, ikke som ønsket</translation>
    </message>
    <message>
        <source>Done. Safe to run, not as asked: %1.</source>
        <translation>Ferdig. Trygt å kjøre, ikke som ønsket: %1.</translation>
    </message>
    <message>
        <source>safe to run but for your own statements</source>
        <translation>trygt å kjøre, bortsett fra egne setninger</translation>
    </message>
    <message>
        <source>Done. Safe to run but for your own statements.</source>
        <translation>Ferdig. Trygt å kjøre, bortsett fra egne setninger.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ShortcutsDialog</name>
    <message>
        <source>Keys</source>
        <translation>Snarveier</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Søk</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Kommando</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Snarvei</translation>
    </message>
    <message>
        <source>Default key</source>
        <translation>Standardsnarvei</translation>
    </message>
    <message>
        <source>New key:</source>
        <translation>Ny snarvei:</translation>
    </message>
    <message>
        <source>This key was removed from “%1”.</source>
        <translation>Denne snarveien ble fjernet fra «%1».</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Ny tast</translation>
    </message>
</context>
<context>
    <name>voluta::window::SimulatePage</name>
    <message>
        <source>Collision solids</source>
        <translation>Kollisjonslegemer</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>Viser legemene som brukes til kollisjonskontroll, over armen</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>Registrert kjøring</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle filer (*)</translation>
    </message>
    <message>
        <source>Follow the nozzle</source>
        <translation>Følg dysen</translation>
    </message>
    <message>
        <source>Keeps the nozzle in the middle of the view</source>
        <translation>Holder dysen midt i visningen</translation>
    </message>
    <message>
        <source>Plan the motion before you jog the arm.</source>
        <translation>Planlegg bevegelsen før du kjører armen for hånd.</translation>
    </message>
    <message>
        <source>Kinds of beads, with statistics</source>
        <translation>Strengtyper, med statistikk</translation>
    </message>
    <message>
        <source>Colours the beads by kind, with time, share, length and mass of each</source>
        <translation>Farger strengene etter type, med tid, andel, lengde og masse for hver</translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation>Kjør armen for hånd</translation>
    </message>
    <message>
        <source>Moves the arm by hand, by joints or by the nozzle. The plan stays as it is</source>
        <translation>Kjører armen for hånd, ledd for ledd eller etter dysen. Planen blir som den er</translation>
    </message>
    <message>
        <source>Trace of the nozzle</source>
        <translation>Spor etter dysen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Last %1 s</source>
        <translation>Siste %1 s</translation>
    </message>
    <message>
        <source>Whole print</source>
        <translation>Hele utskriften</translation>
    </message>
    <message>
        <source>Solid where the nozzle prints, dashed where it travels</source>
        <translation>Heltrukket der dysen skriver ut, stiplet der den forflytter seg</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>Fjern pausen før lag %1</translation>
    </message>
    <message>
        <source>Pause before layer %1</source>
        <translation>Pause før lag %1</translation>
    </message>
    <message>
        <source>Event before layer %1…</source>
        <translation>Hendelse før lag %1…</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>Hendelse før dette laget…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>En pause, en venting, en utgang, et annet verktøy eller en egen linje</translation>
    </message>
</context>
<context>
    <name>voluta::window::SizesDialog</name>
    <message>
        <source>Sizes from a measured plate</source>
        <translation>Mål fra en oppmålt plate</translation>
    </message>
    <message>
        <source>Plate of %1</source>
        <translation>Plate på %1</translation>
    </message>
    <message>
        <source>Print the sample plate (File &gt; Samples) with this process, and measure it.</source>
        <translation>Print eksempelplaten (Fil &gt; Eksempler) med denne prosessen, og mål den.</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominelt</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Målt</translation>
    </message>
    <message>
        <source>Use these sizes</source>
        <translation>Bruk disse målene</translation>
    </message>
    <message>
        <source>Size factors %1 (x) and %2 (y), outlines %3, holes %4; the measured sizes fit within %5.</source>
        <translation>Målfaktorer %1 (x) og %2 (y), omriss %3, hull %4; de målte verdiene stemmer innenfor %5.</translation>
    </message>
</context>
<context>
    <name>voluta::window::SpacingView</name>
    <message>
        <source>%1–%2 mm: %3 % of the area</source>
        <translation>%1–%2 mm: %3 % av arealet</translation>
    </message>
    <message>
        <source>Layer spacing, share of area by thickness [mm]</source>
        <translation>Lagavstand, andel av arealet etter tykkelse [mm]</translation>
    </message>
    <message>
        <source>Mean %1 mm. Within %2–%3 mm: %4 %.</source>
        <translation>Snitt %1 mm. Innenfor %2–%3 mm: %4 %.</translation>
    </message>
    <message>
        <source>Too thin: %1 %.</source>
        <translation>For tynt: %1 %.</translation>
    </message>
    <message>
        <source>Too thick: %1 %.</source>
        <translation>For tykt: %1 %.</translation>
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
        <translation>endring av orientering</translation>
    </message>
</context>
<context>
    <name>voluta::window::StatusLine</name>
    <message>
        <source>about %1 left</source>
        <translation>ca. %1 igjen</translation>
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
        <translation>Print sammen med andre maskiner</translation>
    </message>
    <message>
        <source>Add project…</source>
        <translation>Legg til prosjekt…</translation>
    </message>
    <message>
        <source>Add this job again</source>
        <translation>Legg til denne jobben en gang til</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Save programs…</source>
        <translation>Lagre programmer…</translation>
    </message>
    <message>
        <source>Waits, and what they keep apart</source>
        <translation>Ventetider, og hva de holder fra hverandre</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Spill av eller pause</translation>
    </message>
    <message>
        <source>The programs were saved in %1.</source>
        <translation>Programmene ble lagret i %1.</translation>
    </message>
    <message>
        <source>Project of another machine</source>
        <translation>Prosjekt for en annen maskin</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Voluta-prosjekter (*.voluta)</translation>
    </message>
    <message>
        <source>Add the project of a machine that works beside this one.</source>
        <translation>Legg til prosjektet for en maskin som arbeider ved siden av denne.</translation>
    </message>
    <message>
        <source>Place the machines, then find an order of work.</source>
        <translation>Plasser maskinene, og finn deretter en arbeidsrekkefølge.</translation>
    </message>
    <message>
        <source>Together %1; one after the other %2; the longest alone %3</source>
        <translation>Sammen %1; etter hverandre %2; den lengste alene %3</translation>
    </message>
    <message>
        <source>Start the programs in any order: each waits at its first point for the others, whatever their signals are, and ends with its signals off. If one is stopped, stop all, and start all again.</source>
        <translation>Start programmene i vilkårlig rekkefølge: hvert av dem venter i sitt første punkt på de andre, uansett signalenes tilstand, og slutter med egne signaler av. Hvis ett stoppes, stopp alle, og start alle på nytt.</translation>
    </message>
    <message>
        <source>Machine %1: marks %2, waits %3, ends after %4</source>
        <translation>Maskin %1: merker %2, venter %3, slutter etter %4</translation>
    </message>
    <message>
        <source>Collision: %1 of machine %2 with %3 of machine %4</source>
        <translation>Kollisjon: %1 på maskin %2 med %3 på maskin %4</translation>
    </message>
    <message>
        <source>Machine %1 waits %2 for machine %3</source>
        <translation>Maskin %1 venter %2 på maskin %3</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 ved %2</translation>
    </message>
    <message>
        <source>Folder for all programs</source>
        <translation>Mappe for alle programmer</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Merknad: %1</translation>
    </message>
    <message>
        <source>Move %1 mm further apart</source>
        <translation>Flytt %1 mm lenger fra hverandre</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Minimum distance %1 mm; collisions: %2</source>
        <translation>Minsteavstand %1 mm; kollisjoner: %2</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Tidsplan</translation>
    </message>
    <message>
        <source>Minimum clearance between arms</source>
        <translation>Minste klaring mellom armene</translation>
    </message>
</context>
<context>
    <name>voluta::window::TouchDialog</name>
    <message>
        <source>Line %1 is not a point: write y and z, or x, y and z, in mm.</source>
        <translation>Linje %1 er ikke et punkt: skriv y og z, eller x, y og z, i mm.</translation>
    </message>
    <message>
        <source>Place on touched points</source>
        <translation>Plasser på målte punkter</translation>
    </message>
    <message>
        <source>Touch a cylinder along x at three points or more, and enter them in the work frame: y z, or x y z, one point per line [mm].</source>
        <translation>Berør en sylinder langs x i tre eller flere punkter, og skriv dem inn i arbeidskoordinatsystemet: y z, eller x y z, ett punkt per linje [mm].</translation>
    </message>
    <message>
        <source>y of the axis in the model</source>
        <translation>y for aksen i modellen</translation>
    </message>
    <message>
        <source>z of the axis in the model</source>
        <translation>z for aksen i modellen</translation>
    </message>
    <message>
        <source>Axis in the model (y, z)</source>
        <translation>Aksen i modellen (y, z)</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>Flytt delen</translation>
    </message>
    <message>
        <source>Centre y %1, z %2 mm; radius %3 mm; points: %4, mean deviation %5 mm.</source>
        <translation>Sentrum y %1, z %2 mm; radius %3 mm; punkter: %4, gjennomsnittlig avvik %5 mm.</translation>
    </message>
    <message>
        <source>The part is moved by y %1, z %2 mm.</source>
        <translation>Delen flyttes y %1, z %2 mm.</translation>
    </message>
    <message>
        <source>Touched points</source>
        <translation>Berørte punkter</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledCanvas</name>
    <message>
        <source>→ around, ↑ along [mm]</source>
        <translation>→ rundt, ↑ langs [mm]</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledDock</name>
    <message>
        <source>Layer %1 of %2</source>
        <translation>Lag %1 av %2</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Utbrettet lag</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledView</name>
    <message>
        <source>Wall</source>
        <translation>Vegg</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Fyll</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Spaltefyll</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>Skjørt eller brem</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Støtte</translation>
    </message>
    <message>
        <source>Around %1 mm (%2°), along %3 mm</source>
        <translation>Rundt %1 mm (%2°), langs %3 mm</translation>
    </message>
    <message>
        <source>Around %1 mm, along %2 mm</source>
        <translation>Rundt %1 mm, langs %2 mm</translation>
    </message>
    <message>
        <source>%1 %2, waypoint %3 of %4</source>
        <translation>%1 %2, banepunkt %3 av %4</translation>
    </message>
    <message>
        <source>This layer is not wound around an axis.</source>
        <translation>Dette laget er ikke viklet rundt en akse.</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Utbrettet lag</translation>
    </message>
    <message>
        <source>Click a path to find it in the 3D view. Wheel zooms, drag moves, double click shows all.</source>
        <translation>Klikk en bane for å finne den i 3D-visningen. Hjulet zoomer, dra flytter, dobbeltklikk viser alt.</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Priming</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>Glissent fyll</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Bro</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Tape</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skudd</translation>
    </message>
</context>
<context>
    <name>voluta::window::VerifyDialog</name>
    <message>
        <source>Replay findings</source>
        <translation>Funn fra gjenspillingen</translation>
    </message>
    <message>
        <source>Verify %1</source>
        <translation>Verifiser %1</translation>
    </message>
    <message>
        <source>Replaying the program against the current plan…</source>
        <translation>Gjenspiller programmet mot gjeldende plan…</translation>
    </message>
    <message>
        <source>%1: passed. The program matches the plan.</source>
        <translation>%1: bestått. Programmet stemmer med planen.</translation>
    </message>
    <message>
        <source>%1: refused. Do not run it on the robot.</source>
        <translation>%1: avvist. Ikke kjør det på roboten.</translation>
    </message>
    <message>
        <source>Replay findings, the first %1 of %2</source>
        <translation>Funn fra gjenspillingen, de første %1 av %2</translation>
    </message>
    <message>
        <source>%1: safe to run, but it does not print the part as asked.</source>
        <translation>%1: trygt å kjøre, men det printer ikke delen som ønsket.</translation>
    </message>
    <message>
        <source>%1: safe to run but for your own statements, which nothing checks.</source>
        <translation>%1: trygt å kjøre, bortsett fra egne setninger, som ingenting kontrollerer.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ViewOptions</name>
    <message>
        <source>Show</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Farge etter</translation>
    </message>
    <message>
        <source>Latest</source>
        <translation>Siste</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voksler</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lag</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Baner</translation>
    </message>
    <message>
        <source>The latest result of the plan</source>
        <translation>Planens siste resultat</translation>
    </message>
    <message>
        <source>Layers drawn with their thickness</source>
        <translation>Lag tegnet med tykkelsen sin</translation>
    </message>
    <message>
        <source>Tool-paths drawn as beads</source>
        <translation>Verktøybaner tegnet som strenger</translation>
    </message>
    <message>
        <source>Part surface</source>
        <translation>Delens overflate</translation>
    </message>
    <message>
        <source>Travel moves</source>
        <translation>Tomkjøring</translation>
    </message>
    <message>
        <source>True bead width</source>
        <translation>Virkelig strengbredde</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Snittplan</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Vend</translation>
    </message>
    <message>
        <source>Remove the other side</source>
        <translation>Fjern den andre siden</translation>
    </message>
    <message>
        <source>Position of the section plane</source>
        <translation>Snittplanets posisjon</translation>
    </message>
    <message>
        <source>Solid voxels and their growth order</source>
        <translation>Massive voksler og vekstrekkefølgen deres</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Konveks front</translation>
    </message>
    <message>
        <source>During growth replay: the convex front; the next voxels must be outside it</source>
        <translation>Under avspilling av veksten: den konvekse fronten; de neste vokslene må være utenfor den</translation>
    </message>
    <message>
        <source>Later voxels faint</source>
        <translation>Senere voksler svakt</translation>
    </message>
    <message>
        <source>During growth replay: voxels not yet printed</source>
        <translation>Under avspilling av veksten: voksler som ikke er printet ennå</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stykker</translation>
    </message>
    <message>
        <source>Pieces printable without support, and their base planes</source>
        <translation>Stykker som kan printes uten støtte, og basisplanene deres</translation>
    </message>
</context>
<context>
    <name>voluta::window::Welcome</name>
    <message>
        <source>Print a part with a robot</source>
        <translation>Print en del med en robot</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Ikke noe bilde</translation>
    </message>
    <message>
        <source>Drop a mesh (STL, OBJ, PLY, OFF or 3MF), a slicer&apos;s G-code or a Voluta project here.</source>
        <translation>Slipp en mesh (STL, OBJ, PLY, OFF eller 3MF), en slicers G-kode eller et Voluta-prosjekt her.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Åpne…</translation>
    </message>
    <message>
        <source>Sample vase</source>
        <translation>Eksempelvase</translation>
    </message>
</context>
</TS>
