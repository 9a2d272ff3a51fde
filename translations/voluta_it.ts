<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it_IT" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Quit</source>
        <translation>Es&amp;ci</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Chiudi la finestra</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>Sc&amp;orciatoie…</translation>
    </message>
    <message>
        <source>See and change the keys</source>
        <translation>Vedi e cambia le scorciatoie</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>Tema sc&amp;uro</translation>
    </message>
    <message>
        <source>Light text on dark ground</source>
        <translation>Testo chiaro su fondo scuro</translation>
    </message>
    <message>
        <source>P&amp;icture…</source>
        <translation>&amp;Immagine…</translation>
    </message>
    <message>
        <source>Save the viewport as a PNG</source>
        <translation>Salva la vista come PNG</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Schermo &amp;intero</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>Tutto lo schermo</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Scorciatoie</translation>
    </message>
    <message>
        <source>All keys at a glance</source>
        <translation>Tutte le scorciatoie</translation>
    </message>
    <message>
        <source>&amp;About Voluta</source>
        <translation>&amp;Informazioni su Voluta</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versione e licenza</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Confronta</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Esporta</translation>
    </message>
    <message>
        <source>Robot &amp;programs…</source>
        <translation>&amp;Programmi robot…</translation>
    </message>
    <message>
        <source>Write the chosen programs into a folder</source>
        <translation>Scrivi i programmi scelti in una cartella</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Strati</translation>
    </message>
    <message>
        <source>Go to this page</source>
        <translation>Vai a questa pagina</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Sposta</translation>
    </message>
    <message>
        <source>Move the part with handles</source>
        <translation>Sposta il pezzo con le maniglie</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Ruota</translation>
    </message>
    <message>
        <source>Turn the part with handles</source>
        <translation>Ruota il pezzo con le maniglie</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>S&amp;cala</translation>
    </message>
    <message>
        <source>Scale the part with handles</source>
        <translation>Scala il pezzo con le maniglie</translation>
    </message>
    <message>
        <source>&amp;Lay on face</source>
        <translation>&amp;Appoggia su faccia</translation>
    </message>
    <message>
        <source>Click the face to lie on the plate</source>
        <translation>Fai clic sulla faccia da appoggiare sul piatto</translation>
    </message>
    <message>
        <source>&amp;Drop to plate</source>
        <translation>Abbassa sul &amp;piatto</translation>
    </message>
    <message>
        <source>Lowest point on the plate</source>
        <translation>Punto più basso sul piatto</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>C&amp;entra</translation>
    </message>
    <message>
        <source>Middle of the part over the plate&apos;s</source>
        <translation>Centro del pezzo sul centro del piatto</translation>
    </message>
    <message>
        <source>Place on touched &amp;points…</source>
        <translation>Posa su &amp;punti toccati…</translation>
    </message>
    <message>
        <source>Moves the part to a cylinder found by touching it</source>
        <translation>Porta il pezzo su un cilindro trovato toccandolo</translation>
    </message>
    <message>
        <source>&amp;Prepare</source>
        <translation>&amp;Prepara</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>Ripristina &amp;tutti i parametri</translation>
    </message>
    <message>
        <source>Every parameter back to its default</source>
        <translation>Ogni parametro al valore predefinito</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>Si&amp;mula</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Nuovo progetto</translation>
    </message>
    <message>
        <source>Begin without a part</source>
        <translation>Comincia senza pezzo</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>Open a mesh or a project</source>
        <translation>Apri una mesh o un progetto</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>Vaso</translation>
    </message>
    <message>
        <source>A fluted vase, 60 mm high</source>
        <translation>Un vaso scanalato alto 60 mm</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salva il progetto</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salva con n&amp;ome…</translation>
    </message>
    <message>
        <source>Save the project under a name</source>
        <translation>Salva il progetto con un altro nome</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Pianifica</translation>
    </message>
    <message>
        <source>From the part to checked robot programs</source>
        <translation>Dal pezzo ai programmi robot verificati</translation>
    </message>
    <message>
        <source>Plan as far as the &amp;layers</source>
        <translation>Pianifica fino agli &amp;strati</translation>
    </message>
    <message>
        <source>Stops before tool-paths and motion</source>
        <translation>Si ferma prima di percorsi utensile e movimento</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Interrompi</translation>
    </message>
    <message>
        <source>Stop; the last results stay on show</source>
        <translation>Ferma; gli ultimi risultati restano in vista</translation>
    </message>
    <message>
        <source>&amp;Update voxels while editing</source>
        <translation>&amp;Aggiorna i voxel mentre si modifica</translation>
    </message>
    <message>
        <source>Once planned, voxels follow the settings; layers and paths wait for Plan</source>
        <translation>Dopo un piano i voxel seguono le impostazioni; strati e percorsi attendono Pianifica</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Fronte</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retro</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Destra</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Sinistra</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>So&amp;pra</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>S&amp;otto</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>Obli&amp;qua</translation>
    </message>
    <message>
        <source>Look from there</source>
        <translation>Guarda da questo lato</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Esegui</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;sporta</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Fi&amp;nestra</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Apri &amp;recenti</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>&amp;Esempi</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Lingua</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>Mostra &amp;tutto</translation>
    </message>
    <message>
        <source>Everything in sight</source>
        <translation>Tutto in vista</translation>
    </message>
    <message>
        <source>&amp;Section plane</source>
        <translation>Piano di se&amp;zione</translation>
    </message>
    <message>
        <source>Cut the picture open</source>
        <translation>Apri la vista con un taglio</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Legenda</translation>
    </message>
    <message>
        <source>What the colours of the picture say</source>
        <translation>Che cosa dicono i colori dell&apos;immagine</translation>
    </message>
    <message>
        <source>&amp;Unrolled layer</source>
        <translation>Strato &amp;srotolato</translation>
    </message>
    <message>
        <source>Layers around an axis laid flat, beside the picture</source>
        <translation>Gli strati intorno a un asse distesi in piano, accanto all’immagine</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Avvia o metti in pausa</translation>
    </message>
    <message>
        <source>Runs the time-line</source>
        <translation>Fa scorrere la simulazione</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Movimento successivo</translation>
    </message>
    <message>
        <source>One move on</source>
        <translation>Avanti di un movimento</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Movimento precedente</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>Indietro di un movimento</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Strato successivo</translation>
    </message>
    <message>
        <source>One layer on</source>
        <translation>Avanti di uno strato</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Strato precedente</translation>
    </message>
    <message>
        <source>One layer back</source>
        <translation>Indietro di uno strato</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Salva l&apos;immagine</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Immagini (*.png)</translation>
    </message>
    <message>
        <source>About Voluta</source>
        <translation>Informazioni su Voluta</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;Prints with a robot arm: layers without support, tool-paths, a motion checked against the part as it grows, and programs that were read back and replayed.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;Stampa con un braccio robot: strati senza supporto, percorsi utensile, un movimento controllato rispetto al pezzo che cresce e programmi riletti, rieseguiti e verificati.&lt;/p&gt;&lt;p&gt;Software libero con licenza GNU General Public License, versione 3 o successiva.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Annulla: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Ripeti: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ripeti</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>Missed
voxels</source>
        <translation>Voxel
persi</translation>
    </message>
    <message>
        <source>Risky
mm²</source>
        <translation>Rischio
mm²</translation>
    </message>
    <message>
        <source>Supports
mm³</source>
        <translation>Supporti
mm³</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <source>Print
time</source>
        <translation>Tempo
stampa</translation>
    </message>
    <message>
        <source>Reach
%</source>
        <translation>Porta-
ta %</translation>
    </message>
    <message>
        <source>Colli-
sions</source>
        <translation>Colli-
sioni</translation>
    </message>
    <message>
        <source>Missed voxels</source>
        <translation>Voxel persi</translation>
    </message>
    <message>
        <source>Risky area</source>
        <translation>Area a rischio</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Supporti</translation>
    </message>
    <message>
        <source>Print time</source>
        <translation>Tempo di stampa</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Fuori portata</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisioni</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Contact area, margin</source>
        <translation>Area di contatto, margine</translation>
    </message>
    <message>
        <source>Rod of the cell</source>
        <translation>Barra della cella</translation>
    </message>
    <message>
        <source>Disc, diameter</source>
        <translation>Disco, diametro</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>Rod, diameter × length</source>
        <translation>Barra, diametro × lunghezza</translation>
    </message>
    <message>
        <source>Body from a file</source>
        <translation>Corpo da un file</translation>
    </message>
    <message>
        <source>Margin around what stands on the plate</source>
        <translation>Margine attorno a ciò che poggia sul piatto</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diametro</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>Larghezza (X)</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>Profondità (Y)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Curved layers</source>
        <translation>Strati curvi</translation>
    </message>
    <message>
        <source>Extended G-code (nozzle direction as nX nY nZ)</source>
        <translation>G-code esteso (direzione dell&apos;ugello come nX nY nZ)</translation>
    </message>
    <message>
        <source>Joint table (CSV)</source>
        <translation>Tabella dei giunti (CSV)</translation>
    </message>
    <message>
        <source>contact area</source>
        <translation>area di contatto</translation>
    </message>
    <message>
        <source>contact area + %1 mm</source>
        <translation>area di contatto + %1 mm</translation>
    </message>
    <message>
        <source>disc, %1 mm</source>
        <translation>disco, %1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatica</translation>
    </message>
    <message>
        <source>Peels the part and keeps the best of several passes</source>
        <translation>Sbuccia il pezzo e tiene il migliore di più passaggi</translation>
    </message>
    <message>
        <source>Peeling, turned round</source>
        <translation>Sbucciatura inversa</translation>
    </message>
    <message>
        <source>Takes voxels off from outside while the rest keeps its support; printed in the opposite order</source>
        <translation>Toglie voxel dall&apos;esterno finché il resto mantiene il suo appoggio; si stampa nell&apos;ordine opposto</translation>
    </message>
    <message>
        <source>Guided by peeling</source>
        <translation>Guidata</translation>
    </message>
    <message>
        <source>Grows from the platform, held back by the peeling field</source>
        <translation>Cresce dalla piattaforma, trattenuta dal campo di sbucciatura</translation>
    </message>
    <message>
        <source>Halved layers</source>
        <translation>A strati dimezzati</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer that would cut voxels off is halved until it does not</source>
        <translation>Cresce dalla piattaforma; uno strato che isolerebbe dei voxel viene dimezzato finché non lo fa più</translation>
    </message>
    <message>
        <source>Voxel by voxel</source>
        <translation>Voxel per voxel</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer takes each voxel that cuts off no other</source>
        <translation>Cresce dalla piattaforma; uno strato prende ogni voxel che non ne isola altri</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Golosa</translation>
    </message>
    <message>
        <source>Grows from the platform by whole layers, whatever they cut off</source>
        <translation>Cresce dalla piattaforma a strati interi, qualunque cosa isolino</translation>
    </message>
    <message>
        <source>Drop to plate</source>
        <translation>Appoggia sul piatto</translation>
    </message>
    <message>
        <source>Lowest point on the plate</source>
        <translation>Punto più basso sul piatto</translation>
    </message>
    <message>
        <source>Shrink platform</source>
        <translation>Riduci la piattaforma</translation>
    </message>
    <message>
        <source>To the area that the part stands on: the front spans less</source>
        <translation>All&apos;area su cui poggia il pezzo: il fronte abbraccia meno</translation>
    </message>
    <message>
        <source>Add supports</source>
        <translation>Aggiungi supporti</translation>
    </message>
    <message>
        <source>Thin columns that break off, as few as can be</source>
        <translation>Colonne sottili che si staccano, il meno possibile</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>Gira il pezzo</translation>
    </message>
    <message>
        <source>Searches the way to lie in which fewest voxels are missed</source>
        <translation>Cerca la giacitura in cui mancano meno voxel</translation>
    </message>
    <message>
        <source>Use voxel width %1 mm</source>
        <translation>Usa voxel larghi %1 mm</translation>
    </message>
    <message>
        <source>Narrow enough for this wall; narrower voxels take longer</source>
        <translation>Abbastanza stretti per questa parete; voxel più stretti richiedono più tempo</translation>
    </message>
    <message>
        <source>Planar pieces</source>
        <translation>Pezzi piani</translation>
    </message>
    <message>
        <source>Flat layers</source>
        <translation>Strati piani</translation>
    </message>
    <message>
        <source>Widen the platform</source>
        <translation>Allarga la base</translation>
    </message>
    <message>
        <source>By 20 mm all round, so that supports have something to stand on</source>
        <translation>Di 20 mm tutt&apos;intorno, perché i supporti abbiano su che poggiare</translation>
    </message>
    <message>
        <source>Adapt the layers</source>
        <translation>Adatta gli strati</translation>
    </message>
    <message>
        <source>Lower ones where the surface leans: steps leave less of it empty</source>
        <translation>Più bassi dove la superficie è inclinata: i gradini ne lasciano vuota di meno</translation>
    </message>
    <message>
        <source>Searches the way to lie in which least area needs support</source>
        <translation>Cerca la posizione in cui meno area richiede supporti</translation>
    </message>
    <message>
        <source>Around a rod</source>
        <translation>Intorno a una barra</translation>
    </message>
    <message>
        <source>On a given surface</source>
        <translation>Su una superficie data</translation>
    </message>
    <message>
        <source>rod, %1 mm</source>
        <translation>barra, %1 mm</translation>
    </message>
</context>
<context>
    <name>Findings</name>
    <message>
        <source>%1 mm2 lean over by more than %2 degrees</source>
        <translation>%1 mm2 sporgono di oltre %2 gradi</translation>
    </message>
    <message>
        <source>%1 smaller places lean over too far, %2 mm2 together; this is the largest of them</source>
        <translation>%1 punti più piccoli sporgono troppo, %2 mm2 in tutto; questo è il più grande</translation>
    </message>
    <message>
        <source>%1 of %2 pieces: something printed before is in the head&apos;s way</source>
        <translation>%1 pezzi su %2: qualcosa di già stampato ostacola la testa</translation>
    </message>
    <message>
        <source>all pieces are held to the plate by %1 mm2, of %2 that the part stands on uncut</source>
        <translation>tutti i pezzi sono tenuti al piatto da %1 mm2, dei %2 su cui il pezzo poggia senza tagli</translation>
    </message>
    <message>
        <source>%1 of %2 voxels have nothing printed under them</source>
        <translation>%1 voxel su %2 non hanno nulla di stampato sotto</translation>
    </message>
    <message>
        <source>%1 mm2 hang where a support has nothing to stand on</source>
        <translation>%1 mm2 sporgono dove un supporto non ha su che poggiare</translation>
    </message>
    <message>
        <source>%1 pieces of layers are too small for a bead or would begin in the air, %2 mm3 of %3: they are not laid</source>
        <translation>%1 tratti di strato sono troppo piccoli per un cordone o inizierebbero in aria, %2 mm3 su %3: non vengono depositati</translation>
    </message>
    <message>
        <source>%1 pieces of layers have nothing under them</source>
        <translation>%1 tratti di strato non hanno nulla sotto</translation>
    </message>
    <message>
        <source>planes of layers miss the part: %1</source>
        <translation>piani di strato che non toccano il pezzo: %1</translation>
    </message>
    <message>
        <source>pieces of layers are narrower than half a bead and stay empty</source>
        <translation>alcuni tratti di strato sono più stretti di mezzo cordone e restano vuoti</translation>
    </message>
    <message>
        <source>the print head would cut into material printed before, whatever way it leans</source>
        <translation>la testa di stampa urterebbe materiale già stampato, comunque si inclini</translation>
    </message>
    <message>
        <source>turn the part (orient=leastRisky), add supports, or use planar or curved mode</source>
        <translation>gira il pezzo (orient=leastRisky), aggiungi supporti, o usa pezzi piani o strati curvi</translation>
    </message>
    <message>
        <source>turn the part (orient=leastRisky), or use planar or curved mode</source>
        <translation>gira il pezzo (orient=leastRisky), o usa pezzi piani o strati curvi</translation>
    </message>
    <message>
        <source>add supports (supports=auto), cut there, or use curved mode</source>
        <translation>aggiungi supporti (supports=auto), taglia lì, o usa strati curvi</translation>
    </message>
    <message>
        <source>give other cuts (cutPlanes), turn the part, or use curved mode</source>
        <translation>indica altri tagli (cutPlanes), gira il pezzo, o usa strati curvi</translation>
    </message>
    <message>
        <source>lay the part on a larger face, or give other cuts (cutPlanes)</source>
        <translation>appoggia il pezzo su una faccia più grande, o indica altri tagli (cutPlanes)</translation>
    </message>
    <message>
        <source>use a larger platform (fit:MARGIN), or turn the part</source>
        <translation>usa una piattaforma più grande (fit:MARGIN), o gira il pezzo</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print the part larger</source>
        <translation>usa un ugello più fine, o stampa il pezzo più grande</translation>
    </message>
    <message>
        <source>use a slimmer head, turn the part, or print it larger</source>
        <translation>usa una testa più snella, gira il pezzo, o stampalo più grande</translation>
    </message>
    <message>
        <source>move them, or leave them out</source>
        <translation>spostali, o toglili</translation>
    </message>
    <message>
        <source>the part reaches %1 mm from the rod&apos;s axis, the cell prints up to %2 mm</source>
        <translation>il pezzo arriva a %1 mm dall&apos;asse della barra, la cella stampa fino a %2 mm</translation>
    </message>
    <message>
        <source>print the part smaller (scale)</source>
        <translation>stampare il pezzo più piccolo (scale)</translation>
    </message>
    <message>
        <source>%1 of %2 mm3 of the part are in no layer</source>
        <translation>%1 di %2 mm3 del pezzo non sono in nessuno strato</translation>
    </message>
    <message>
        <source>choose layers that reach all of it (layerShape, layerCentre, endSurface)</source>
        <translation>scegliere strati che lo raggiungano tutto (layerShape, layerCentre, endSurface)</translation>
    </message>
    <message>
        <source>let the part rise from the rod at a gentler slope there</source>
        <translation>lì far salire il pezzo dalla barra con minore pendenza</translation>
    </message>
    <message>
        <source>let the part rise from the surface at a gentler slope there</source>
        <translation>lì far salire il pezzo dalla superficie con minore pendenza</translation>
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
    <name>ModeSwitch</name>
    <message>
        <source>This way of building does not print on that platform.</source>
        <translation>Questo modo di costruire non stampa su quella piattaforma.</translation>
    </message>
    <message>
        <source>This way of building lays the part itself: it is not turned by the search for a way to lie.</source>
        <translation>Questo modo di costruire posa da sé il pezzo: la ricerca di una giacitura non lo gira.</translation>
    </message>
    <message>
        <source>This way of building needs a scale that is a number.</source>
        <translation>Questo modo di costruire vuole una scala che sia un numero.</translation>
    </message>
    <message>
        <source>The platform&apos;s file %1 is not there.</source>
        <translation>Il file della piattaforma, %1, non c’è.</translation>
    </message>
    <message>
        <source>This way of building needs a cell that turns a rod.</source>
        <translation>Questo modo di costruire vuole una cella che faccia girare una barra.</translation>
    </message>
    <message>
        <source>This cell turns a rod: the way of building needs one with a plate.</source>
        <translation>Questa cella fa girare una barra: il modo di costruire ne vuole una con un piatto.</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Layers</source>
        <translation>strati</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>cordoni</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>file in uscita</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>percorsi utensile</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>movimento</translation>
    </message>
    <message>
        <source>layer height</source>
        <translation>altezza strato</translation>
    </message>
    <message>
        <source>Wanted height of a layer; the process limits what it may become.</source>
        <translation>Altezza desiderata di uno strato; il processo ne fissa i limiti.</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>larghezza cordone</translation>
    </message>
    <message>
        <source>Wanted width of a bead; the process limits what it may become.</source>
        <translation>Larghezza desiderata di un cordone; il processo ne fissa i limiti.</translation>
    </message>
    <message>
        <source>step</source>
        <translation>passo</translation>
    </message>
    <message>
        <source>Longest distance of waypoints along a tool-path.</source>
        <translation>Distanza massima fra i punti di un percorso utensile.</translation>
    </message>
    <message>
        <source>write what every stage made</source>
        <translation>scrivi il risultato di ogni fase</translation>
    </message>
    <message>
        <source>write refused programs</source>
        <translation>scrivi i programmi respinti</translation>
    </message>
    <message>
        <source>Also writes programs that the replay refused, as refused-NAME, to be looked at and never to be run.</source>
        <translation>Scrive anche i programmi respinti dalla verifica, come refused-NOME: da esaminare, mai da eseguire.</translation>
    </message>
    <message>
        <source>Voxel width</source>
        <translation>larghezza voxel</translation>
    </message>
    <message>
        <source>Width of the voxels that growth works on; layers are not bound to it.</source>
        <translation>Larghezza dei voxel su cui lavora la crescita; gli strati non ne dipendono.</translation>
    </message>
    <message>
        <source>Field rounds</source>
        <translation>cicli del campo</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>pareti</translation>
    </message>
    <message>
        <source>Beads laid along the edge of each layer before it is filled.</source>
        <translation>Cordoni deposti lungo il bordo di ogni strato prima del riempimento.</translation>
    </message>
    <message>
        <source>infill</source>
        <translation>riempimento</translation>
    </message>
    <message>
        <source>How the inside of each layer is filled.</source>
        <translation>Come viene riempito l&apos;interno di ogni strato.</translation>
    </message>
    <message>
        <source>zigzag</source>
        <translation>zigzag</translation>
    </message>
    <message>
        <source>concentric</source>
        <translation>concentrico</translation>
    </message>
    <message>
        <source>infill density</source>
        <translation>densità riempimento</translation>
    </message>
    <message>
        <source>Share of the inside that is filled; 1 is solid.</source>
        <translation>Quota dell&apos;interno da riempire; 1 è pieno.</translation>
    </message>
    <message>
        <source>clearance of the arm</source>
        <translation>distanza del braccio</translation>
    </message>
    <message>
        <source>Distance that links, plate, nozzle holder and obstacles keep from each other.</source>
        <translation>Distanza minima fra membri del braccio, piatto, portaugello e ostacoli.</translation>
    </message>
    <message>
        <source>clearance of the part</source>
        <translation>distanza dal pezzo</translation>
    </message>
    <message>
        <source>Distance that all but the print head keeps from what is printed.</source>
        <translation>Distanza minima dal materiale stampato per tutto tranne la testa di stampa.</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>sollevamento</translation>
    </message>
    <message>
        <source>How far the nozzle leaves the part, at least, before it travels.</source>
        <translation>Di quanto, almeno, l&apos;ugello si stacca dal pezzo prima di spostarsi a vuoto.</translation>
    </message>
    <message>
        <source>turns about the nozzle</source>
        <translation>rotazioni attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>How many turns of the part about the nozzle&apos;s axis are tried at each place.</source>
        <translation>Quante rotazioni del pezzo attorno all&apos;asse dell&apos;ugello vengono provate in ogni punto.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>sì</translation>
    </message>
    <message>
        <source>off</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Range: %1 to %2</source>
        <translation>Intervallo: da %1 a %2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Predefinito: %1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Chiave: %1</translation>
    </message>
    <message>
        <source>How often growth and smooth field are fitted to each other at most. 0: layers from the ranks.</source>
        <translation>Quante volte al massimo crescita e campo liscio vengono adattati l&apos;una all&apos;altro. 0: strati dai ranghi.</translation>
    </message>
    <message>
        <source>Shadowed per layer</source>
        <translation>isolati per strato</translation>
    </message>
    <message>
        <source>Growth incremental, adaptive, guided: a layer takes voxels as long as it cuts off fewer than this many others. 1: none. 0: fewer than the whole layer would.</source>
        <translation>Crescita voxel per voxel, a strati dimezzati, guidata: uno strato prende voxel finché ne isola meno di questi. 1: nessuno. 0: meno di quanti ne isolerebbe lo strato intero.</translation>
    </message>
    <message>
        <source>Order of trying</source>
        <translation>ordine dei tentativi</translation>
    </message>
    <message>
        <source>flooding</source>
        <translation>a espansione</translation>
    </message>
    <message>
        <source>insertion</source>
        <translation>di inserimento</translation>
    </message>
    <message>
        <source>Growth incremental: a layer&apos;s voxels are tried outwards from the first one (flooding) or in the order they were found (insertion).</source>
        <translation>Crescita voxel per voxel: i voxel di uno strato si provano dal primo verso l&apos;esterno (a espansione) o nell&apos;ordine in cui sono stati trovati (di inserimento).</translation>
    </message>
    <message>
        <source>Voxels on the front</source>
        <translation>voxel sul fronte</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuori</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>The sources&apos; schemes: whether a voxel that lies exactly on the convex front can still be laid (outside) or is cut off by it (inside).</source>
        <translation>Schemi delle fonti: se un voxel che giace esattamente sul fronte convesso si può ancora deporre (fuori) o ne resta isolato (dentro).</translation>
    </message>
    <message>
        <source>Where nothing is safe</source>
        <translation>dove nulla è sicuro</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>strato</translation>
    </message>
    <message>
        <source>least</source>
        <translation>il meno possibile</translation>
    </message>
    <message>
        <source>Growth incremental, adaptive, guided: where every voxel of a layer would cut others off, lay all of it as the source does (layer) or only what cuts off fewest (least).</source>
        <translation>Crescita voxel per voxel, a strati dimezzati, guidata: dove ogni voxel di uno strato ne isolerebbe altri, deporlo tutto come fa la fonte (strato) o solo ciò che ne isola di meno (il meno possibile).</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>fronte</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>piatto</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>ugello</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>supporti</translation>
    </message>
    <message>
        <source>What carries voxels that growth would miss: nothing, or columns as thin as a voxel, to be broken off afterwards.</source>
        <translation>Che cosa regge i voxel che la crescita mancherebbe: nulla, o colonne sottili quanto un voxel, da staccare alla fine.</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>giro del pezzo</translation>
    </message>
    <message>
        <source>Looks for a better way for the part to lie, from where it was put: with the least overhanging area, or with the fewest voxels missed by growth.</source>
        <translation>Cerca una giacitura migliore del pezzo, da dove è stato messo: con la minore area a sbalzo, o con il minor numero di voxel mancati dalla crescita.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>leastRisky</source>
        <translation>minimo sbalzo</translation>
    </message>
    <message>
        <source>fewestMissed</source>
        <translation>minimi mancati</translation>
    </message>
    <message>
        <source>Shape of the head that must clear all that is printed earlier: a flat one as wide as needed, or the head as it is: where voxels would be lost otherwise (nozzle) and under wide roofs (nozzle and auto).</source>
        <translation>Forma della testa che deve evitare tutto ciò che è già stampato: una piatta, larga quanto serve, o la testa com&apos;è: dove altrimenti si perderebbero dei voxel (ugello) e sotto tetti ampi (ugello e automatico).</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>overhang angle</source>
        <translation>angolo di sbalzo</translation>
    </message>
    <message>
        <source>materials of pieces</source>
        <translation>materiali dei pezzi</translation>
    </message>
    <message>
        <source>Mode planar: a material or filament for each piece, separated by commas; from the first again where there are more pieces. Empty: the process&apos;s.</source>
        <translation>Modo planar: un materiale o filamento per ogni pezzo, separati da virgole; si ricomincia dal primo se i pezzi sono di più. Vuoto: quello del processo.</translation>
    </message>
    <message>
        <source>adaptive layers</source>
        <translation>strati adattivi</translation>
    </message>
    <message>
        <source>Modes planar and flat: thinner layers where the surface leans, within the process&apos;s limits.</source>
        <translation>Modi planar e flat: strati più sottili dove la superficie è inclinata, entro i limiti del processo.</translation>
    </message>
    <message>
        <source>step height</source>
        <translation>altezza del gradino</translation>
    </message>
    <message>
        <source>Adaptive layers: how far the edges of layers may stand out of the surface.</source>
        <translation>Strati adattivi: di quanto i bordi degli strati possono sporgere dalla superficie.</translation>
    </message>
    <message>
        <source>planes of layers</source>
        <translation>piani degli strati</translation>
    </message>
    <message>
        <source>Mode flat: a JSON file, or its text, with the plane or quadrilateral of each layer. Empty: layers along z.</source>
        <translation>Modo flat: un file JSON, o il suo testo, con il piano o quadrilatero di ogni strato. Vuoto: strati lungo z.</translation>
    </message>
    <message>
        <source>Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp and trajectory.csv.</source>
        <translation>Aggiunge voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp e trajectory.csv.</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>piani di taglio</translation>
    </message>
    <message>
        <source>Mode planar: a JSON file, or its text, with a point and a normal for each plane that cuts the part, in turn. Empty: they are searched for.</source>
        <translation>Modo planar: un file JSON, o il suo testo, con un punto e una normale per ogni piano che taglia il pezzo, uno dopo l&apos;altro. Vuoto: i piani vengono cercati.</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>schema</translation>
    </message>
    <message>
        <source>Mode planar: beam keeps several partial results and asks of the head&apos;s true shape; greedy is the published scheme, by the part&apos;s skeleton.</source>
        <translation>Modo planar: beam tiene più risultati parziali e tiene conto della vera forma della testa; greedy è lo schema pubblicato, secondo lo scheletro del pezzo.</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>spessori</translation>
    </message>
    <message>
        <source>Scheme greedy: how many thicknesses the part&apos;s branches are told apart by. 0: as many as stand apart.</source>
        <translation>Schema greedy: quanti spessori distinguono i rami del pezzo. 0: quanti risultano distinti.</translation>
    </message>
    <message>
        <source>root</source>
        <translation>radice</translation>
    </message>
    <message>
        <source>Scheme greedy: x,y,z (mm) of a place on what is printed first; it must stand on the plate. Empty: what stands on it with most area.</source>
        <translation>Schema greedy: x,y,z (mm) di un punto su ciò che si stampa per primo; deve poggiare sul piatto. Vuoto: ciò che vi poggia con più area.</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>a fascio</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>greedy</translation>
    </message>
    <message>
        <source>woven</source>
        <translation>intrecciato</translation>
    </message>
    <message>
        <source>around</source>
        <translation>attorno all&apos;asse</translation>
    </message>
    <message>
        <source>along</source>
        <translation>lungo l&apos;asse</translation>
    </message>
    <message>
        <source>helical</source>
        <translation>elicoidale</translation>
    </message>
    <message>
        <source>winding angle</source>
        <translation>angolo avvolgimento</translation>
    </message>
    <message>
        <source>Of helical infill: 0 winds around the axis, 90 runs along it.</source>
        <translation>Del riempimento elicoidale: 0 si avvolge attorno all&apos;asse, 90 corre lungo l&apos;asse.</translation>
    </message>
    <message>
        <source>How far a face may lean over from the upright without support, in every mode but curved.</source>
        <translation>Quanto una faccia può sporgere dalla verticale senza supporto, in tutti i modi tranne quello curvo.</translation>
    </message>
    <message>
        <source>infill direction</source>
        <translation>direzione del riempimento</translation>
    </message>
    <message>
        <source>Direction of straight lines on the first layer, from x to y.</source>
        <translation>Direzione delle linee rette sul primo strato, da x verso y.</translation>
    </message>
    <message>
        <source>turn of infill</source>
        <translation>rotazione del riempimento</translation>
    </message>
    <message>
        <source>How much straight lines turn from layer to layer; 0: all one way.</source>
        <translation>Di quanto girano le linee rette da uno strato all’altro; 0: tutte allo stesso modo.</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>axis of the part</source>
        <translation>asse del pezzo</translation>
    </message>
    <message>
        <source>Which of the part&apos;s own axes is laid on the rod; auto: the one that its sides run along.</source>
        <translation>Quale degli assi del pezzo si posa sulla barra; auto: quello lungo cui corrono i suoi fianchi.</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
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
        <source>sides of the rod</source>
        <translation>lati della barra</translation>
    </message>
    <message>
        <source>0: a round rod; 3 or more: a prism, measured over its corners.</source>
        <translation>0: barra tonda; 3 o più: un prisma, misurato sugli spigoli.</translation>
    </message>
    <message>
        <source>profile of the rod</source>
        <translation>profilo della barra</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with them; a step has two pairs at one x. Beyond them the rod goes on as it is. Empty: straight.</source>
        <translation>Coppie di x e raggio in mm, come -20,2.5 0,2.5 0,3.5 20,3.5, o un file che le contiene; un gradino ha due coppie alla stessa x. Oltre, la barra continua com’è. Vuoto: diritta.</translation>
    </message>
    <message>
        <source>layers around the rod</source>
        <translation>strati intorno alla barra</translation>
    </message>
    <message>
        <source>At constant radius about the axis, or at constant distance from the rod&apos;s profile.</source>
        <translation>A raggio costante intorno all’asse, o a distanza costante dal profilo della barra.</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>raggio</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>distanza</translation>
    </message>
    <message>
        <source>first layer</source>
        <translation>primo strato</translation>
    </message>
    <message>
        <source>Modes lathe and substrate: height of the layer on the ground; 0: as high as the others.</source>
        <translation>Modi lathe e substrate: altezza dello strato sul fondo; 0: alto come gli altri.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>shape of layers</source>
        <translation>forma degli strati</translation>
    </message>
    <message>
        <source>Mode substrate: at constant distance from the surface, on spheres, on cylinders along x, or from the surface to an end surface, thicker where the way is longer.</source>
        <translation>Modo substrate: a distanza costante dalla superficie, su sfere, su cilindri lungo x, o dalla superficie a una superficie finale, più spessi dove la via è più lunga.</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sfera</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cilindro</translation>
    </message>
    <message>
        <source>flatten</source>
        <translation>spiana</translation>
    </message>
    <message>
        <source>centre of layers</source>
        <translation>centro degli strati</translation>
    </message>
    <message>
        <source>Of spheres and cylinders: x,y,z in mm. Empty: of the ball or cylinder that the part stands on, or below the part.</source>
        <translation>Di sfere e cilindri: x,y,z in mm. Vuoto: quello della sfera o del cilindro su cui sta il pezzo, o sotto il pezzo.</translation>
    </message>
    <message>
        <source>end surface</source>
        <translation>superficie finale</translation>
    </message>
    <message>
        <source>Layers that flatten end on it: flat (at the part&apos;s top), flat:Z, radius:R (a wider cylinder) or mesh:FILE, placed with the platform&apos;s.</source>
        <translation>Gli strati che spianano finiscono qui: flat (in cima al pezzo), flat:Z, radius:R (un cilindro più largo) o mesh:FILE, posato con quello della piattaforma.</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppo</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Riempimento</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Riempimento vuoti</translation>
    </message>
    <message>
        <source>Skirt</source>
        <translation>Skirt</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Supporto</translation>
    </message>
    <message>
        <source>Tilt of the nozzle</source>
        <translation>Inclinazione dell&apos;ugello</translation>
    </message>
    <message>
        <source>Layer spacing</source>
        <translation>Spaziatura degli strati</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Passo di crescita</translation>
    </message>
    <message>
        <source>Peeling rank</source>
        <translation>Rango di pelatura</translation>
    </message>
    <message>
        <source>Step being laid</source>
        <translation>Passo in deposizione</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Fronte convesso</translation>
    </message>
    <message>
        <source>Missed, shadowed</source>
        <translation>Mancati, in ombra</translation>
    </message>
    <message>
        <source>Missed, unreached</source>
        <translation>Mancati, non raggiunti</translation>
    </message>
    <message>
        <source>Missed, cascade</source>
        <translation>Mancati, a cascata</translation>
    </message>
    <message>
        <source>Too thin to lay</source>
        <translation>Troppo sottile da deporre</translation>
    </message>
    <message>
        <source>Too thick to lay</source>
        <translation>Troppo spesso da deporre</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominale</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>on the plate</source>
        <translation>sul piatto</translation>
    </message>
    <message>
        <source>Needs support</source>
        <translation>Richiede supporto</translation>
    </message>
</context>
<context>
    <name>Stages</name>
    <message>
        <source>Load</source>
        <translation>Caricamento</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Scomposizione</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>Percorsi utensile</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>load</source>
        <translation>caricamento</translation>
    </message>
    <message>
        <source>repair</source>
        <translation>riparazione</translation>
    </message>
    <message>
        <source>repair: check</source>
        <translation>riparazione: controllo</translation>
    </message>
    <message>
        <source>repair: diagnosis</source>
        <translation>riparazione: diagnosi</translation>
    </message>
    <message>
        <source>repair: holes</source>
        <translation>riparazione: fori</translation>
    </message>
    <message>
        <source>repair: orientation</source>
        <translation>riparazione: orientamento</translation>
    </message>
    <message>
        <source>repair: self-intersections</source>
        <translation>riparazione: autointersezioni</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>orientamento</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>supporti</translation>
    </message>
    <message>
        <source>peeling</source>
        <translation>spellatura</translation>
    </message>
    <message>
        <source>front</source>
        <translation>fronte</translation>
    </message>
    <message>
        <source>voxelise</source>
        <translation>voxelizzazione</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>voxel</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>crescita</translation>
    </message>
    <message>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <source>cutting layers from the field</source>
        <translation>taglio degli strati dal campo</translation>
    </message>
    <message>
        <source>trimming layers on the part</source>
        <translation>rifilatura degli strati sul pezzo</translation>
    </message>
    <message>
        <source>checking layers</source>
        <translation>controllo degli strati</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>direzioni</translation>
    </message>
    <message>
        <source>laying beads</source>
        <translation>disposizione dei cordoni</translation>
    </message>
    <message>
        <source>checking the motion</source>
        <translation>controllo del movimento</translation>
    </message>
    <message>
        <source>running the program</source>
        <translation>esecuzione del programma</translation>
    </message>
    <message>
        <source>looking for collisions</source>
        <translation>ricerca di collisioni</translation>
    </message>
    <message>
        <source>measuring the beads</source>
        <translation>misura dei cordoni</translation>
    </message>
    <message>
        <source>looking beneath the beads</source>
        <translation>controllo sotto i cordoni</translation>
    </message>
    <message>
        <source>comparing with the plan</source>
        <translation>confronto con il piano</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>verificato</translation>
    </message>
    <message>
        <source>write files</source>
        <translation>scrittura dei file</translation>
    </message>
    <message>
        <source>write</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>verifica</translation>
    </message>
    <message>
        <source>tool-paths</source>
        <translation>percorsi utensile</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>movimento</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>pezzi</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>taglio in strati</translation>
    </message>
    <message>
        <source>ending layers on the surface</source>
        <translation>strati terminati sulla superficie</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>scheletro</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>taglio</translation>
    </message>
    <message>
        <source>ordering layers</source>
        <translation>ordinamento degli strati</translation>
    </message>
    <message>
        <source>take the rod out of the part</source>
        <translation>barra tolta dal pezzo</translation>
    </message>
    <message>
        <source>take the surface out of the part</source>
        <translation>superficie tolta dal pezzo</translation>
    </message>
    <message>
        <source>cutting layers</source>
        <translation>taglio degli strati</translation>
    </message>
</context>
<context>
    <name>voluta::document::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Senza titolo</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>modifica di %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>ripristino di %1</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>ripristino di tutti i parametri</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>scala del pezzo</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>apertura di %1</translation>
    </message>
</context>
<context>
    <name>voluta::document::RecentFiles</name>
    <message>
        <source>%1 is not there any more. It was taken off the list.</source>
        <translation>%1 non esiste più. È stato tolto dall&apos;elenco.</translation>
    </message>
</context>
<context>
    <name>voluta::document::Saving</name>
    <message>
        <source>There is nothing to save yet. Open a part first.</source>
        <translation>Non c&apos;è ancora niente da salvare. Apri prima un pezzo.</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ChoicesForm</name>
    <message>
        <source>Mode</source>
        <translation>Modalità</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescita</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Piattaforma</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Processo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <source>Another seed may find other ways through the air; the same seed always gives the same result.</source>
        <translation>Un altro seme può trovare altri tragitti a vuoto; lo stesso seme dà sempre lo stesso risultato.</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterForm</name>
    <message>
        <source>Search parameters</source>
        <translation>Cerca parametri</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Show what is needed most, and what was changed</source>
        <translation>Mostra i più usati e quelli modificati</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tutti</translation>
    </message>
    <message>
        <source>Show every parameter</source>
        <translation>Mostra tutti i parametri</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>Give every parameter its default</source>
        <translation>Riporta ogni parametro al valore predefinito</translation>
    </message>
    <message>
        <source>No parameter has these words.</source>
        <translation>Nessun parametro contiene queste parole.</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterRow</name>
    <message>
        <source>Reset to %1</source>
        <translation>Ripristina %1</translation>
    </message>
</context>
<context>
    <name>voluta::forms::PlatformEditor</name>
    <message>
        <source>Body to print on</source>
        <translation>Corpo su cui stampare</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.ply *.off *.3mf);;All files (*)</source>
        <translation>Mesh (*.stl *.obj *.ply *.off *.3mf);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Scegli un file…</translation>
    </message>
    <message>
        <source>A closed mesh, in the same place as in the part&apos;s file</source>
        <translation>Una mesh chiusa, nello stesso posto che ha nel file del pezzo</translation>
    </message>
    <message>
        <source>%1
Click to choose another one</source>
        <translation>%1
Fai clic per sceglierne un altro</translation>
    </message>
    <message>
        <source>Stepped: points x,radius</source>
        <translation>A gradini: punti x,raggio</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Tonda</translation>
    </message>
    <message>
        <source>Hexagonal, over corners</source>
        <translation>Esagonale, sugli spigoli</translation>
    </message>
    <message>
        <source>%1 sides, over corners</source>
        <translation>%1 lati, sugli spigoli</translation>
    </message>
    <message>
        <source>Shape of the rod</source>
        <translation>Forma della barra</translation>
    </message>
    <message>
        <source>Profile of the rod</source>
        <translation>Profilo della barra</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm; a step has two pairs at one x</source>
        <translation>Coppie di x e raggio in mm; un gradino ha due coppie alla stessa x</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ComparePanel</name>
    <message>
        <source>Open a part first.</source>
        <translation>Apri prima un pezzo.</translation>
    </message>
    <message>
        <source>Tick what to compare.</source>
        <translation>Spunta ciò che va confrontato.</translation>
    </message>
    <message>
        <source>Plans to be made: %1</source>
        <translation>Piani da fare: %1</translation>
    </message>
    <message>
        <source>Ways of building</source>
        <translation>Modi di costruire</translation>
    </message>
    <message>
        <source>Growth of curved layers</source>
        <translation>Crescita degli strati curvi</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>Piattaforme</translation>
    </message>
    <message>
        <source>Delete takes the selected one out of the list</source>
        <translation>Canc toglie dall&apos;elenco quella selezionata</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Compare with this platform too</source>
        <translation>Confronta anche con questa piattaforma</translation>
    </message>
    <message>
        <source>Plan as far as</source>
        <translation>Pianifica fino a</translation>
    </message>
    <message>
        <source>checked programs</source>
        <translation>programmi verificati</translation>
    </message>
    <message>
        <source>missed voxels and pieces</source>
        <translation>voxel persi e pezzi</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <source>Plans them one after the other, in the background</source>
        <translation>Li pianifica uno dopo l&apos;altro, in secondo piano</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Stop; rows that are done stay</source>
        <translation>Ferma; le righe già fatte restano</translation>
    </message>
    <message>
        <source>What counts</source>
        <translation>Che cosa conta</translation>
    </message>
    <message>
        <source>What nothing blocks comes first. Then the least score is best: each figure&apos;s share of the largest, times its weight.</source>
        <translation>Prima viene ciò che niente blocca. Poi vince il punteggio minore: di ogni valore la quota del massimo, per il suo peso.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>The weights as they were at first</source>
        <translation>I pesi com&apos;erano all&apos;inizio</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CompareTable</name>
    <message>
        <source>Best</source>
        <translation>Migliore</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In uso</translation>
    </message>
    <message>
        <source>Place by the rule, and the score below it: less is better</source>
        <translation>Posto secondo la regola e, sotto, il punteggio: meno è meglio</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Posto</translation>
    </message>
    <message>
        <source>Way of building</source>
        <translation>Modo di costruire</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ExportPanel</name>
    <message>
        <source>Replay of %1</source>
        <translation>Verifica di %1</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>Scegli almeno un formato.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Scegli una cartella.</translation>
    </message>
    <message>
        <source>Folder for the programs</source>
        <translation>Cartella dei programmi</translation>
    </message>
    <message>
        <source>Refused programs</source>
        <translation>Programmi respinti</translation>
    </message>
    <message>
        <source>The replay refused some of the programs. Never run them on a robot.</source>
        <translation>La verifica ha respinto alcuni programmi. Non eseguirli mai su un robot.</translation>
    </message>
    <message>
        <source>To be looked at, they can be written as:</source>
        <translation>Per esaminarli si possono scrivere come:</translation>
    </message>
    <message>
        <source>Write them too</source>
        <translation>Scrivi anche questi</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Escludili</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>Formati</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Testo del programma</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Cartella</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Sfoglia…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Esporta</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsModel</name>
    <message>
        <source>Blocked: %1</source>
        <translation>Bloccante: %1</translation>
    </message>
    <message>
        <source>Worth knowing: %1</source>
        <translation>Avviso: %1</translation>
    </message>
    <message>
        <source>at %1, %2, %3 mm</source>
        <translation>a %1, %2, %3 mm</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsPanel</name>
    <message>
        <source>What would help: %1</source>
        <translation>Rimedio: %1</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Segnalazioni</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Segnalazioni (%1)</translation>
    </message>
    <message>
        <source>%1 blocked, %2 worth knowing</source>
        <translation>Bloccanti: %1, avvisi: %2</translation>
    </message>
    <message>
        <source>Blocked (%1)</source>
        <translation>Bloccanti (%1)</translation>
    </message>
    <message>
        <source>Nothing is blocked.</source>
        <translation>Niente di bloccante.</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Nessun problema trovato.</translation>
    </message>
    <message>
        <source>Nothing found so far.</source>
        <translation>Ancora nessuna segnalazione.</translation>
    </message>
    <message>
        <source>Show only what is blocked</source>
        <translation>Mostra solo ciò che blocca</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Take the camera, the sliders and the robot there</source>
        <translation>Porta lì la vista, i cursori e il robot</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FormatList</name>
    <message>
        <source>%1, foreign</source>
        <translation>%1, altra marca</translation>
    </message>
    <message>
        <source>For another maker&apos;s controller: where the nozzle goes, not how this robot moves</source>
        <translation>Per il controllore di un&apos;altra marca: dove va l&apos;ugello, non come si muove questo robot</translation>
    </message>
    <message>
        <source>Not replayed yet</source>
        <translation>Non ancora verificato</translation>
    </message>
    <message>
        <source>Passed: the replay found nothing wrong</source>
        <translation>Superato: la verifica non ha trovato errori</translation>
    </message>
    <message>
        <source>Refused by the replay: %1</source>
        <translation>Respinto dalla verifica: %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::LayerInfo</name>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Porzioni</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Area</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Least, mean and greatest</source>
        <translation>Minimo, medio e massimo</translation>
    </message>
</context>
<context>
    <name>voluta::panels::MeshPanel</name>
    <message>
        <source>Repair the mesh</source>
        <translation>Ripara la mesh</translation>
    </message>
    <message>
        <source>Closes holes, turns triangles and takes out doubled ones, as far as the shape is not in doubt</source>
        <translation>Chiude i fori, orienta i triangoli e toglie i doppi, finché la forma non è in dubbio</translation>
    </message>
    <message>
        <source>No part is open.</source>
        <translation>Nessun pezzo aperto.</translation>
    </message>
    <message>
        <source>The mesh is not watertight.</source>
        <translation>La mesh non è chiusa.</translation>
    </message>
    <message>
        <source>The mesh is watertight.</source>
        <translation>La mesh è chiusa.</translation>
    </message>
    <message>
        <source>The mesh is watertight, but not sound.</source>
        <translation>La mesh è chiusa, ma non corretta.</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Triangoli: %1</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trovato</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Riparato</translation>
    </message>
    <message>
        <source>Remains</source>
        <translation>Resta</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ObjectTree</name>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Piattaforma</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>Ugello</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Piatto</translation>
    </message>
    <message>
        <source>Hide (Space)</source>
        <translation>Nascondi (Spazio)</translation>
    </message>
    <message>
        <source>Show (Space)</source>
        <translation>Mostra (Spazio)</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PiecesPanel</name>
    <message>
        <source>Printed as number %1, on piece %2</source>
        <translation>Stampato come numero %1, sul pezzo %2</translation>
    </message>
    <message>
        <source>Printed as number %1, on the plate</source>
        <translation>Stampato come numero %1, sul piatto</translation>
    </message>
    <message>
        <source>Needs support: %1, uncut %2</source>
        <translation>Richiede supporto: %1, senza tagli %2</translation>
    </message>
    <message>
        <source>With this cut: %1 need support. Press Plan.</source>
        <translation>Con questo taglio: %1 da supportare. Premi Pianifica.</translation>
    </message>
    <message>
        <source>With this cut: about %1 need support</source>
        <translation>Con questo taglio: circa %1 da supportare</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Risky</source>
        <translation>A rischio</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>In print order; a piece hangs below the one it stands on</source>
        <translation>In ordine di stampa; ogni pezzo sta sotto quello su cui poggia</translation>
    </message>
    <message>
        <source>Area that needs support where the piece is printed off its base</source>
        <translation>Area che richiede supporto quando il pezzo è stampato a partire dalla sua base</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Moves each piece off the one it stands on</source>
        <translation>Allontana ogni pezzo da quello su cui poggia</translation>
    </message>
    <message>
        <source>Base planes</source>
        <translation>Piani di base</translation>
    </message>
    <message>
        <source>Search anew</source>
        <translation>Cerca di nuovo</translation>
    </message>
    <message>
        <source>Keep these cuts</source>
        <translation>Tieni questi tagli</translation>
    </message>
    <message>
        <source>Gives up your cuts and lets the search decide</source>
        <translation>Rinuncia ai tuoi tagli e lascia decidere alla ricerca</translation>
    </message>
    <message>
        <source>Makes the cuts that were found your own, so that they stay</source>
        <translation>Fa tuoi i tagli trovati, così che restino</translation>
    </message>
    <message>
        <source>Pick root</source>
        <translation>Scegli la radice</translation>
    </message>
    <message>
        <source>Then click the part where the first piece is to be</source>
        <translation>Poi fai clic sul pezzo dove dev&apos;essere la prima parte</translation>
    </message>
    <message>
        <source>Click a piece to see where it is cut off, and to move that cut.</source>
        <translation>Fai clic su un pezzo per vedere dove è tagliato e per spostare quel taglio.</translation>
    </message>
    <message>
        <source>Drag the arrow to move the cut, a ring to tilt it. Esc lets go of it.</source>
        <translation>Trascina la freccia per spostare il taglio, un anello per inclinarlo. Esc lo lascia.</translation>
    </message>
    <message>
        <source>This piece stands on the plate: it has no cut of its own to move.</source>
        <translation>Questo pezzo poggia sul piatto: non ha un taglio proprio da spostare.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numeri</translation>
    </message>
    <message>
        <source>In the picture, in print order</source>
        <translation>Nell&apos;immagine, in ordine di stampa</translation>
    </message>
    <message>
        <source>Shows where each piece is cut off</source>
        <translation>Mostra dove ogni pezzo è tagliato</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PlacementPanel</name>
    <message>
        <source>Drop to plate</source>
        <translation>Abbassa sul piatto</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centra</translation>
    </message>
    <message>
        <source>Reset placement</source>
        <translation>Ripristina posizione</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Sposta</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Ruota</translation>
    </message>
    <message>
        <source>About the fixed axes: first X, then Y, then Z</source>
        <translation>Attorno agli assi fissi: prima X, poi Y, poi Z</translation>
    </message>
    <message>
        <source>Height of the lowest point above the plate</source>
        <translation>Altezza del punto più basso sopra il piatto</translation>
    </message>
    <message>
        <source>Middle of the part along %1</source>
        <translation>Centro del pezzo lungo %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Sposta %1</translation>
    </message>
    <message>
        <source>Turn about the fixed axis %1; X comes first, then Y, then Z</source>
        <translation>Ruota attorno all&apos;asse fisso %1; prima X, poi Y, poi Z</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Ruota %1</translation>
    </message>
    <message>
        <source>Turn by -90° about %1, from how the part lies now</source>
        <translation>Ruota di -90° attorno a %1, dalla posizione attuale</translation>
    </message>
    <message>
        <source>Turn by 90° about %1, from how the part lies now</source>
        <translation>Ruota di 90° attorno a %1, dalla posizione attuale</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>Scale in percent</source>
        <translation>Scala in percento</translation>
    </message>
    <message>
        <source>Scale as a factor</source>
        <translation>Fattore di scala</translation>
    </message>
    <message>
        <source>Fit to reach</source>
        <translation>Adatta al braccio</translation>
    </message>
    <message>
        <source>Scale down, if need be, to what the arm reaches everywhere</source>
        <translation>Riduce, se serve, fino a ciò che il braccio raggiunge ovunque</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misure</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>Appoggia su faccia</translation>
    </message>
    <message>
        <source>Then click the face that is to lie on the plate</source>
        <translation>Poi fai clic sulla faccia da appoggiare sul piatto</translation>
    </message>
    <message>
        <source>Put the middle of the part over the middle of the plate</source>
        <translation>Porta il centro del pezzo sul centro del piatto</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>As the part lies in its file, in its own size</source>
        <translation>Come nel file, nelle misure originali</translation>
    </message>
</context>
<context>
    <name>voluta::panels::VerdictTable</name>
    <message>
        <source>Part covered</source>
        <translation>Pezzo coperto</translation>
    </message>
    <message>
        <source>Unsupported</source>
        <translation>Senza appoggio</translation>
    </message>
    <message>
        <source>Overfill</source>
        <translation>Eccesso</translation>
    </message>
    <message>
        <source>Mass off by</source>
        <translation>Scarto di massa</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisioni</translation>
    </message>
    <message>
        <source>Limits broken</source>
        <translation>Limiti superati</translation>
    </message>
    <message>
        <source>Off the plan</source>
        <translation>Scarto dal piano</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Rispettato</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>Non rispettato</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::JointPlots</name>
    <message>
        <source>Angle (°)</source>
        <translation>Angolo (°)</translation>
    </message>
    <message>
        <source>Speed (°/s)</source>
        <translation>Velocità (°/s)</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tempo (s)</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Entrambi</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limiti</translation>
    </message>
    <message>
        <source>Show the limits of the joints as dashed lines</source>
        <translation>Mostra i limiti dei giunti come linee tratteggiate</translation>
    </message>
    <message>
        <source>Show joint %1</source>
        <translation>Mostra il giunto %1</translation>
    </message>
    <message>
        <source>Preparing the curves…</source>
        <translation>Preparazione delle curve…</translation>
    </message>
    <message>
        <source>Joints are drawn here once the motion is planned.</source>
        <translation>I giunti compaiono qui quando il movimento è pianificato.</translation>
    </message>
    <message>
        <source>No joint is chosen.</source>
        <translation>Nessun giunto scelto.</translation>
    </message>
    <message>
        <source>Show axis %1</source>
        <translation>Mostra l’asse %1</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::LayerRangeSlider</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Layers on show</source>
        <translation>Strati mostrati</translation>
    </message>
    <message>
        <source>No layers</source>
        <translation>Nessuno strato</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3</source>
        <translation>Strati da %1 a %2 di %3</translation>
    </message>
    <message>
        <source>Layers are shown here once they are planned.</source>
        <translation>Gli strati compaiono qui quando sono pianificati.</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3. Up and down keys move the upper end, with Shift the lower one; a double click shows a single layer.</source>
        <translation>Strati da %1 a %2 di %3. I tasti su e giù spostano l&apos;estremo superiore, con Maiusc quello inferiore; un doppio clic mostra un solo strato.</translation>
    </message>
    <message>
        <source>r %1 mm</source>
        <translation>r %1 mm</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::TimelineBar</name>
    <message>
        <source>move %1</source>
        <translation>movimento %1</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Strato precedente</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>Movimento precedente</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Avvia</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>Movimento successivo</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Strato successivo</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Velocità di riproduzione</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Moves of the layer</source>
        <translation>Movimenti dello strato</translation>
    </message>
    <message>
        <source>growth step %1</source>
        <translation>passo di crescita %1</translation>
    </message>
    <message>
        <source>Ten steps back</source>
        <translation>Dieci passi indietro</translation>
    </message>
    <message>
        <source>Previous growth step</source>
        <translation>Passo di crescita precedente</translation>
    </message>
    <message>
        <source>Next growth step</source>
        <translation>Passo di crescita successivo</translation>
    </message>
    <message>
        <source>Ten steps on</source>
        <translation>Dieci passi avanti</translation>
    </message>
    <message>
        <source>Steps of growth</source>
        <translation>Passi di crescita</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::ViewCube</name>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retro</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Sopra</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Sotto</translation>
    </message>
    <message>
        <source>Click a face to look from there, drag to turn the view</source>
        <translation>Clic su una faccia per guardare da lì, trascina per ruotare la vista</translation>
    </message>
</context>
<context>
    <name>voluta::window::ChoicesEditor</name>
    <message>
        <source>growth</source>
        <translation>crescita</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>piattaforma</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cella</translation>
    </message>
    <message>
        <source>process</source>
        <translation>processo</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>seme</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>cella %1</translation>
    </message>
    <message>
        <source>platform %1</source>
        <translation>piattaforma %1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>processo %1</translation>
    </message>
    <message>
        <source>scale %1</source>
        <translation>scala %1</translation>
    </message>
    <message>
        <source>the part as it lies</source>
        <translation>il pezzo come sta</translation>
    </message>
    <message>
        <source>shape of the rod</source>
        <translation>forma della barra</translation>
    </message>
    <message>
        <source>way of building</source>
        <translation>modo di costruire</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Scegli il file…</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usa %1</translation>
    </message>
    <message>
        <source>Which body is printed on? Without one it is the plate.</source>
        <translation>Su quale corpo si stampa? Senza, è il piatto.</translation>
    </message>
    <message>
        <source>Choose the body…</source>
        <translation>Scegli il corpo…</translation>
    </message>
    <message>
        <source>Changed with it: %1.</source>
        <translation>Cambiati insieme: %1.</translation>
    </message>
    <message>
        <source>what fits the way of building</source>
        <translation>ciò che va col modo di costruire</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePage</name>
    <message>
        <source>Nothing can be compared</source>
        <translation>Non c&apos;è nulla da confrontare</translation>
    </message>
    <message>
        <source>Adopted: %1. Press Plan.</source>
        <translation>Adottato: %1. Premi Pianifica.</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareView</name>
    <message>
        <source>way of building</source>
        <translation>modo di costruire</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>In corso</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>In attesa</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Non pianificato</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Superato</translation>
    </message>
    <message>
        <source>Nothing blocks</source>
        <translation>Nulla blocca</translation>
    </message>
    <message>
        <source>Blocked: %1</source>
        <translation>Bloccato: %1</translation>
    </message>
    <message>
        <source>Cannot be planned</source>
        <translation>Non pianificabile</translation>
    </message>
    <message>
        <source>Planned in %1</source>
        <translation>Pianificato in %1</translation>
    </message>
    <message>
        <source>Out of date: the part or its settings have changed since.</source>
        <translation>Superato: il pezzo o le impostazioni sono cambiati.</translation>
    </message>
    <message>
        <source>Best: %1.</source>
        <translation>Migliore: %1.</translation>
    </message>
    <message>
        <source>As good: %1.</source>
        <translation>Altrettanto buoni: %1.</translation>
    </message>
    <message>
        <source>None is best: something blocks each of them.</source>
        <translation>Nessuno è il migliore: qualcosa li blocca tutti.</translation>
    </message>
    <message>
        <source>Which way of building suits this part?
Tick what to compare at the right, then press Compare.</source>
        <translation>Quale modo di costruire conviene a questo pezzo?
Spunta a destra ciò che va confrontato, poi premi Confronta.</translation>
    </message>
    <message>
        <source>Adopt this way</source>
        <translation>Adotta questo modo</translation>
    </message>
    <message>
        <source>Build the part as the selected row does; undo takes it back</source>
        <translation>Costruisce il pezzo come la riga selezionata; si può annullare</translation>
    </message>
</context>
<context>
    <name>voluta::window::ExportPage</name>
    <message>
        <source>Open a part first.</source>
        <translation>Apri prima un pezzo.</translation>
    </message>
    <message>
        <source>Planning is under way.</source>
        <translation>Pianificazione in corso.</translation>
    </message>
    <message>
        <source>Nothing is planned yet. Press Plan.</source>
        <translation>Ancora niente di pianificato. Premi Pianifica.</translation>
    </message>
    <message>
        <source>A project keeps the plan, not the programs. Press Plan to write them.</source>
        <translation>Un progetto conserva il piano, non i programmi. Premi Pianifica per scriverli.</translation>
    </message>
    <message>
        <source>The programs are out of date. Press Plan.</source>
        <translation>I programmi non sono aggiornati. Premi Pianifica.</translation>
    </message>
    <message>
        <source>program formats</source>
        <translation>formati dei programmi</translation>
    </message>
    <message>
        <source>Files written to %1: %2</source>
        <translation>File scritti in %1: %2</translation>
    </message>
    <message>
        <source>; refused and not written: %1</source>
        <translation>; respinti e non scritti: %1</translation>
    </message>
    <message>
        <source>Nothing is exported</source>
        <translation>Niente è stato esportato</translation>
    </message>
</context>
<context>
    <name>voluta::window::FlowBar</name>
    <message>
        <source>nothing yet</source>
        <translation>ancora niente</translation>
    </message>
    <message>
        <source>running</source>
        <translation>in corso</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fatto</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>non aggiornato</translation>
    </message>
    <message>
        <source>blocked: see the findings</source>
        <translation>bloccato: vedi le segnalazioni</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayersPage</name>
    <message>
        <source>Growth is replayed: all layers</source>
        <translation>Si rivede la crescita: tutti gli strati</translation>
    </message>
    <message>
        <source>Pieces are shown whole</source>
        <translation>I pezzi sono mostrati interi</translation>
    </message>
</context>
<context>
    <name>voluta::window::MainWindow</name>
    <message>
        <source>Part and cell</source>
        <translation>Pezzo e cella</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Segnalazioni</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Salva l&apos;immagine</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>Impossibile scrivere %1. Scegli un&apos;altra cartella.</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Barra</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartHandles</name>
    <message>
        <source>drop to plate</source>
        <translation>abbassamento sul piatto</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centratura</translation>
    </message>
    <message>
        <source>lay on face</source>
        <translation>appoggio su faccia</translation>
    </message>
    <message>
        <source>place on touched points</source>
        <translation>posa su punti toccati</translation>
    </message>
    <message>
        <source>move</source>
        <translation>spostamento</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotazione</translation>
    </message>
</context>
<context>
    <name>voluta::window::PictureArea</name>
    <message>
        <source>The viewport needs OpenGL 3.2; this display offers %1. Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export work without a picture.</source>
        <translation>La vista richiede OpenGL 3.2; questo schermo offre %1. Aggiorna il driver grafico o imposta LIBGL_ALWAYS_SOFTWARE=1. Pianificazione ed esportazione funzionano anche senza vista.</translation>
    </message>
</context>
<context>
    <name>voluta::window::PieceCuts</name>
    <message>
        <source>keep cuts</source>
        <translation>tagli tenuti</translation>
    </message>
    <message>
        <source>search for cuts</source>
        <translation>ricerca dei tagli</translation>
    </message>
    <message>
        <source>move cut</source>
        <translation>spostamento del taglio</translation>
    </message>
    <message>
        <source>pick root</source>
        <translation>scelta della radice</translation>
    </message>
</context>
<context>
    <name>voluta::window::PreparePage</name>
    <message>
        <source>repair the mesh</source>
        <translation>riparazione della mesh</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>mesh come letta</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Not a value for this parameter</source>
        <translation>Valore non valido per questo parametro</translation>
    </message>
</context>
<context>
    <name>voluta::window::ProjectFiles</name>
    <message>
        <source>Opening %1</source>
        <translation>Apertura di %1</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Pronto. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Interrotto.</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>Impossibile aprire %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Salvato %1</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 non è stato salvato</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Apri recenti</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Parts and projects (*.stl *.obj *.ply *.off *.3mf *.txt *.voxels *.voluta);;All files (*)</source>
        <translation>Pezzi e progetti (*.stl *.obj *.ply *.off *.3mf *.txt *.voxels *.voluta);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>Aperto %1</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salva il progetto</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Progetti Voluta (*.voluta)</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recupera il lavoro non salvato</translation>
    </message>
    <message>
        <source>Voluta ended unexpectedly. “%1” was kept on %2.</source>
        <translation>Voluta si è chiuso in modo imprevisto. Di “%1” c&apos;è una copia del %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recupera</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Più tardi</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifiche non salvate</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>“%1” ha modifiche non salvate.</translation>
    </message>
</context>
<context>
    <name>voluta::window::Runs</name>
    <message>
        <source>%1 voxels, %2 missed</source>
        <translation>%1 voxel, %2 mancati</translation>
    </message>
    <message>
        <source>%1 pieces, %2 mm² need support</source>
        <translation>%1 pezzi, %2 mm² da supportare</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 strati</translation>
    </message>
    <message>
        <source>%1 waypoints</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>replay passed</source>
        <translation>verifica superata</translation>
    </message>
    <message>
        <source>replay not passed</source>
        <translation>verifica non superata</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>Pronto. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Done. Findings that block: %1.</source>
        <translation>Fatto. Segnalazioni bloccanti: %1.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fatto.</translation>
    </message>
    <message>
        <source>The pieces follow the settings. Press Plan for layers and paths.</source>
        <translation>I pezzi seguono le impostazioni. Premi Pianifica per strati e percorsi.</translation>
    </message>
    <message>
        <source>The voxels follow the settings. Press Plan for layers and paths.</source>
        <translation>I voxel seguono le impostazioni. Premi Pianifica per strati e percorsi.</translation>
    </message>
    <message>
        <source>Press Plan for layers and paths.</source>
        <translation>Premi Pianifica per strati e percorsi.</translation>
    </message>
    <message>
        <source>Cancelled. The last results stay on show.</source>
        <translation>Interrotto. Gli ultimi risultati restano in vista.</translation>
    </message>
    <message>
        <source>The run has stopped</source>
        <translation>Calcolo interrotto</translation>
    </message>
    <message>
        <source>Compared. Select a row to adopt it.</source>
        <translation>Confronto fatto. Seleziona una riga per adottarla.</translation>
    </message>
    <message>
        <source>Preview: %1, %2 growth steps</source>
        <translation>Anteprima: %1, %2 passi di crescita</translation>
    </message>
    <message>
        <source>Preview: %1, layers are being improved</source>
        <translation>Anteprima: %1, gli strati si affinano</translation>
    </message>
    <message>
        <source>Preview: %1. Press Plan.</source>
        <translation>Anteprima: %1. Premi Pianifica.</translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation>Non aggiornato: %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ShortcutsDialog</name>
    <message>
        <source>Keys</source>
        <translation>Scorciatoie</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tasti</translation>
    </message>
    <message>
        <source>Default key</source>
        <translation>Predefiniti</translation>
    </message>
    <message>
        <source>New key:</source>
        <translation>Nuovi tasti:</translation>
    </message>
    <message>
        <source>“%1” had this key and has none now.</source>
        <translation>“%1” aveva questi tasti e ora non ne ha.</translation>
    </message>
</context>
<context>
    <name>voluta::window::SpacingView</name>
    <message>
        <source>%1–%2 mm: %3 % of the area</source>
        <translation>%1–%2 mm: %3 % dell&apos;area</translation>
    </message>
    <message>
        <source>Layer spacing, share of area by thickness [mm]</source>
        <translation>Spaziatura degli strati, quota d&apos;area per spessore [mm]</translation>
    </message>
    <message>
        <source>Mean %1 mm. Within %2–%3 mm: %4 %.</source>
        <translation>Media %1 mm. Entro %2–%3 mm: %4 %.</translation>
    </message>
    <message>
        <source>Too thin: %1 %.</source>
        <translation>Troppo sottile: %1 %.</translation>
    </message>
    <message>
        <source>Too thick: %1 %.</source>
        <translation>Troppo spesso: %1 %.</translation>
    </message>
</context>
<context>
    <name>voluta::window::StatusLine</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>circa %1 rimanenti</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
</context>
<context>
    <name>voluta::window::TouchDialog</name>
    <message>
        <source>Line %1 is not a point: write y and z, or x, y and z, in mm.</source>
        <translation>La riga %1 non è un punto: scrivi y e z, o x, y e z, in mm.</translation>
    </message>
    <message>
        <source>Place on touched points</source>
        <translation>Posa su punti toccati</translation>
    </message>
    <message>
        <source>Touch a cylinder that lies along x at three points or more, and enter them in the work frame: y z, or x y z, one point a line [mm].</source>
        <translation>Tocca in tre o più punti un cilindro disteso lungo x e scrivili nel riferimento di lavoro: y z, o x y z, un punto per riga [mm].</translation>
    </message>
    <message>
        <source>y of the axis in the model</source>
        <translation>y dell’asse nel modello</translation>
    </message>
    <message>
        <source>z of the axis in the model</source>
        <translation>z dell’asse nel modello</translation>
    </message>
    <message>
        <source>Axis in the model (y, z)</source>
        <translation>Asse nel modello (y, z)</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>Sposta il pezzo</translation>
    </message>
    <message>
        <source>Centre y %1, z %2 mm; radius %3 mm; points: %4, off by %5 mm on average.</source>
        <translation>Centro y %1, z %2 mm; raggio %3 mm; punti: %4, scarto medio %5 mm.</translation>
    </message>
    <message>
        <source>The part is moved by y %1, z %2 mm.</source>
        <translation>Il pezzo si sposta di y %1, z %2 mm.</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledCanvas</name>
    <message>
        <source>→ around, ↑ along [mm]</source>
        <translation>→ intorno, ↑ lungo [mm]</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledDock</name>
    <message>
        <source>Layer %1 of %2</source>
        <translation>Strato %1 di %2</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Strato srotolato</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledView</name>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Riempimento</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Riempimento vuoti</translation>
    </message>
    <message>
        <source>Skirt</source>
        <translation>Skirt</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Supporto</translation>
    </message>
    <message>
        <source>Around %1 mm (%2°), along %3 mm</source>
        <translation>Intorno %1 mm (%2°), lungo %3 mm</translation>
    </message>
    <message>
        <source>Around %1 mm, along %2 mm</source>
        <translation>Intorno %1 mm, lungo %2 mm</translation>
    </message>
    <message>
        <source>%1 %2, waypoint %3 of %4</source>
        <translation>%1 %2, punto %3 di %4</translation>
    </message>
    <message>
        <source>This layer has no paths around an axis.</source>
        <translation>Questo strato non ha percorsi intorno a un asse.</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>Strato srotolato</translation>
    </message>
    <message>
        <source>Click a path to find it in the 3D view. Wheel zooms, drag moves, double click shows all.</source>
        <translation>Fai clic su un percorso per trovarlo nella vista 3D. La rotella ingrandisce, trascinare sposta, il doppio clic mostra tutto.</translation>
    </message>
</context>
<context>
    <name>voluta::window::ViewOptions</name>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colora per</translation>
    </message>
    <message>
        <source>Latest</source>
        <translation>Ultimo</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Percorsi</translation>
    </message>
    <message>
        <source>What the plan has come to</source>
        <translation>Il punto a cui è arrivato il piano</translation>
    </message>
    <message>
        <source>Layers as slabs of their thickness</source>
        <translation>Strati come lastre del loro spessore</translation>
    </message>
    <message>
        <source>Tool-paths as the beads that are laid</source>
        <translation>Percorsi utensile come cordoni deposti</translation>
    </message>
    <message>
        <source>Part&apos;s surface</source>
        <translation>Superficie del pezzo</translation>
    </message>
    <message>
        <source>Travel moves</source>
        <translation>Spostamenti a vuoto</translation>
    </message>
    <message>
        <source>Beads in their true width</source>
        <translation>Cordoni a larghezza reale</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Piano di sezione</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Inverti</translation>
    </message>
    <message>
        <source>Cut away the other side</source>
        <translation>Togli l&apos;altro lato</translation>
    </message>
    <message>
        <source>Place of the section plane</source>
        <translation>Posizione del piano di sezione</translation>
    </message>
    <message>
        <source>Solid voxels, and how they grow</source>
        <translation>Voxel solidi, e come crescono</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Fronte convesso</translation>
    </message>
    <message>
        <source>While growth is replayed: the hull that the next voxels must not lie in</source>
        <translation>Mentre si rivede la crescita: l&apos;involucro in cui i prossimi voxel non devono trovarsi</translation>
    </message>
    <message>
        <source>Later voxels faintly</source>
        <translation>Voxel successivi in trasparenza</translation>
    </message>
    <message>
        <source>While growth is replayed: what is still to be laid</source>
        <translation>Mentre si rivede la crescita: ciò che resta da deporre</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Pieces that print without support, and their base planes</source>
        <translation>Pezzi che si stampano senza supporto, e i loro piani di base</translation>
    </message>
</context>
<context>
    <name>voluta::window::Welcome</name>
    <message>
        <source>Print a part with a robot</source>
        <translation>Stampa un pezzo con un robot</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Vista non disponibile</translation>
    </message>
    <message>
        <source>Drop a mesh here (STL, OBJ, PLY, OFF or 3MF), or a Voluta project.</source>
        <translation>Trascina qui una mesh (STL, OBJ, PLY, OFF o 3MF) o un progetto Voluta.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Sample vase</source>
        <translation>Vaso di esempio</translation>
    </message>
</context>
</TS>
