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
        <source>Show &amp;log</source>
        <translation>Mostra il &amp;registro</translation>
    </message>
    <message>
        <source>What was opened, planned and found, and what failed</source>
        <translation>Ciò che è stato aperto, pianificato e trovato, e ciò che non è riuscito</translation>
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
    <message>
        <source>&amp;Resume print from here…</source>
        <translation>&amp;Riprendi la stampa da qui…</translation>
    </message>
    <message>
        <source>The rest of a print that was stopped at this moment, as a project of its own</source>
        <translation>Il resto di una stampa interrotta in questo momento, come progetto a sé</translation>
    </message>
    <message>
        <source>&amp;Verify a program…</source>
        <translation>&amp;Verifica un programma…</translation>
    </message>
    <message>
        <source>Replay a program from disk against the plan on show</source>
        <translation>Esegui di prova un programma da disco e confrontalo con il piano mostrato</translation>
    </message>
    <message>
        <source>Edit &amp;cell…</source>
        <translation>Modifica &amp;cella…</translation>
    </message>
    <message>
        <source>Where nozzle, plate and obstacles stand, and which robot</source>
        <translation>Dove stanno ugello, piatto e ostacoli, e quale robot</translation>
    </message>
    <message>
        <source>Import robot &amp;arm…</source>
        <translation>Importa &amp;braccio robotico…</translation>
    </message>
    <message>
        <source>A robot of your own, from its URDF, with a cell for it</source>
        <translation>Un robot proprio, dal suo URDF, con una cella</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>&quot;{text}&quot; is no point</source>
        <translation>&quot;{text}&quot; non è un punto</translation>
    </message>
    <message>
        <source>&apos;end&apos; closes no function</source>
        <translation>&apos;end&apos; non chiude alcuna funzione</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is no number</source>
        <translation>&apos;{attribute}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is no whole number</source>
        <translation>&apos;{attribute}&apos; non è un numero intero</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; names no vertex</source>
        <translation>&apos;{corner}&apos; non indica alcun vertice</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; names no vertex read so far</source>
        <translation>&apos;{corner}&apos; non indica alcun vertice già letto</translation>
    </message>
    <message>
        <source>&apos;{loaded}&apos; is not unloaded</source>
        <translation>&apos;{loaded}&apos; non viene scaricato</translation>
    </message>
    <message>
        <source>&apos;{member}&apos; in it {what}</source>
        <translation>&apos;{member}&apos; al suo interno {what}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is called outside the function</source>
        <translation>&apos;{name}&apos; è chiamato fuori dalla funzione</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is no {type}</source>
        <translation>&apos;{name}&apos; non è di tipo {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not declared as {type}</source>
        <translation>&apos;{name}&apos; non è dichiarato come {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not known to the reader</source>
        <translation>&apos;{name}&apos; non è noto al lettore</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no weight</source>
        <translation>&apos;{text}&apos; non è un peso</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a number</source>
        <translation>&apos;{text}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not expected here</source>
        <translation>&apos;{text}&apos; non è atteso qui</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not key=value</source>
        <translation>&apos;{text}&apos; non è chiave=valore</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is neither true nor false</source>
        <translation>&apos;{value}&apos; non è né true né false</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a number</source>
        <translation>&apos;{value}&apos; non è un numero</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a whole number</source>
        <translation>&apos;{value}&apos; non è un numero intero</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not one of {choices}</source>
        <translation>&apos;{value}&apos; non è tra {choices}</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is out of range</source>
        <translation>&apos;{value}&apos; è fuori dall&apos;intervallo</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not known to the reader</source>
        <translation>&apos;{word}&apos; non è noto al lettore</translation>
    </message>
    <message>
        <source>--ik: the quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>--ik: la lunghezza del quaternione è {length:.4g}, non 1</translation>
    </message>
    <message>
        <source>0: a round rod; 3 or more: a prism, measured over its corners.</source>
        <translation>0: barra tonda; 3 o più: un prisma, misurato sugli spigoli.</translation>
    </message>
    <message>
        <source>Adaptive layers: how far the edges of layers may stand out of the surface.</source>
        <translation>Strati adattivi: di quanto i bordi degli strati possono sporgere dalla superficie.</translation>
    </message>
    <message>
        <source>Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp and trajectory.csv.</source>
        <translation>Aggiunge voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp e trajectory.csv.</translation>
    </message>
    <message>
        <source>Also writes programs that the replay refused, as refused-NAME, to be looked at and never to be run.</source>
        <translation>Scrive anche i programmi respinti dalla verifica, come refused-NOME: da esaminare, mai da eseguire.</translation>
    </message>
    <message>
        <source>At constant radius about the axis, or at constant distance from the rod&apos;s profile.</source>
        <translation>A raggio costante intorno all’asse, o a distanza costante dal profilo della barra.</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>cordoni</translation>
    </message>
    <message>
        <source>Beads laid along the edge of each layer before it is filled.</source>
        <translation>Cordoni deposti lungo il bordo di ogni strato prima del riempimento.</translation>
    </message>
    <message>
        <source>Colli-
sions</source>
        <translation>Colli-
sioni</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>Fronte convesso</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Scomposizione</translation>
    </message>
    <message>
        <source>Direction of straight lines on the first layer, from x to y.</source>
        <translation>Direzione delle linee rette sul primo strato, da x verso y.</translation>
    </message>
    <message>
        <source>Distance that all but the print head keeps from what is printed.</source>
        <translation>Distanza minima dal materiale stampato per tutto tranne la testa di stampa.</translation>
    </message>
    <message>
        <source>Distance that links, plate, nozzle holder and obstacles keep from each other.</source>
        <translation>Distanza minima fra membri del braccio, piatto, portaugello e ostacoli.</translation>
    </message>
    <message>
        <source>ENDMODULE is missing: the file was cut short</source>
        <translation>manca ENDMODULE: il file è stato troncato</translation>
    </message>
    <message>
        <source>ENDPROC closes no procedure</source>
        <translation>ENDPROC non chiude alcuna procedura</translation>
    </message>
    <message>
        <source>Field rounds</source>
        <translation>cicli del campo</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>fronte</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>Riempimento vuoti</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppo</translation>
    </message>
    <message>
        <source>Growth incremental, adaptive, guided: a layer takes voxels as long as it cuts off fewer than this many others. 1: none. 0: fewer than the whole layer would.</source>
        <translation>Crescita voxel per voxel, a strati dimezzati, guidata: uno strato prende voxel finché ne isola meno di questi. 1: nessuno. 0: meno di quanti ne isolerebbe lo strato intero.</translation>
    </message>
    <message>
        <source>Growth incremental, adaptive, guided: where every voxel of a layer would cut others off, lay all of it as the source does (layer) or only what cuts off fewest (least).</source>
        <translation>Crescita voxel per voxel, a strati dimezzati, guidata: dove ogni voxel di uno strato ne isolerebbe altri, deporlo tutto come fa la fonte (strato) o solo ciò che ne isola di meno (il meno possibile).</translation>
    </message>
    <message>
        <source>Growth incremental: a layer&apos;s voxels are tried outwards from the first one (flooding) or in the order they were found (insertion).</source>
        <translation>Crescita voxel per voxel: i voxel di uno strato si provano dal primo verso l&apos;esterno (a espansione) o nell&apos;ordine in cui sono stati trovati (di inserimento).</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Passo di crescita</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>How far a face may lean over from the upright without support, in every mode but curved.</source>
        <translation>Quanto una faccia può sporgere dalla verticale senza supporto, in tutti i modi tranne quello curvo.</translation>
    </message>
    <message>
        <source>How far the nozzle leaves the part, at least, before it travels.</source>
        <translation>Di quanto, almeno, l&apos;ugello si stacca dal pezzo prima di spostarsi a vuoto.</translation>
    </message>
    <message>
        <source>How many turns of the part about the nozzle&apos;s axis are tried at each place.</source>
        <translation>Quante rotazioni del pezzo attorno all&apos;asse dell&apos;ugello vengono provate in ogni punto.</translation>
    </message>
    <message>
        <source>How much straight lines turn from layer to layer; 0: all one way.</source>
        <translation>Di quanto girano le linee rette da uno strato all’altro; 0: tutte allo stesso modo.</translation>
    </message>
    <message>
        <source>How often growth and smooth field are fitted to each other at most. 0: layers from the ranks.</source>
        <translation>Quante volte al massimo crescita e campo liscio vengono adattati l&apos;una all&apos;altro. 0: strati dai ranghi.</translation>
    </message>
    <message>
        <source>How the inside of each layer is filled.</source>
        <translation>Come viene riempito l&apos;interno di ogni strato.</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Riempimento</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>Layer spacing</source>
        <translation>Spaziatura degli strati</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <source>Layers that flatten end on it: flat (at the part&apos;s top), flat:Z, radius:R (a wider cylinder) or mesh:FILE, placed with the platform&apos;s.</source>
        <translation>Gli strati che spianano finiscono qui: flat (in cima al pezzo), flat:Z, radius:R (un cilindro più largo) o mesh:FILE, posato con quello della piattaforma.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Caricamento</translation>
    </message>
    <message>
        <source>Longest distance of waypoints along a tool-path.</source>
        <translation>Distanza massima fra i punti di un percorso utensile.</translation>
    </message>
    <message>
        <source>Looks for a better way for the part to lie, from where it was put: with the least overhanging area, or with the fewest voxels missed by growth.</source>
        <translation>Cerca una giacitura migliore del pezzo, da dove è stato messo: con la minore area a sbalzo, o con il minor numero di voxel mancati dalla crescita.</translation>
    </message>
    <message>
        <source>Missed
voxels</source>
        <translation>Voxel
persi</translation>
    </message>
    <message>
        <source>Missed, cascade</source>
        <translation>Mancati, a cascata</translation>
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
        <source>Mode flat: a JSON file, or its text, with the plane or quadrilateral of each layer. Empty: layers along z.</source>
        <translation>Modo flat: un file JSON, o il suo testo, con il piano o quadrilatero di ogni strato. Vuoto: strati lungo z.</translation>
    </message>
    <message>
        <source>Mode planar: a JSON file, or its text, with a point and a normal for each plane that cuts the part, in turn. Empty: they are searched for.</source>
        <translation>Modo planar: un file JSON, o il suo testo, con un punto e una normale per ogni piano che taglia il pezzo, uno dopo l&apos;altro. Vuoto: i piani vengono cercati.</translation>
    </message>
    <message>
        <source>Mode planar: a material or filament for each piece, separated by commas; from the first again where there are more pieces. Empty: the process&apos;s.</source>
        <translation>Modo planar: un materiale o filamento per ogni pezzo, separati da virgole; si ricomincia dal primo se i pezzi sono di più. Vuoto: quello del processo.</translation>
    </message>
    <message>
        <source>Mode planar: beam keeps several partial results and asks of the head&apos;s true shape; greedy is the published scheme, by the part&apos;s skeleton.</source>
        <translation>Modo planar: beam tiene più risultati parziali e tiene conto della vera forma della testa; greedy è lo schema pubblicato, secondo lo scheletro del pezzo.</translation>
    </message>
    <message>
        <source>Mode substrate: at constant distance from the surface, on spheres, on cylinders along x, or from the surface to an end surface, thicker where the way is longer.</source>
        <translation>Modo substrate: a distanza costante dalla superficie, su sfere, su cilindri lungo x, o dalla superficie a una superficie finale, più spessi dove la via è più lunga.</translation>
    </message>
    <message>
        <source>Modes lathe and substrate: height of the layer on the ground; 0: as high as the others.</source>
        <translation>Modi lathe e substrate: altezza dello strato sul fondo; 0: alto come gli altri.</translation>
    </message>
    <message>
        <source>Modes planar and flat: thinner layers where the surface leans, within the process&apos;s limits.</source>
        <translation>Modi planar e flat: strati più sottili dove la superficie è inclinata, entro i limiti del processo.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Needs support</source>
        <translation>Richiede supporto</translation>
    </message>
    <message>
        <source>Of helical infill: 0 winds around the axis, 90 runs along it.</source>
        <translation>Del riempimento elicoidale: 0 si avvolge attorno all&apos;asse, 90 corre lungo l&apos;asse.</translation>
    </message>
    <message>
        <source>Of spheres and cylinders: x,y,z in mm. Empty: of the ball or cylinder that the part stands on, or below the part.</source>
        <translation>Di sfere e cilindri: x,y,z in mm. Vuoto: quello della sfera o del cilindro su cui sta il pezzo, o sotto il pezzo.</translation>
    </message>
    <message>
        <source>Order of trying</source>
        <translation>ordine dei tentativi</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>file in uscita</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with them; a step has two pairs at one x. Beyond them the rod goes on as it is. Empty: straight.</source>
        <translation>Coppie di x e raggio in mm, come -20,2.5 0,2.5 0,3.5 20,3.5, o un file che le contiene; un gradino ha due coppie alla stessa x. Oltre, la barra continua com’è. Vuoto: diritta.</translation>
    </message>
    <message>
        <source>Peeling rank</source>
        <translation>Rango di pelatura</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>RAPID (ABB)</source>
        <translation>RAPID (ABB)</translation>
    </message>
    <message>
        <source>Reach
%</source>
        <translation>Porta-
ta %</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Risky
mm²</source>
        <translation>Rischio
mm²</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>Scheme greedy: how many thicknesses the part&apos;s branches are told apart by. 0: as many as stand apart.</source>
        <translation>Schema greedy: quanti spessori distinguono i rami del pezzo. 0: quanti risultano distinti.</translation>
    </message>
    <message>
        <source>Scheme greedy: x,y,z (mm) of a place on what is printed first; it must stand on the plate. Empty: what stands on it with most area.</source>
        <translation>Schema greedy: x,y,z (mm) di un punto su ciò che si stampa per primo; deve poggiare sul piatto. Vuoto: ciò che vi poggia con più area.</translation>
    </message>
    <message>
        <source>Shadowed per layer</source>
        <translation>isolati per strato</translation>
    </message>
    <message>
        <source>Shape of the head that must clear all that is printed earlier: a flat one as wide as needed, or the head as it is: where voxels would be lost otherwise (nozzle) and under wide roofs (nozzle and auto).</source>
        <translation>Forma della testa che deve evitare tutto ciò che è già stampato: una piatta, larga quanto serve, o la testa com&apos;è: dove altrimenti si perderebbero dei voxel (ugello) e sotto tetti ampi (ugello e automatico).</translation>
    </message>
    <message>
        <source>Share of the inside that is filled; 1 is solid.</source>
        <translation>Quota dell&apos;interno da riempire; 1 è pieno.</translation>
    </message>
    <message>
        <source>Skirt</source>
        <translation>Skirt</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Step being laid</source>
        <translation>Passo in deposizione</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Supporto</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>supporti</translation>
    </message>
    <message>
        <source>Supports
mm³</source>
        <translation>Supporti
mm³</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>The sources&apos; schemes: whether a voxel that lies exactly on the convex front can still be laid (outside) or is cut off by it (inside).</source>
        <translation>Schemi delle fonti: se un voxel che giace esattamente sul fronte convesso si può ancora deporre (fuori) o ne resta isolato (dentro).</translation>
    </message>
    <message>
        <source>Tilt of the nozzle</source>
        <translation>Inclinazione dell&apos;ugello</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Too thick to lay</source>
        <translation>Troppo spesso da deporre</translation>
    </message>
    <message>
        <source>Too thin to lay</source>
        <translation>Troppo sottile da deporre</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>Percorsi utensile</translation>
    </message>
    <message>
        <source>URScript (Universal Robots)</source>
        <translation>URScript (Universal Robots)</translation>
    </message>
    <message>
        <source>Use voxel width {fits}</source>
        <translation>Usa voxel larghi {fits}</translation>
    </message>
    <message>
        <source>Voxel width</source>
        <translation>larghezza voxel</translation>
    </message>
    <message>
        <source>Voxels on the front</source>
        <translation>voxel sul fronte</translation>
    </message>
    <message>
        <source>WaitTime needs its seconds</source>
        <translation>WaitTime richiede i suoi secondi</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Wanted height of a layer; the process limits what it may become.</source>
        <translation>Altezza desiderata di uno strato; il processo ne fissa i limiti.</translation>
    </message>
    <message>
        <source>Wanted width of a bead; the process limits what it may become.</source>
        <translation>Larghezza desiderata di un cordone; il processo ne fissa i limiti.</translation>
    </message>
    <message>
        <source>What carries voxels that growth would miss: nothing, or columns as thin as a voxel, to be broken off afterwards.</source>
        <translation>Che cosa regge i voxel che la crescita mancherebbe: nulla, o colonne sottili quanto un voxel, da staccare alla fine.</translation>
    </message>
    <message>
        <source>Where nothing is safe</source>
        <translation>dove nulla è sicuro</translation>
    </message>
    <message>
        <source>Which of the part&apos;s own axes is laid on the rod; auto: the one that its sides run along.</source>
        <translation>Quale degli assi del pezzo si posa sulla barra; auto: quello lungo cui corrono i suoi fianchi.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Width of the voxels that growth works on; layers are not bound to it.</source>
        <translation>Larghezza dei voxel su cui lavora la crescita; gli strati non ne dipendono.</translation>
    </message>
    <message>
        <source>a G command that is not known to the reader</source>
        <translation>un comando G non noto al lettore</translation>
    </message>
    <message>
        <source>a PLY file begins with &quot;ply&quot;</source>
        <translation>un file PLY comincia con &quot;ply&quot;</translation>
    </message>
    <message>
        <source>a call of what was not loaded</source>
        <translation>una chiamata a ciò che non è stato caricato</translation>
    </message>
    <message>
        <source>a column of {voxels} from {foot} carries {carried} that would be missed</source>
        <translation>una colonna di {voxels} da {foot} porta {carried} che altrimenti mancherebbero</translation>
    </message>
    <message>
        <source>a configuration is whole quarters of a turn</source>
        <translation>una configurazione è un numero intero di quarti di giro</translation>
    </message>
    <message>
        <source>a digital output is 0 or 1</source>
        <translation>un&apos;uscita digitale è 0 o 1</translation>
    </message>
    <message>
        <source>a direction needs nX, nY and nZ</source>
        <translation>una direzione richiede nX, nY e nZ</translation>
    </message>
    <message>
        <source>a direction whose length is not 1</source>
        <translation>una direzione la cui lunghezza non è 1</translation>
    </message>
    <message>
        <source>a face names vertex {vertex} of {vertices}</source>
        <translation>una faccia indica il vertice {vertex} di {vertices}</translation>
    </message>
    <message>
        <source>a face needs its number of corners, then the corners</source>
        <translation>una faccia richiede il numero dei suoi vertici, poi i vertici</translation>
    </message>
    <message>
        <source>a face needs three corners or more</source>
        <translation>una faccia richiede tre o più vertici</translation>
    </message>
    <message>
        <source>a facet of fewer than three vertices</source>
        <translation>una faccetta con meno di tre vertici</translation>
    </message>
    <message>
        <source>a flow of {flow:.1f}, the extruder gives {limit:.1f#}</source>
        <translation>un flusso di {flow:.1f}, l&apos;estrusore dà {limit:.1f#}</translation>
    </message>
    <message>
        <source>a joint value far outside any limit</source>
        <translation>un valore di giunto molto oltre ogni limite</translation>
    </message>
    <message>
        <source>a larger platform, or turn the part</source>
        <translation>una piattaforma più grande, o girare il pezzo</translation>
    </message>
    <message>
        <source>a larger platform, supports, or join this piece to the part</source>
        <translation>una piattaforma più grande, supporti, o unire questa parte al pezzo</translation>
    </message>
    <message>
        <source>a line does not end with CR LF</source>
        <translation>una riga non termina con CR LF</translation>
    </message>
    <message>
        <source>a line without a command</source>
        <translation>una riga senza comando</translation>
    </message>
    <message>
        <source>a list has an impossible length</source>
        <translation>una lista ha una lunghezza impossibile</translation>
    </message>
    <message>
        <source>a mesh with corners that are not there</source>
        <translation>una mesh con vertici che non esistono</translation>
    </message>
    <message>
        <source>a module begins with MODULE and its name</source>
        <translation>un modulo comincia con MODULE e il suo nome</translation>
    </message>
    <message>
        <source>a motion before X, Y and Z are all known</source>
        <translation>un movimento prima che X, Y e Z siano tutti noti</translation>
    </message>
    <message>
        <source>a motion before any speed (F)</source>
        <translation>un movimento prima di una velocità (F)</translation>
    </message>
    <message>
        <source>a motion that never gets anywhere: no speed or acceleration</source>
        <translation>un movimento che non arriva mai: nessuna velocità o accelerazione</translation>
    </message>
    <message>
        <source>a motion with a word {letter} is not understood</source>
        <translation>un movimento con la parola {letter} non è compreso</translation>
    </message>
    <message>
        <source>a motion without a target</source>
        <translation>un movimento senza destinazione</translation>
    </message>
    <message>
        <source>a name is declared twice</source>
        <translation>un nome è dichiarato due volte</translation>
    </message>
    <message>
        <source>a narrower bead or a lower layer height follows finer detail; support carries what begins in the air</source>
        <translation>un cordone più stretto o strati più bassi seguono dettagli più fini; un supporto porta ciò che comincia nel vuoto</translation>
    </message>
    <message>
        <source>a picture of {width} x {height} pixels cannot be drawn</source>
        <translation>un&apos;immagine di {width} x {height} pixel non può essere disegnata</translation>
    </message>
    <message>
        <source>a platform is a mesh, not a voxel object</source>
        <translation>una piattaforma è una mesh, non un oggetto di voxel</translation>
    </message>
    <message>
        <source>a point is not a number</source>
        <translation>un punto non è un numero</translation>
    </message>
    <message>
        <source>a point is three numbers</source>
        <translation>un punto è tre numeri</translation>
    </message>
    <message>
        <source>a point that is nowhere near a part</source>
        <translation>un punto lontanissimo da ogni pezzo</translation>
    </message>
    <message>
        <source>a pose before set_tcp: whose pose is it?</source>
        <translation>una posa prima di set_tcp: di che cosa è la posa?</translation>
    </message>
    <message>
        <source>a pose far outside any robot&apos;s reach</source>
        <translation>una posa molto oltre la portata di ogni robot</translation>
    </message>
    <message>
        <source>a pose p[x,y,z,rx,ry,rz] is needed</source>
        <translation>serve una posa p[x,y,z,rx,ry,rz]</translation>
    </message>
    <message>
        <source>a position far outside any robot&apos;s reach</source>
        <translation>una posizione molto oltre la portata di ogni robot</translation>
    </message>
    <message>
        <source>a property of unknown type</source>
        <translation>una proprietà di tipo sconosciuto</translation>
    </message>
    <message>
        <source>a quadrilateral does not cut a part</source>
        <translation>un quadrilatero non taglia un pezzo</translation>
    </message>
    <message>
        <source>a quadrilateral has four corners</source>
        <translation>un quadrilatero ha quattro vertici</translation>
    </message>
    <message>
        <source>a quaternion whose length is not 1</source>
        <translation>un quaternione la cui lunghezza non è 1</translation>
    </message>
    <message>
        <source>a rod is round or has three sides at least</source>
        <translation>una barra è tonda o ha almeno tre lati</translation>
    </message>
    <message>
        <source>a rod needs two points at least</source>
        <translation>una barra richiede almeno due punti</translation>
    </message>
    <message>
        <source>a row beyond its array</source>
        <translation>una riga oltre il suo vettore</translation>
    </message>
    <message>
        <source>a second, different TCP</source>
        <translation>un secondo TCP, diverso</translation>
    </message>
    <message>
        <source>a second, different tool</source>
        <translation>un secondo utensile, diverso</translation>
    </message>
    <message>
        <source>a shifted origin is not understood</source>
        <translation>un&apos;origine spostata non è compresa</translation>
    </message>
    <message>
        <source>a space</source>
        <translation>uno spazio</translation>
    </message>
    <message>
        <source>a speed is no sensible number</source>
        <translation>una velocità non è un numero sensato</translation>
    </message>
    <message>
        <source>a speed that is not above 0</source>
        <translation>una velocità non superiore a 0</translation>
    </message>
    <message>
        <source>a statement outside the procedure</source>
        <translation>un&apos;istruzione fuori dalla procedura</translation>
    </message>
    <message>
        <source>a step at the end of the rod</source>
        <translation>un gradino all&apos;estremità della barra</translation>
    </message>
    <message>
        <source>a target of fewer than six joints</source>
        <translation>una destinazione con meno di sei giunti</translation>
    </message>
    <message>
        <source>a time is no sensible number</source>
        <translation>un tempo non è un numero sensato</translation>
    </message>
    <message>
        <source>a transform has not twelve numbers</source>
        <translation>una trasformazione non ha dodici numeri</translation>
    </message>
    <message>
        <source>a transform is not of numbers</source>
        <translation>una trasformazione non è fatta di numeri</translation>
    </message>
    <message>
        <source>a triangle of vertex {vertex}, which is not there</source>
        <translation>un triangolo con il vertice {vertex}, che non esiste</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>un vertice richiede tre numeri</translation>
    </message>
    <message>
        <source>a voxel width of at most {fits}</source>
        <translation>voxel larghi al massimo {fits}</translation>
    </message>
    <message>
        <source>a wall {usual:.2f} thick ({thinnest:.2f} at its thinnest) is thinner than a voxel of {voxel}</source>
        <translation>una parete spessa {usual:.2f} ({thinnest:.2f} nel punto più sottile) è più sottile di un voxel di {voxel}</translation>
    </message>
    <message>
        <source>a waypoint&apos;s number is a whole number from -1</source>
        <translation>il numero di un punto del percorso è un intero da -1</translation>
    </message>
    <message>
        <source>a work object is moved by the mechanical unit that it names, or stands still</source>
        <translation>un oggetto di lavoro è mosso dall&apos;unità meccanica che indica, o sta fermo</translation>
    </message>
    <message>
        <source>a zone is no sensible number</source>
        <translation>una zona non è un numero sensato</translation>
    </message>
    <message>
        <source>a zone of the turn or the external axes inside the TCP&apos;s</source>
        <translation>una zona della rotazione o degli assi esterni dentro quella del TCP</translation>
    </message>
    <message>
        <source>a {type} has other parts</source>
        <translation>un {type} ha altre parti</translation>
    </message>
    <message>
        <source>adaptive layers</source>
        <translation>strati adattivi</translation>
    </message>
    <message>
        <source>add a row of - under the part, where it is to stand</source>
        <translation>aggiungi una riga di - sotto il pezzo, dove deve poggiare</translation>
    </message>
    <message>
        <source>add supports (supports=auto), cut there, or use curved mode</source>
        <translation>aggiungi supporti (supports=auto), taglia lì, o usa strati curvi</translation>
    </message>
    <message>
        <source>all pieces are held to the plate by {foot:.3g}, of {whole:.3g#} that the part stands on uncut</source>
        <translation>tutte le parti sono tenute alla piastra da {foot:.3g}, dei {whole:.3g#} su cui il pezzo intero poggia</translation>
    </message>
    <message>
        <source>along</source>
        <translation>lungo l&apos;asse</translation>
    </message>
    <message>
        <source>an M command that is not known to the reader</source>
        <translation>un comando M non noto al lettore</translation>
    </message>
    <message>
        <source>an OFF file begins with &quot;OFF&quot;</source>
        <translation>un file OFF comincia con &quot;OFF&quot;</translation>
    </message>
    <message>
        <source>an analogue output outside 0..1</source>
        <translation>un&apos;uscita analogica fuori da 0..1</translation>
    </message>
    <message>
        <source>an argument of {name} is unknown or given twice</source>
        <translation>un argomento di {name} è sconosciuto o dato due volte</translation>
    </message>
    <message>
        <source>an element needs its number</source>
        <translation>un elemento richiede il suo numero</translation>
    </message>
    <message>
        <source>an external axis far outside any limit</source>
        <translation>un asse esterno molto oltre ogni limite</translation>
    </message>
    <message>
        <source>an external axis that moves no work object is not read</source>
        <translation>un asse esterno che non muove alcun oggetto di lavoro non viene letto</translation>
    </message>
    <message>
        <source>an output needs its number and a value</source>
        <translation>un&apos;uscita richiede il suo numero e un valore</translation>
    </message>
    <message>
        <source>an unknown PLY format</source>
        <translation>un formato PLY sconosciuto</translation>
    </message>
    <message>
        <source>an unknown line in the header</source>
        <translation>una riga sconosciuta nell&apos;intestazione</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: the cell prints up to {radius} from the rod&apos;s axis and {along} from its middle</source>
        <translation>e altri punti, il primo a {place}: la cella stampa fino a {radius} dall&apos;asse della barra e {along} dal suo centro</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: the print head would cut into the platform</source>
        <translation>e altri punti, il primo a {place}: la testina entrerebbe nella piattaforma</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: the print head would cut into what is printed already</source>
        <translation>e altri punti, il primo a {place}: la testina entrerebbe in ciò che è già stampato</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: the robot can be here, but cannot come from or go on to a neighbouring place without lifting</source>
        <translation>e altri punti, il primo a {place}: il robot può stare qui, ma non può venire da un punto vicino o proseguire verso di esso senza sollevarsi</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: the robot cannot bring this place under the nozzle: out of reach, or beyond a joint&apos;s limits, however the part is turned about the nozzle</source>
        <translation>e altri punti, il primo a {place}: il robot non può portare questo punto sotto l&apos;ugello: fuori portata, o oltre i limiti di un giunto, comunque si giri il pezzo attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: {first} would meet {second}, however the part is turned about the nozzle</source>
        <translation>e altri punti, il primo a {place}: {first} toccherebbe {second}, comunque si giri il pezzo attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>and more from here on</source>
        <translation>e altro da qui in poi</translation>
    </message>
    <message numerus="yes">
        <source>and {collisions} collisions more</source>
        <translation>
            <numerusform>e {collisions} altra collisione</numerusform>
            <numerusform>e altre {collisions} collisioni</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and {violations} violations more</source>
        <translation>
            <numerusform>e {violations} altra violazione</numerusform>
            <numerusform>e altre {violations} violazioni</numerusform>
        </translation>
    </message>
    <message>
        <source>another column</source>
        <translation>un&apos;altra colonna</translation>
    </message>
    <message>
        <source>argument {key} is no sensible number</source>
        <translation>l&apos;argomento {key} non è un numero sensato</translation>
    </message>
    <message>
        <source>around</source>
        <translation>attorno all&apos;asse</translation>
    </message>
    <message>
        <source>at {point:.1f}</source>
        <translation>a {point:.1f}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>asse</translation>
    </message>
    <message>
        <source>axis of the part</source>
        <translation>asse del pezzo</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>larghezza cordone</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>a fascio</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; of the job file is damaged</source>
        <translation>il blocco &apos;{name}&apos; del progetto è danneggiato</translation>
    </message>
    <message>
        <source>break it off after printing</source>
        <translation>staccala dopo la stampa</translation>
    </message>
    <message>
        <source>broken precondition: {what}</source>
        <translation>condizione violata: {what}</translation>
    </message>
    <message>
        <source>byte {code}</source>
        <translation>byte {code}</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>non si può leggere fino alla fine</translation>
    </message>
    <message>
        <source>cannot be read: {why}</source>
        <translation>non si può leggere: {why}</translation>
    </message>
    <message>
        <source>cannot be written: {why}</source>
        <translation>non si può scrivere: {why}</translation>
    </message>
    <message>
        <source>cell {cell}</source>
        <translation>cella {cell}</translation>
    </message>
    <message>
        <source>cell {cell} holds a rod, and mode {mode} prints on a plate</source>
        <translation>la cella {cell} tiene una barra, e la modalità {mode} stampa su una piastra</translation>
    </message>
    <message>
        <source>cell {id} holds no rod to print on</source>
        <translation>la cella {id} non tiene una barra su cui stampare</translation>
    </message>
    <message>
        <source>centre of layers</source>
        <translation>centro degli strati</translation>
    </message>
    <message>
        <source>check the flow and the infill&apos;s density</source>
        <translation>controlla il flusso e la densità del riempimento</translation>
    </message>
    <message>
        <source>checking layers</source>
        <translation>controllo degli strati</translation>
    </message>
    <message>
        <source>checking the motion</source>
        <translation>controllo del movimento</translation>
    </message>
    <message>
        <source>choose a smaller voxelMm or beadWidthMm</source>
        <translation>scegli un voxelMm o un beadWidthMm più piccolo</translation>
    </message>
    <message>
        <source>choose layers that reach all of it (layerShape, layerCentre, endSurface)</source>
        <translation>scegliere strati che lo raggiungano tutto (layerShape, layerCentre, endSurface)</translation>
    </message>
    <message>
        <source>choose {least} to {most} pixels a side</source>
        <translation>scegli da {least} a {most} pixel per lato</translation>
    </message>
    <message>
        <source>clearance of the arm</source>
        <translation>distanza del braccio</translation>
    </message>
    <message>
        <source>clearance of the part</source>
        <translation>distanza dal pezzo</translation>
    </message>
    <message numerus="yes">
        <source>closed {count} holes, the largest of {edges} edges at {at:.2f}</source>
        <translation>
            <numerusform>chiuso {count} foro, di {edges} spigoli a {at:.2f}</numerusform>
            <numerusform>chiusi {count} fori, il più grande di {edges} spigoli a {at:.2f}</numerusform>
        </translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>collisioni</translation>
    </message>
    <message>
        <source>comparing with the plan</source>
        <translation>confronto con il piano</translation>
    </message>
    <message>
        <source>concentric</source>
        <translation>concentrico</translation>
    </message>
    <message>
        <source>contact area + {sizes} mm</source>
        <translation>area di contatto + {sizes} mm</translation>
    </message>
    <message numerus="yes">
        <source>cut it off after printing: it touches the part at {faces} more faces</source>
        <translation>
            <numerusform>tagliala dopo la stampa: tocca il pezzo su un&apos;altra faccia</numerusform>
            <numerusform>tagliala dopo la stampa: tocca il pezzo su altre {faces} facce</numerusform>
        </translation>
    </message>
    <message>
        <source>cut short</source>
        <translation>troncato</translation>
    </message>
    <message>
        <source>cut short within a facet</source>
        <translation>troncato dentro una faccetta</translation>
    </message>
    <message>
        <source>cut short, or not a mesh: {what}</source>
        <translation>troncato, o non è una mesh: {what}</translation>
    </message>
    <message>
        <source>cut short: {bytes} bytes are no STL file</source>
        <translation>troncato: {bytes} byte non sono un file STL</translation>
    </message>
    <message>
        <source>cut short: {there} of {wanted} faces</source>
        <translation>troncato: {there} di {wanted} facce</translation>
    </message>
    <message>
        <source>cut short: {there} of {wanted} vertices</source>
        <translation>troncato: {there} di {wanted} vertici</translation>
    </message>
    <message>
        <source>cut {number}</source>
        <translation>taglio {number}</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>taglio</translation>
    </message>
    <message>
        <source>cutting layers</source>
        <translation>taglio degli strati</translation>
    </message>
    <message>
        <source>cutting layers from the field</source>
        <translation>taglio degli strati dal campo</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>piani di taglio</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cilindro</translation>
    </message>
    <message>
        <source>damaged STL: {what}</source>
        <translation>STL danneggiato: {what}</translation>
    </message>
    <message>
        <source>data of the type {type} is not known to the reader</source>
        <translation>dati di tipo {type} non sono noti al lettore</translation>
    </message>
    <message>
        <source>did you mean &apos;{name}&apos;?</source>
        <translation>forse &apos;{name}&apos;?</translation>
    </message>
    <message>
        <source>did you mean {name}?</source>
        <translation>forse {name}?</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>direzioni</translation>
    </message>
    <message>
        <source>disc, {sizes} mm</source>
        <translation>disco, {sizes} mm</translation>
    </message>
    <message>
        <source>does not rise from z = 0</source>
        <translation>non sale da z = 0</translation>
    </message>
    <message>
        <source>drop it to the plate</source>
        <translation>appoggialo sulla piastra</translation>
    </message>
    <message>
        <source>drop it to the plate or choose a platform under it</source>
        <translation>appoggialo sulla piastra o scegli una piattaforma sotto di esso</translation>
    </message>
    <message>
        <source>drop the part to the plate</source>
        <translation>appoggia il pezzo sulla piastra</translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} duplicate triangles</source>
        <translation>
            <numerusform>tolto {count} triangolo doppio</numerusform>
            <numerusform>tolti {count} triangoli doppi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles of sheets without volume</source>
        <translation>
            <numerusform>tolto {count} triangolo di lembi senza volume</numerusform>
            <numerusform>tolti {count} triangoli di lembi senza volume</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles without area</source>
        <translation>
            <numerusform>tolto {count} triangolo senza area</numerusform>
            <numerusform>tolti {count} triangoli senza area</numerusform>
        </translation>
    </message>
    <message>
        <source>eax_a is missing: an external axis moves the work object</source>
        <translation>manca eax_a: un asse esterno muove l&apos;oggetto di lavoro</translation>
    </message>
    <message>
        <source>end surface</source>
        <translation>superficie finale</translation>
    </message>
    <message>
        <source>endSurface &apos;{text}&apos; is none</source>
        <translation>endSurface &apos;{text}&apos; non esiste</translation>
    </message>
    <message>
        <source>endSurface mesh:FILE goes with a platform that is a body</source>
        <translation>endSurface mesh:FILE va con una piattaforma che è un corpo</translation>
    </message>
    <message>
        <source>ending layers on the surface</source>
        <translation>strati terminati sulla superficie</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>esporta o copia di nuovo il file</translation>
    </message>
    <message>
        <source>extruded material becomes less</source>
        <translation>il materiale estruso diminuisce</translation>
    </message>
    <message>
        <source>fewest missed</source>
        <translation>meno voxel mancanti</translation>
    </message>
    <message>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <source>file {file}, line {line}</source>
        <translation>file {file}, riga {line}</translation>
    </message>
    <message>
        <source>file {file}, line {line}: {what}</source>
        <translation>file {file}, riga {line}: {what}</translation>
    </message>
    <message>
        <source>fill the hollow first, or use layerShape=offset</source>
        <translation>riempi prima la cavità, o usa layerShape=offset</translation>
    </message>
    <message>
        <source>first layer</source>
        <translation>primo strato</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>piatto</translation>
    </message>
    <message>
        <source>flatten</source>
        <translation>spiana</translation>
    </message>
    <message>
        <source>flattening</source>
        <translation>spianatura</translation>
    </message>
    <message>
        <source>flooding</source>
        <translation>a espansione</translation>
    </message>
    <message>
        <source>front</source>
        <translation>fronte</translation>
    </message>
    <message>
        <source>give --cell lathe</source>
        <translation>usa --cell lathe</translation>
    </message>
    <message>
        <source>give --mode {modes}, or another cell</source>
        <translation>usa --mode {modes}, o un&apos;altra cella</translation>
    </message>
    <message>
        <source>give --platform {platforms}</source>
        <translation>usa --platform {platforms}</translation>
    </message>
    <message>
        <source>give --platform {platforms}, or endSurface flat:Z</source>
        <translation>usa --platform {platforms}, o endSurface flat:Z</translation>
    </message>
    <message>
        <source>give 0, or {least#} to {most}</source>
        <translation>dai 0, o da {least#} a {most}</translation>
    </message>
    <message>
        <source>give a higher end surface (endSurface)</source>
        <translation>dai una superficie finale più alta (endSurface)</translation>
    </message>
    <message>
        <source>give a list of {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} or {&quot;corners&quot;: [four points]}, in mm</source>
        <translation>dai una lista di {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} o {&quot;corners&quot;: [quattro punti]}, in mm</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>dai un numero</translation>
    </message>
    <message>
        <source>give a number from 0.0001 to 10000, or fit</source>
        <translation>dai un numero da 0.0001 a 10000, o fit</translation>
    </message>
    <message>
        <source>give all slices equally many rows</source>
        <translation>dai a tutte le sezioni lo stesso numero di righe</translation>
    </message>
    <message>
        <source>give an STL, OBJ, PLY, OFF or 3MF file</source>
        <translation>dai un file STL, OBJ, PLY, OFF o 3MF</translation>
    </message>
    <message>
        <source>give an end surface over the part&apos;s foot</source>
        <translation>dai una superficie finale sopra il piede del pezzo</translation>
    </message>
    <message>
        <source>give an end surface that is more like the surface, or a narrower part</source>
        <translation>dai una superficie finale più simile alla superficie, o un pezzo più stretto</translation>
    </message>
    <message>
        <source>give an end surface that is more like the surface, or a smaller part</source>
        <translation>dai una superficie finale più simile alla superficie, o un pezzo più piccolo</translation>
    </message>
    <message>
        <source>give endSurface=flat:Z or mesh:FILE</source>
        <translation>usa endSurface=flat:Z o mesh:FILE</translation>
    </message>
    <message>
        <source>give orient=none</source>
        <translation>usa orient=none</translation>
    </message>
    <message>
        <source>give other cuts (cutPlanes), turn the part, or use curved mode</source>
        <translation>indica altri tagli (cutPlanes), gira il pezzo, o usa strati curvi</translation>
    </message>
    <message>
        <source>give pairs of x and radius in mm, x ascending</source>
        <translation>dai coppie di x e raggio in mm, x crescente</translation>
    </message>
    <message>
        <source>give planes: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</source>
        <translation>dai piani: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</translation>
    </message>
    <message>
        <source>give the job that the program was written from</source>
        <translation>dai il progetto da cui il programma è stato scritto</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>dai true o false</translation>
    </message>
    <message>
        <source>give {field} from {least#} to {most}</source>
        <translation>dai {field} da {least#} a {most}</translation>
    </message>
    <message>
        <source>give {forms}</source>
        <translation>usa {forms}</translation>
    </message>
    <message>
        <source>give {key}=NUMBER, 0 or more</source>
        <translation>dai {key}=NUMERO, 0 o più</translation>
    </message>
    <message>
        <source>give {least#} to {most}</source>
        <translation>dai da {least#} a {most}</translation>
    </message>
    <message>
        <source>give {least} to {most}</source>
        <translation>dai da {least} a {most}</translation>
    </message>
    <message>
        <source>give {least} to {most} {unit}</source>
        <translation>dai da {least} a {most} {unit}</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>greedy</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>crescita</translation>
    </message>
    <message>
        <source>has minDeg not below maxDeg</source>
        <translation>ha minDeg non inferiore a maxDeg</translation>
    </message>
    <message>
        <source>has no length</source>
        <translation>non ha lunghezza</translation>
    </message>
    <message>
        <source>head</source>
        <translation>testina</translation>
    </message>
    <message>
        <source>helical</source>
        <translation>elicoidale</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>portaugello</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pollici</translation>
    </message>
    <message>
        <source>inches are not understood</source>
        <translation>i pollici non sono compresi</translation>
    </message>
    <message>
        <source>infill</source>
        <translation>riempimento</translation>
    </message>
    <message>
        <source>infill &apos;{infill}&apos; winds around an axis, and layer {layer} has none</source>
        <translation>il riempimento &apos;{infill}&apos; si avvolge attorno a un asse, e lo strato {layer} non ne ha</translation>
    </message>
    <message>
        <source>infill density</source>
        <translation>densità riempimento</translation>
    </message>
    <message>
        <source>infill direction</source>
        <translation>direzione del riempimento</translation>
    </message>
    <message>
        <source>insertion</source>
        <translation>di inserimento</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>install Mesa (libegl1, libgl1-mesa-dri)</source>
        <translation>installa Mesa (libegl1, libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>is &apos;{id}&apos;, but the file is named &apos;{file}&apos;</source>
        <translation>è &apos;{id}&apos;, ma il file si chiama &apos;{file}&apos;</translation>
    </message>
    <message>
        <source>is a directory, not a file</source>
        <translation>è una cartella, non un file</translation>
    </message>
    <message>
        <source>is above &apos;max&apos;</source>
        <translation>è superiore a &apos;max&apos;</translation>
    </message>
    <message>
        <source>is below &apos;min&apos;</source>
        <translation>è inferiore a &apos;min&apos;</translation>
    </message>
    <message>
        <source>is cut short</source>
        <translation>è troncato</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>è danneggiato</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>è cifrato</translation>
    </message>
    <message>
        <source>is larger than 1 GB</source>
        <translation>è più grande di 1 GB</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manca</translation>
    </message>
    <message>
        <source>is outside the joint&apos;s limits</source>
        <translation>è oltre i limiti del giunto</translation>
    </message>
    <message>
        <source>is packed in a way that cannot be read</source>
        <translation>è compresso in un modo che non si può leggere</translation>
    </message>
    <message>
        <source>is taken already: &apos;{name}&apos;</source>
        <translation>è già usato: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>it is a file, not a folder</source>
        <translation>è un file, non una cartella</translation>
    </message>
    <message>
        <source>its blend overlaps the one before ({blend:.3f} on {way:.3f}): the controller skips the waypoint</source>
        <translation>il suo raccordo si sovrappone al precedente ({blend:.3f} su {way:.3f}): il controllore salta il punto</translation>
    </message>
    <message>
        <source>joint {number}</source>
        <translation>giunto {number}</translation>
    </message>
    <message>
        <source>lay the part on a larger face, or give other cuts (cutPlanes)</source>
        <translation>appoggia il pezzo su una faccia più grande, o indica altri tagli (cutPlanes)</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>strato</translation>
    </message>
    <message>
        <source>layer height</source>
        <translation>altezza strato</translation>
    </message>
    <message>
        <source>layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</source>
        <translation>strato {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</translation>
    </message>
    <message>
        <source>layerCentre &apos;{text}&apos; is no point</source>
        <translation>layerCentre &apos;{text}&apos; non è un punto</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>strati</translation>
    </message>
    <message>
        <source>layers are 1 to {count}</source>
        <translation>gli strati vanno da 1 a {count}</translation>
    </message>
    <message>
        <source>layers around the rod</source>
        <translation>strati intorno alla barra</translation>
    </message>
    <message>
        <source>layers on this surface would fold: rays along its normals cross before the end surface, from layer {layer} on</source>
        <translation>gli strati su questa superficie si piegherebbero: i raggi lungo le sue normali si incrociano prima della superficie finale, dallo strato {layer} in poi</translation>
    </message>
    <message>
        <source>layers that are {top:.3g} mm thick at the top and {side:.3g} mm at the sides end after layer {layer}: no circle goes through both</source>
        <translation>strati spessi {top:.3g} mm in cima e {side:.3g} mm ai lati finiscono dopo lo strato {layer}: nessun cerchio passa per entrambi</translation>
    </message>
    <message>
        <source>laying beads</source>
        <translation>disposizione dei cordoni</translation>
    </message>
    <message>
        <source>least</source>
        <translation>il meno possibile</translation>
    </message>
    <message>
        <source>least risky</source>
        <translation>meno area a rischio</translation>
    </message>
    <message>
        <source>leaves a piece that stands on nothing</source>
        <translation>lascia una parte che non poggia su nulla</translation>
    </message>
    <message>
        <source>leaves a piece {thickness:.2g} thin, less than a bead&apos;s {least}</source>
        <translation>lascia una parte spessa {thickness:.2g}, meno dei {least} di un cordone</translation>
    </message>
    <message>
        <source>left out: {what}</source>
        <translation>tralasciato: {what}</translation>
    </message>
    <message>
        <source>left to the controller</source>
        <translation>lasciate al controllore</translation>
    </message>
    <message>
        <source>lengths taken as mm: the unit &apos;{unit}&apos; is not known</source>
        <translation>lunghezze prese come mm: l&apos;unità &apos;{unit}&apos; non è nota</translation>
    </message>
    <message>
        <source>lengths turned from {unit} into mm</source>
        <translation>lunghezze convertite da {unit} in mm</translation>
    </message>
    <message>
        <source>less flow, or beads further apart</source>
        <translation>meno flusso, o cordoni più distanti</translation>
    </message>
    <message>
        <source>let the part rise from the rod at a gentler slope there</source>
        <translation>lì far salire il pezzo dalla barra con minore pendenza</translation>
    </message>
    <message>
        <source>let the part rise from the surface at a gentler slope there</source>
        <translation>lì far salire il pezzo dalla superficie con minore pendenza</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>sollevamento</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>riga {line}</translation>
    </message>
    <message>
        <source>line {line}: {what}</source>
        <translation>riga {line}: {what}</translation>
    </message>
    <message>
        <source>load</source>
        <translation>caricamento</translation>
    </message>
    <message>
        <source>longest side {longest:.4g}: perhaps the file is in {unit} (scale {scale})</source>
        <translation>lato più lungo {longest:.4g}: forse il file è in {unit} (scala {scale})</translation>
    </message>
    <message>
        <source>looking beneath the beads</source>
        <translation>controllo sotto i cordoni</translation>
    </message>
    <message>
        <source>looking for collisions</source>
        <translation>ricerca di collisioni</translation>
    </message>
    <message>
        <source>made by a newer version of Voluta (format {format}; this one reads up to {newest})</source>
        <translation>fatto da una versione più nuova di Voluta (formato {format}; questa legge fino a {newest})</translation>
    </message>
    <message>
        <source>make all rows equally long</source>
        <translation>fai tutte le righe della stessa lunghezza</translation>
    </message>
    <message>
        <source>make the feature narrower</source>
        <translation>fai il rilievo più stretto</translation>
    </message>
    <message>
        <source>make the object of fewer and larger cells</source>
        <translation>fai l&apos;oggetto di celle meno numerose e più grandi</translation>
    </message>
    <message>
        <source>make the part narrower, or use layerShape=offset</source>
        <translation>fai il pezzo più stretto, o usa layerShape=offset</translation>
    </message>
    <message>
        <source>make the two thicknesses more alike, or use fewer layers</source>
        <translation>fai i due spessori più simili, o usa meno strati</translation>
    </message>
    <message>
        <source>materials of pieces</source>
        <translation>materiali dei pezzi</translation>
    </message>
    <message>
        <source>measuring the beads</source>
        <translation>misura dei cordoni</translation>
    </message>
    <message>
        <source>mend it in a modelling program</source>
        <translation>correggila in un programma di modellazione</translation>
    </message>
    <message>
        <source>mend the mesh in a modelling program if the result looks wrong</source>
        <translation>correggi la mesh in un programma di modellazione se il risultato sembra sbagliato</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} duplicate points</source>
        <translation>
            <numerusform>unito {count} punto doppio</numerusform>
            <numerusform>uniti {count} punti doppi</numerusform>
        </translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metri</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micrometri</translation>
    </message>
    <message>
        <source>missed voxels</source>
        <translation>voxel mancanti</translation>
    </message>
    <message>
        <source>mode {mode} does not print on platform {platform}</source>
        <translation>la modalità {mode} non stampa sulla piattaforma {platform}</translation>
    </message>
    <message>
        <source>mode {mode} prints around a rod, and cell {cell} holds none</source>
        <translation>la modalità {mode} stampa attorno a una barra, e la cella {cell} non ne tiene</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>movimento</translation>
    </message>
    <message>
        <source>move it to where it crosses the part</source>
        <translation>spostalo dove attraversa il pezzo</translation>
    </message>
    <message>
        <source>move or tilt the plane a little</source>
        <translation>sposta o inclina un poco il piano</translation>
    </message>
    <message>
        <source>move the part along the rod, or use a longer rod</source>
        <translation>sposta il pezzo lungo la barra, o usa una barra più lunga</translation>
    </message>
    <message>
        <source>move the part on the rod, or let what is under them grow out of it</source>
        <translation>sposta il pezzo sulla barra, o fa&apos; che ciò che sta sotto cresca da essa</translation>
    </message>
    <message>
        <source>move the part on the surface, or let what is under them grow out of it</source>
        <translation>sposta il pezzo sulla superficie, o fa&apos; che ciò che sta sotto cresca da essa</translation>
    </message>
    <message>
        <source>move the part onto the rod</source>
        <translation>sposta il pezzo sulla barra</translation>
    </message>
    <message>
        <source>move the part onto the surface</source>
        <translation>sposta il pezzo sulla superficie</translation>
    </message>
    <message>
        <source>move the part out of the surface, or print it larger</source>
        <translation>sposta il pezzo fuori dalla superficie, o stampalo più grande</translation>
    </message>
    <message>
        <source>move the plane, or leave it out</source>
        <translation>sposta il piano, o omettilo</translation>
    </message>
    <message>
        <source>move the plane, or turn its normal to the side that is to be cut off</source>
        <translation>sposta il piano, o gira la sua normale verso il lato da tagliare</translation>
    </message>
    <message>
        <source>move the planes, or add some between</source>
        <translation>sposta i piani, o aggiungine in mezzo</translation>
    </message>
    <message>
        <source>move them, or leave them out</source>
        <translation>spostali, o toglili</translation>
    </message>
    <message>
        <source>must be a capsule, a box or a frustum</source>
        <translation>deve essere una capsula, un parallelepipedo o un tronco di cono</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>deve essere un numero finito</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>deve essere una lista</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>deve essere un numero</translation>
    </message>
    <message>
        <source>must be a pair of height and radius</source>
        <translation>deve essere una coppia di altezza e raggio</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>deve essere un testo</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>deve essere un numero intero</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>deve essere un oggetto</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>deve essere maggiore di 0</translation>
    </message>
    <message>
        <source>must be in 0..{dof}</source>
        <translation>deve essere in 0..{dof}</translation>
    </message>
    <message>
        <source>must be more than the rod&apos;s radius</source>
        <translation>deve essere più del raggio della barra</translation>
    </message>
    <message>
        <source>must be unwinds or runsOn, is &apos;{end}&apos;</source>
        <translation>deve essere unwinds o runsOn, è &apos;{end}&apos;</translation>
    </message>
    <message>
        <source>must be world or flange, is &apos;{mount}&apos;</source>
        <translation>deve essere world o flange, è &apos;{mount}&apos;</translation>
    </message>
    <message>
        <source>must be world: a rod is held at both ends</source>
        <translation>deve essere world: una barra è tenuta a entrambe le estremità</translation>
    </message>
    <message>
        <source>must have 0, where it rests, within its limits</source>
        <translation>deve avere 0, dove sta a riposo, dentro i suoi limiti</translation>
    </message>
    <message>
        <source>must have three numbers</source>
        <translation>deve avere tre numeri</translation>
    </message>
    <message>
        <source>must have two names</source>
        <translation>deve avere due nomi</translation>
    </message>
    <message>
        <source>must have two sections at least</source>
        <translation>deve avere almeno due sezioni</translation>
    </message>
    <message>
        <source>must hold 6 joints, holds {found}</source>
        <translation>deve contenere 6 giunti, ne contiene {found}</translation>
    </message>
    <message>
        <source>must hold at least one shape</source>
        <translation>deve contenere almeno una forma</translation>
    </message>
    <message>
        <source>must hold one axis, which turns the rod</source>
        <translation>deve contenere un asse, che gira la barra</translation>
    </message>
    <message>
        <source>must hold {wanted} joints, holds {found}</source>
        <translation>deve contenere {wanted} giunti, ne contiene {found}</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>non deve essere 0</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>non deve essere negativo</translation>
    </message>
    <message>
        <source>must not be the nozzle&apos;s: one of them moves, the other is fixed</source>
        <translation>non deve essere quello dell&apos;ugello: uno dei due si muove, l&apos;altro è fisso</translation>
    </message>
    <message>
        <source>name its axis (rodAxis), or turn the part onto the rod by hand</source>
        <translation>indica il suo asse (rodAxis), o gira il pezzo sulla barra a mano</translation>
    </message>
    <message>
        <source>names no body: &apos;{name}&apos;; the nearest is &apos;{nearest}&apos;</source>
        <translation>non indica alcun corpo: &apos;{name}&apos;; il più vicino è &apos;{nearest}&apos;</translation>
    </message>
    <message>
        <source>names no kinematic family that is known: &apos;{id}&apos;</source>
        <translation>non indica alcuna famiglia cinematica nota: &apos;{id}&apos;</translation>
    </message>
    <message>
        <source>names no model</source>
        <translation>non indica alcun modello</translation>
    </message>
    <message>
        <source>needs radii that are not negative, one of them greater than 0</source>
        <translation>richiede raggi non negativi, uno dei quali maggiore di 0</translation>
    </message>
    <message>
        <source>neither a plane nor a quadrilateral</source>
        <translation>né un piano né un quadrilatero</translation>
    </message>
    <message numerus="yes">
        <source>no column from inside the platform reaches {voxels} voxels that would be missed</source>
        <translation>
            <numerusform>nessuna colonna dall&apos;interno della piattaforma raggiunge {voxels} voxel che mancherebbe</numerusform>
            <numerusform>nessuna colonna dall&apos;interno della piattaforma raggiunge {voxels} voxel che mancherebbero</numerusform>
        </translation>
    </message>
    <message>
        <source>no figure is called &apos;{key}&apos;</source>
        <translation>nessuna misura si chiama &apos;{key}&apos;</translation>
    </message>
    <message>
        <source>no function is defined</source>
        <translation>nessuna funzione è definita</translation>
    </message>
    <message>
        <source>no number of layers between the surface and its end keeps their thickness within {least} and {most} mm: the way between them is {shortest:.3g} to {longest:.3g} mm long</source>
        <translation>nessun numero di strati tra la superficie e la sua fine tiene il loro spessore tra {least} e {most} mm: la distanza è lunga da {shortest:.3g} a {longest:.3g} mm</translation>
    </message>
    <message>
        <source>no number of layers between the surface and its end keeps their thickness within {least} and {most} mm: {layers} layers would be {thinnest:.3g} to {thickest:.3g} mm thick</source>
        <translation>nessun numero di strati tra la superficie e la sua fine tiene il loro spessore tra {least} e {most} mm: {layers} strati sarebbero spessi da {thinnest:.3g} a {thickest:.3g} mm</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>il file non esiste</translation>
    </message>
    <message>
        <source>no tool-path is left to move along</source>
        <translation>non resta alcun percorso da seguire</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominale</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>not JSON: {why}</source>
        <translation>non è JSON: {why}</translation>
    </message>
    <message>
        <source>not a Voluta job</source>
        <translation>non è un progetto di Voluta</translation>
    </message>
    <message>
        <source>not a filament&apos;s diameter</source>
        <translation>non è il diametro di un filamento</translation>
    </message>
    <message>
        <source>not a mesh file</source>
        <translation>non è un file di mesh</translation>
    </message>
    <message>
        <source>not a module&apos;s attributes</source>
        <translation>non sono attributi di un modulo</translation>
    </message>
    <message>
        <source>not a program in any known format</source>
        <translation>non è un programma in un formato noto</translation>
    </message>
    <message>
        <source>not a row of the table</source>
        <translation>non è una riga della tabella</translation>
    </message>
    <message>
        <source>not a zip, or cut short</source>
        <translation>non è uno zip, o è troncato</translation>
    </message>
    <message>
        <source>not the head of a procedure</source>
        <translation>non è l&apos;intestazione di una procedura</translation>
    </message>
    <message>
        <source>not the header of a joint table</source>
        <translation>non è l&apos;intestazione di una tabella di giunti</translation>
    </message>
    <message>
        <source>not understood: &apos;{code}&apos;</source>
        <translation>non compreso: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing is left of the mesh after repair</source>
        <translation>non resta nulla della mesh dopo la riparazione</translation>
    </message>
    <message>
        <source>nothing of the surface under the part sees the end surface</source>
        <translation>nulla della superficie sotto il pezzo vede la superficie finale</translation>
    </message>
    <message>
        <source>nothing stands on the platform</source>
        <translation>nulla poggia sulla piattaforma</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>ugello</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is not there</source>
        <translation>l&apos;oggetto &apos;{id}&apos; non esiste</translation>
    </message>
    <message>
        <source>objects hold one another without end, or more than can be read</source>
        <translation>oggetti che si contengono senza fine, o più di quanti se ne possano leggere</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>distanza</translation>
    </message>
    <message>
        <source>on the plate</source>
        <translation>sul piatto</translation>
    </message>
    <message>
        <source>one that ends by itself or is skipped</source>
        <translation>uno che finisce da solo o viene saltato</translation>
    </message>
    <message>
        <source>one that the operator ends</source>
        <translation>uno che finisce l&apos;operatore</translation>
    </message>
    <message>
        <source>only three-dimensional OFF files can be read</source>
        <translation>si possono leggere solo file OFF tridimensionali</translation>
    </message>
    <message>
        <source>open</source>
        <translation>apertura</translation>
    </message>
    <message>
        <source>open it with the version that made it, or install that one</source>
        <translation>aprilo con la versione che l&apos;ha fatto, o installa quella</translation>
    </message>
    <message>
        <source>ordering layers</source>
        <translation>ordinamento degli strati</translation>
    </message>
    <message>
        <source>orient=none leaves it as it was put</source>
        <translation>orient=none lo lascia come è stato messo</translation>
    </message>
    <message>
        <source>orient={orient} turns parts on a plate; mode {mode} lays them itself</source>
        <translation>orient={orient} gira pezzi su una piastra; la modalità {mode} li dispone da sé</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>orientamento</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>memoria esaurita</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>fuori portata</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuori</translation>
    </message>
    <message>
        <source>overhang angle</source>
        <translation>angolo di sbalzo</translation>
    </message>
    <message>
        <source>pair {number}</source>
        <translation>coppia {number}</translation>
    </message>
    <message>
        <source>pairs a body with itself</source>
        <translation>accoppia un corpo con se stesso</translation>
    </message>
    <message>
        <source>peeling</source>
        <translation>spellatura</translation>
    </message>
    <message>
        <source>pick a place on what stands on the plate, or lay the part on the face to begin with</source>
        <translation>scegli un punto su ciò che poggia sulla piastra, o appoggia il pezzo sulla faccia da cui cominciare</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>pezzi</translation>
    </message>
    <message>
        <source>pieces of layers are narrower than half a bead and stay empty</source>
        <translation>alcuni tratti di strato sono più stretti di mezzo cordone e restano vuoti</translation>
    </message>
    <message>
        <source>placed part</source>
        <translation>pezzo posizionato</translation>
    </message>
    <message>
        <source>plan anew with more clearance</source>
        <translation>pianifica di nuovo con più distanza</translation>
    </message>
    <message>
        <source>plan anew with more clearance, or another place for the part</source>
        <translation>pianifica di nuovo con più distanza, o con un altro posto per il pezzo</translation>
    </message>
    <message>
        <source>plan it without --until</source>
        <translation>pianificalo senza --until</translation>
    </message>
    <message>
        <source>plan the part again</source>
        <translation>pianifica di nuovo il pezzo</translation>
    </message>
    <message>
        <source>plan the part further: voluta-cli plan PART -o DIR</source>
        <translation>pianifica oltre il pezzo: voluta-cli plan PEZZO -o CARTELLA</translation>
    </message>
    <message>
        <source>planes of layers</source>
        <translation>piani degli strati</translation>
    </message>
    <message>
        <source>planes of layers miss the part: {planes}</source>
        <translation>piani di strati non toccano il pezzo: {planes}</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>piattaforma</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; has no usable size</source>
        <translation>la piattaforma &apos;{platform}&apos; non ha una misura utilizzabile</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; is no plate</source>
        <translation>la piattaforma &apos;{platform}&apos; non è una piastra</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; names no file</source>
        <translation>la piattaforma &apos;{platform}&apos; non indica alcun file</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos;: {field} {size} is out of range</source>
        <translation>piattaforma &apos;{platform}&apos;: {field} {size} è fuori dall&apos;intervallo</translation>
    </message>
    <message>
        <source>point {i} is the third one at x = {x:.6g} mm</source>
        <translation>il punto {i} è il terzo a x = {x:.6g} mm</translation>
    </message>
    <message>
        <source>print the part larger, or with a finer process</source>
        <translation>stampa il pezzo più grande, o con un processo più fine</translation>
    </message>
    <message>
        <source>print the part smaller (scale)</source>
        <translation>stampare il pezzo più piccolo (scale)</translation>
    </message>
    <message>
        <source>printed part</source>
        <translation>pezzo stampato</translation>
    </message>
    <message>
        <source>profile of the rod</source>
        <translation>profilo della barra</translation>
    </message>
    <message>
        <source>put - only under the part or beside its lowest row</source>
        <translation>metti - solo sotto il pezzo o accanto alla sua riga più bassa</translation>
    </message>
    <message>
        <source>put - right under the part</source>
        <translation>metti - subito sotto il pezzo</translation>
    </message>
    <message>
        <source>put it another way by hand</source>
        <translation>mettilo in un altro modo a mano</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>raggio</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>raggiungibile</translation>
    </message>
    <message>
        <source>relative positions are not understood</source>
        <translation>le posizioni relative non sono comprese</translation>
    </message>
    <message>
        <source>repair</source>
        <translation>riparazione</translation>
    </message>
    <message>
        <source>repair it, or use curved mode, which takes any mesh</source>
        <translation>riparala, o usa la modalità curva, che accetta ogni mesh</translation>
    </message>
    <message>
        <source>repair the part first</source>
        <translation>ripara prima il pezzo</translation>
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
        <source>replay {format}</source>
        <translation>riesecuzione {format}</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>verificato</translation>
    </message>
    <message>
        <source>risky area</source>
        <translation>area a rischio</translation>
    </message>
    <message>
        <source>robot motion</source>
        <translation>movimento del robot</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>barra</translation>
    </message>
    <message>
        <source>rod profile</source>
        <translation>profilo della barra</translation>
    </message>
    <message>
        <source>rod, {sizes} mm</source>
        <translation>barra, {sizes} mm</translation>
    </message>
    <message>
        <source>rodProfile: &apos;{text}&apos; is neither a pair x,radius nor a file</source>
        <translation>rodProfile: &apos;{text}&apos; non è né una coppia x,raggio né un file</translation>
    </message>
    <message>
        <source>root</source>
        <translation>radice</translation>
    </message>
    <message>
        <source>rows of patches</source>
        <translation>righe di superfici</translation>
    </message>
    <message>
        <source>rows of pieces</source>
        <translation>righe di parti</translation>
    </message>
    <message>
        <source>running the program</source>
        <translation>esecuzione del programma</translation>
    </message>
    <message>
        <source>scale &apos;{scale}&apos; is not a usable factor</source>
        <translation>la scala &apos;{scale}&apos; non è un fattore utilizzabile</translation>
    </message>
    <message>
        <source>scale fit would scale the platform&apos;s mesh with the part</source>
        <translation>la scala fit scalerebbe la mesh della piattaforma con il pezzo</translation>
    </message>
    <message>
        <source>scale the part down</source>
        <translation>riduci la scala del pezzo</translation>
    </message>
    <message>
        <source>scale the part down (--scale fit), turn it, or use a larger robot</source>
        <translation>riduci la scala del pezzo (--scale fit), giralo, o usa un robot più grande</translation>
    </message>
    <message>
        <source>scale the part down, or move it along the rod</source>
        <translation>riduci la scala del pezzo, o spostalo lungo la barra</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>schema</translation>
    </message>
    <message>
        <source>see the findings before this one</source>
        <translation>vedi le segnalazioni prima di questa</translation>
    </message>
    <message>
        <source>see: list formats</source>
        <translation>vedi: list formats</translation>
    </message>
    <message numerus="yes">
        <source>separated non-manifold edges at {count} points</source>
        <translation>
            <numerusform>separati spigoli non manifold in {count} punto</numerusform>
            <numerusform>separati spigoli non manifold in {count} punti</numerusform>
        </translation>
    </message>
    <message>
        <source>set {variable}</source>
        <translation>imposta {variable}</translation>
    </message>
    <message>
        <source>set_tcp needs one pose</source>
        <translation>set_tcp richiede una posa</translation>
    </message>
    <message>
        <source>shape of layers</source>
        <translation>forma degli strati</translation>
    </message>
    <message>
        <source>shorter motions or smaller blends</source>
        <translation>movimenti più corti o raccordi più piccoli</translation>
    </message>
    <message>
        <source>sides of the rod</source>
        <translation>lati della barra</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>scheletro</translation>
    </message>
    <message>
        <source>sleep needs its seconds</source>
        <translation>sleep richiede i suoi secondi</translation>
    </message>
    <message>
        <source>slice {slice} ends after {rows} rows, the first one has {first}</source>
        <translation>la sezione {slice} finisce dopo {rows} righe, la prima ne ha {first}</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>taglio in strati</translation>
    </message>
    <message>
        <source>slower there, or another place in the cell</source>
        <translation>più lento lì, o un altro posto nella cella</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sfera</translation>
    </message>
    <message numerus="yes">
        <source>split edges at {count} T-junctions</source>
        <translation>
            <numerusform>divisi spigoli in {count} giunzione a T</numerusform>
            <numerusform>divisi spigoli in {count} giunzioni a T</numerusform>
        </translation>
    </message>
    <message>
        <source>stated</source>
        <translation>dichiarate</translation>
    </message>
    <message>
        <source>step</source>
        <translation>passo</translation>
    </message>
    <message>
        <source>step height</source>
        <translation>altezza del gradino</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>supporti</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>superficie</translation>
    </message>
    <message>
        <source>take a cell with a rod: --cell lathe</source>
        <translation>usa una cella con una barra: --cell lathe</translation>
    </message>
    <message>
        <source>take a shorter rod</source>
        <translation>usa una barra più corta</translation>
    </message>
    <message>
        <source>take a thinner rod</source>
        <translation>usa una barra più sottile</translation>
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
        <source>take {formats}</source>
        <translation>usa {formats}</translation>
    </message>
    <message>
        <source>taken from a project of format 1, as it was repaired and placed there</source>
        <translation>preso da un progetto di formato 1, come vi era riparato e posizionato</translation>
    </message>
    <message>
        <source>text behind ENDMODULE</source>
        <translation>testo dopo ENDMODULE</translation>
    </message>
    <message>
        <source>text behind the end</source>
        <translation>testo dopo la fine</translation>
    </message>
    <message>
        <source>the arm cannot reach this target</source>
        <translation>il braccio non può raggiungere questa posizione</translation>
    </message>
    <message>
        <source>the arm stands otherwise than planned, a joint by {angle:.1f}</source>
        <translation>il braccio sta in modo diverso dal piano, un giunto di {angle:.1f}</translation>
    </message>
    <message>
        <source>the arm would have to change its configuration, {joint} by {angle:.1f} at once</source>
        <translation>il braccio dovrebbe cambiare configurazione, {joint} di {angle:.1f} in una volta</translation>
    </message>
    <message>
        <source>the arm&apos;s configuration is supervised: ConfL\Off, ConfJ\Off</source>
        <translation>la configurazione del braccio è sorvegliata: ConfL\Off, ConfJ\Off</translation>
    </message>
    <message>
        <source>the end sequence (M104 S0, M84, &apos;; end&apos;) is missing: the file was cut short</source>
        <translation>manca la sequenza finale (M104 S0, M84, &apos;; end&apos;): il file è stato troncato</translation>
    </message>
    <message>
        <source>the end sequence is missing</source>
        <translation>manca la sequenza finale</translation>
    </message>
    <message>
        <source>the end surface is {rise:.3g} mm over the top of the surface that layers start from</source>
        <translation>la superficie finale è {rise:.3g} mm sopra la cima della superficie da cui partono gli strati</translation>
    </message>
    <message>
        <source>the external axis stands {angle:.3f} off its plan</source>
        <translation>l&apos;asse esterno è a {angle:.3f} dal suo piano</translation>
    </message>
    <message>
        <source>the extruder is not set off behind the last motion</source>
        <translation>l&apos;estrusore non viene spento dopo l&apos;ultimo movimento</translation>
    </message>
    <message>
        <source>the extruder is off where a bead is to be laid</source>
        <translation>l&apos;estrusore è spento dove va deposto un cordone</translation>
    </message>
    <message>
        <source>the extruder is on over a travel</source>
        <translation>l&apos;estrusore è acceso durante uno spostamento</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not set before this motion</source>
        <translation>le uscite dell&apos;estrusore non sono impostate prima di questo movimento</translation>
    </message>
    <message>
        <source>the feature is {width:.3g} mm wide, wider than the cylinder of {cylinder:.3g} mm that it stands on</source>
        <translation>il rilievo è largo {width:.3g} mm, più del cilindro di {cylinder:.3g} mm su cui poggia</translation>
    </message>
    <message>
        <source>the file ends without &quot;endsolid&quot;: it may be cut short</source>
        <translation>il file finisce senza &quot;endsolid&quot;: forse è troncato</translation>
    </message>
    <message>
        <source>the file holds no cells</source>
        <translation>il file non contiene celle</translation>
    </message>
    <message>
        <source>the file is cut short: {what}</source>
        <translation>il file è troncato: {what}</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>il file è vuoto</translation>
    </message>
    <message>
        <source>the file&apos;s top {what}</source>
        <translation>il livello superiore del file {what}</translation>
    </message>
    <message>
        <source>the first module has no procedure main</source>
        <translation>il primo modulo non ha la procedura main</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; has no end</source>
        <translation>la funzione &apos;{defined}&apos; non ha fine</translation>
    </message>
    <message>
        <source>the function is never called</source>
        <translation>la funzione non viene mai chiamata</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>l&apos;intestazione non ha fine</translation>
    </message>
    <message>
        <source>the header line is missing</source>
        <translation>manca la riga d&apos;intestazione</translation>
    </message>
    <message>
        <source>the header names no format</source>
        <translation>l&apos;intestazione non indica il formato</translation>
    </message>
    <message>
        <source>the header promises no facet, read {facets}</source>
        <translation>l&apos;intestazione non promette faccette, lette {facets}</translation>
    </message>
    <message>
        <source>the job file contradicts itself</source>
        <translation>il progetto si contraddice</translation>
    </message>
    <message>
        <source>the job file contradicts itself: {what}</source>
        <translation>il progetto si contraddice: {what}</translation>
    </message>
    <message>
        <source>the job file is cut short</source>
        <translation>il progetto è troncato</translation>
    </message>
    <message>
        <source>the job file is damaged or cut short in its first line</source>
        <translation>il progetto è danneggiato o troncato nella prima riga</translation>
    </message>
    <message>
        <source>the job file lacks &apos;{name}&apos;</source>
        <translation>al progetto manca &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged</source>
        <translation>l&apos;intestazione del progetto è danneggiata</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged: {why}</source>
        <translation>l&apos;intestazione del progetto è danneggiata: {why}</translation>
    </message>
    <message>
        <source>the job holds no motion to verify against</source>
        <translation>il progetto non contiene un movimento con cui verificare</translation>
    </message>
    <message>
        <source>the job holds no {result}</source>
        <translation>il progetto non contiene {result}</translation>
    </message>
    <message>
        <source>the letter {letter} has no number</source>
        <translation>la lettera {letter} è senza numero</translation>
    </message>
    <message>
        <source>the line &apos;# end&apos; is missing: the file was cut short</source>
        <translation>manca la riga &apos;# end&apos;: il file è stato troncato</translation>
    </message>
    <message>
        <source>the list of modules has no end</source>
        <translation>la lista dei moduli non ha fine</translation>
    </message>
    <message>
        <source>the material laid is {share:.2f} of the part</source>
        <translation>il materiale deposto è il {share:.2f} del pezzo</translation>
    </message>
    <message>
        <source>the mechanical unit &apos;{text}&apos; is not active: ActUnit</source>
        <translation>l&apos;unità meccanica &apos;{text}&apos; non è attiva: ActUnit</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>la mesh non ha triangoli</translation>
    </message>
    <message>
        <source>the mesh is empty: no facet has usable coordinates</source>
        <translation>la mesh è vuota: nessuna faccetta ha coordinate utilizzabili</translation>
    </message>
    <message>
        <source>the mesh is empty: the file holds no triangle</source>
        <translation>la mesh è vuota: il file non contiene triangoli</translation>
    </message>
    <message>
        <source>the mesh is not closed</source>
        <translation>la mesh non è chiusa</translation>
    </message>
    <message>
        <source>the module has no procedure</source>
        <translation>il modulo non ha procedure</translation>
    </message>
    <message>
        <source>the module with {procedure} is not here</source>
        <translation>il modulo con {procedure} non è qui</translation>
    </message>
    <message>
        <source>the module {name} is not here</source>
        <translation>il modulo {name} non è qui</translation>
    </message>
    <message>
        <source>the normal has no direction</source>
        <translation>la normale non ha direzione</translation>
    </message>
    <message>
        <source>the nozzle goes {distance:.3f} beside its plan</source>
        <translation>l&apos;ugello passa a {distance:.3f} dal suo piano</translation>
    </message>
    <message>
        <source>the nozzle&apos;s axis is {angle:.2f} off its plan</source>
        <translation>l&apos;asse dell&apos;ugello è a {angle:.2f} dal suo piano</translation>
    </message>
    <message>
        <source>the nozzle&apos;s path is {distance:.3f} off the planned one</source>
        <translation>il percorso dell&apos;ugello è a {distance:.3f} da quello pianificato</translation>
    </message>
    <message>
        <source>the numbers of vertices and faces are expected here</source>
        <translation>qui sono attesi i numeri di vertici e facce</translation>
    </message>
    <message>
        <source>the object has no part: no 1 above the platform</source>
        <translation>l&apos;oggetto non ha pezzo: nessun 1 sopra la piattaforma</translation>
    </message>
    <message>
        <source>the object is too large</source>
        <translation>l&apos;oggetto è troppo grande</translation>
    </message>
    <message>
        <source>the part below</source>
        <translation>il pezzo sottostante</translation>
    </message>
    <message>
        <source>the part does not touch the plate</source>
        <translation>il pezzo non tocca la piastra</translation>
    </message>
    <message>
        <source>the part does not touch the platform</source>
        <translation>il pezzo non tocca la piattaforma</translation>
    </message>
    <message>
        <source>the part has no clear axis: its sides face along every direction alike</source>
        <translation>il pezzo non ha un asse chiaro: i suoi lati guardano in ogni direzione allo stesso modo</translation>
    </message>
    <message>
        <source>the part has no surface</source>
        <translation>il pezzo non ha superficie</translation>
    </message>
    <message>
        <source>the part is not closed, or cuts itself, where the rod is taken out of it</source>
        <translation>il pezzo non è chiuso, o si taglia da sé, dove la barra ne viene tolta</translation>
    </message>
    <message>
        <source>the part is not closed, or cuts itself, where the surface&apos;s body is taken out of it</source>
        <translation>il pezzo non è chiuso, o si taglia da sé, dove il corpo della superficie ne viene tolto</translation>
    </message>
    <message>
        <source>the part is too large for a collision grid of this fineness</source>
        <translation>il pezzo è troppo grande per una griglia di collisioni così fine</translation>
    </message>
    <message numerus="yes">
        <source>the part is turned by {angle:.0f} about ({x}, {y}, {z}): one pass of growth misses {missed} voxels of {voxel:.2f} instead of {missedBefore}, {overhang:.0f} overhang instead of {overhangBefore:.0f#}</source>
        <translation>
            <numerusform>il pezzo è girato di {angle:.0f} attorno a ({x}, {y}, {z}): una passata di crescita manca {missed} voxel di {voxel:.2f} invece di {missedBefore}, {overhang:.0f} di sbalzo invece di {overhangBefore:.0f#}</numerusform>
            <numerusform>il pezzo è girato di {angle:.0f} attorno a ({x}, {y}, {z}): una passata di crescita manca {missed} voxel di {voxel:.2f} invece di {missedBefore}, {overhang:.0f} di sbalzo invece di {overhangBefore:.0f#}</numerusform>
        </translation>
    </message>
    <message>
        <source>the part is turned by {angle:.0f} about ({x}, {y}, {z}): {overhang:.0f} overhang instead of {overhangBefore:.0f#}</source>
        <translation>il pezzo è girato di {angle:.0f} attorno a ({x}, {y}, {z}): {overhang:.0f} di sbalzo invece di {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part is {width:.3g} mm wide, as wide as the cylinder that it stands on</source>
        <translation>il pezzo è largo {width:.3g} mm, quanto il cilindro su cui poggia</translation>
    </message>
    <message>
        <source>the part misses the rod: nothing of it lies on the rod</source>
        <translation>il pezzo manca la barra: nulla di esso poggia sulla barra</translation>
    </message>
    <message>
        <source>the part misses the surface: nothing of it lies on the surface</source>
        <translation>il pezzo manca la superficie: nulla di esso poggia sulla superficie</translation>
    </message>
    <message>
        <source>the part reaches below the platform</source>
        <translation>il pezzo arriva sotto la piattaforma</translation>
    </message>
    <message>
        <source>the part reaches from x = {from:.4g} to {to:.4g} mm, beyond an end of the rod at {firstEnd:.4g} or {lastEnd:.4g} mm</source>
        <translation>il pezzo va da x = {from:.4g} a {to:.4g} mm, oltre un&apos;estremità della barra a {firstEnd:.4g} o {lastEnd:.4g} mm</translation>
    </message>
    <message>
        <source>the part reaches {height:.3g} mm out over the rod, less than a layer of {least:.3g} mm</source>
        <translation>il pezzo sporge di {height:.3g} mm dalla barra, meno di uno strato di {least:.3g} mm</translation>
    </message>
    <message>
        <source>the part reaches {reach:.4g} from the rod&apos;s axis, the cell prints up to {limit}</source>
        <translation>il pezzo arriva a {reach:.4g} dall&apos;asse della barra, la cella stampa fino a {limit}</translation>
    </message>
    <message>
        <source>the part rises {height:.3g} mm over the surface, less than a layer of {least:.3g} mm</source>
        <translation>il pezzo sale di {height:.3g} mm sopra la superficie, meno di uno strato di {least:.3g} mm</translation>
    </message>
    <message>
        <source>the part stands on no cylinder along x, which an end surface radius:R is for</source>
        <translation>il pezzo non poggia su un cilindro lungo x, per cui serve una superficie finale radius:R</translation>
    </message>
    <message numerus="yes">
        <source>the part stays as it lies: none of {ways} ways that stand is better</source>
        <translation>
            <numerusform>il pezzo resta come sta: l&apos;unico modo in cui sta in piedi non è migliore</numerusform>
            <numerusform>il pezzo resta come sta: nessuno dei {ways} modi in cui sta in piedi è migliore</numerusform>
        </translation>
    </message>
    <message>
        <source>the placement is not a turn and a place in mm</source>
        <translation>il posizionamento non è una rotazione e un punto in mm</translation>
    </message>
    <message>
        <source>the plane misses the part</source>
        <translation>il piano non tocca il pezzo</translation>
    </message>
    <message>
        <source>the planes are not a JSON list</source>
        <translation>i piani non sono una lista JSON</translation>
    </message>
    <message>
        <source>the platform</source>
        <translation>la piattaforma</translation>
    </message>
    <message>
        <source>the platform&apos;s mesh is not closed</source>
        <translation>la mesh della piattaforma non è chiusa</translation>
    </message>
    <message>
        <source>the points lie on a line</source>
        <translation>i punti stanno su una retta</translation>
    </message>
    <message>
        <source>the print head would cut into material printed before, whatever way it leans</source>
        <translation>la testa di stampa urterebbe materiale già stampato, comunque si inclini</translation>
    </message>
    <message>
        <source>the procedure has no ENDPROC</source>
        <translation>la procedura non ha ENDPROC</translation>
    </message>
    <message numerus="yes">
        <source>the program ends here; {motions} planned motions not in it</source>
        <translation>
            <numerusform>il programma finisce qui; manca {motions} movimento pianificato</numerusform>
            <numerusform>il programma finisce qui; mancano {motions} movimenti pianificati</numerusform>
        </translation>
    </message>
    <message>
        <source>the program has no motions</source>
        <translation>il programma non ha movimenti</translation>
    </message>
    <message>
        <source>the program runs from 0 to {end:.1f}</source>
        <translation>il programma va da 0 a {end:.1f}</translation>
    </message>
    <message>
        <source>the program&apos;s data folder is missing</source>
        <translation>manca la cartella dei dati del programma</translation>
    </message>
    <message>
        <source>the program&apos;s motions are not those of this plan</source>
        <translation>i movimenti del programma non sono quelli di questo piano</translation>
    </message>
    <message>
        <source>the quadrilateral has no area</source>
        <translation>il quadrilatero non ha area</translation>
    </message>
    <message>
        <source>the quadrilateral is not convex</source>
        <translation>il quadrilatero non è convesso</translation>
    </message>
    <message>
        <source>the quadrilateral is not flat</source>
        <translation>il quadrilatero non è piano</translation>
    </message>
    <message>
        <source>the radius at point {i} is not positive</source>
        <translation>il raggio al punto {i} non è positivo</translation>
    </message>
    <message>
        <source>the report is not one of a plan: {why}</source>
        <translation>il rapporto non è quello di un piano: {why}</translation>
    </message>
    <message>
        <source>the robot motion is empty</source>
        <translation>il movimento del robot è vuoto</translation>
    </message>
    <message>
        <source>the rod is thicker than the part: nothing of the part is outside it</source>
        <translation>la barra è più spessa del pezzo: nulla del pezzo ne sta fuori</translation>
    </message>
    <message>
        <source>the rod reaches {reach} mm from its middle, the cell has room for {room}</source>
        <translation>la barra arriva a {reach} mm dal suo centro, la cella ha posto per {room}</translation>
    </message>
    <message>
        <source>the rod&apos;s radius is {radius} mm, the cell prints up to {most}</source>
        <translation>il raggio della barra è {radius} mm, la cella stampa fino a {most}</translation>
    </message>
    <message>
        <source>the root at {x:.1f}, {y:.1f}, {z:.1f} mm does not stand on the plate</source>
        <translation>la radice a {x:.1f}, {y:.1f}, {z:.1f} mm non poggia sulla piastra</translation>
    </message>
    <message>
        <source>the row has {cells} cells, the first one has {first}</source>
        <translation>la riga ha {cells} celle, la prima ne ha {first}</translation>
    </message>
    <message>
        <source>the surface covers the part: nothing of the part is outside its body</source>
        <translation>la superficie copre il pezzo: nulla del pezzo è fuori dal suo corpo</translation>
    </message>
    <message>
        <source>the voxel object is lifted by other than whole cells: its surface is cut into new cells</source>
        <translation>l&apos;oggetto di voxel è sollevato di celle non intere: la sua superficie viene divisa in celle nuove</translation>
    </message>
    <message>
        <source>the voxel object is turned by other than quarter turns: its surface is cut into new cells</source>
        <translation>l&apos;oggetto di voxel è girato di quarti non interi: la sua superficie viene divisa in celle nuove</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>i voxel sono troppo piccoli per un pezzo di questa misura</translation>
    </message>
    <message>
        <source>the {format} program is not handed over: {failed}</source>
        <translation>il programma {format} non viene consegnato: {failed}</translation>
    </message>
    <message>
        <source>there is no layer {layer}</source>
        <translation>lo strato {layer} non esiste</translation>
    </message>
    <message>
        <source>there is no module</source>
        <translation>non c&apos;è alcun modulo</translation>
    </message>
    <message>
        <source>there is no platform: no - in any row</source>
        <translation>non c&apos;è piattaforma: nessun - in alcuna riga</translation>
    </message>
    <message>
        <source>there is no time {time}</source>
        <translation>il tempo {time} non esiste</translation>
    </message>
    <message>
        <source>thicken the wall to {least} or more</source>
        <translation>ispessisci la parete a {least} o più</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>spessori</translation>
    </message>
    <message>
        <source>this machine gives no OpenGL 3.2 without a display: {why}</source>
        <translation>questa macchina non offre OpenGL 3.2 senza schermo: {why}</translation>
    </message>
    <message>
        <source>this module is not the one that main runs next</source>
        <translation>questo modulo non è quello che main esegue dopo</translation>
    </message>
    <message>
        <source>this motion and that of {other} have changed places</source>
        <translation>questo movimento e quello di {other} si sono scambiati di posto</translation>
    </message>
    <message>
        <source>this motion lays {volume:.3f}, planned are {planned:.3f}</source>
        <translation>questo movimento depone {volume:.3f}, ne sono pianificati {planned:.3f}</translation>
    </message>
    <message>
        <source>this motion takes {time:.3f}, planned are {planned:.3f}</source>
        <translation>questo movimento dura {time:.3f}, ne sono pianificati {planned:.3f}</translation>
    </message>
    <message>
        <source>time runs backwards</source>
        <translation>il tempo va all&apos;indietro</translation>
    </message>
    <message>
        <source>too many triangles for an STL file</source>
        <translation>troppi triangoli per un file STL</translation>
    </message>
    <message>
        <source>tool-paths</source>
        <translation>percorsi utensile</translation>
    </message>
    <message>
        <source>touch points farther apart around the cylinder</source>
        <translation>tocca punti più lontani tra loro attorno al cilindro</translation>
    </message>
    <message>
        <source>touched points</source>
        <translation>punti toccati</translation>
    </message>
    <message>
        <source>trimming layers on the part</source>
        <translation>rifilatura degli strati sul pezzo</translation>
    </message>
    <message>
        <source>try a larger voxelMm or a smaller part</source>
        <translation>prova un voxelMm più grande o un pezzo più piccolo</translation>
    </message>
    <message>
        <source>turn it by quarter turns and lift it by whole cells to keep its own</source>
        <translation>giralo di quarti di giro e sollevalo di celle intere per tenere le sue</translation>
    </message>
    <message>
        <source>turn of infill</source>
        <translation>rotazione del riempimento</translation>
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
        <source>turn the part about the vertical, or try more turns (redundancySamples)</source>
        <translation>gira il pezzo attorno alla verticale, o prova più giri (redundancySamples)</translation>
    </message>
    <message>
        <source>turn the part, enlarge the platform or add supports</source>
        <translation>gira il pezzo, allarga la piattaforma o aggiungi supporti</translation>
    </message>
    <message>
        <source>turn the part, make the platform smaller or add supports</source>
        <translation>gira il pezzo, rimpicciolisci la piattaforma o aggiungi supporti</translation>
    </message>
    <message>
        <source>turn the part, or allow less clearance</source>
        <translation>gira il pezzo, o ammetti meno distanza</translation>
    </message>
    <message>
        <source>turn the part, use a smaller platform, or allow less clearance</source>
        <translation>gira il pezzo, usa una piattaforma più piccola, o ammetti meno distanza</translation>
    </message>
    <message numerus="yes">
        <source>turned {count} components that faced inside out</source>
        <translation>
            <numerusform>girata {count} componente rovesciata</numerusform>
            <numerusform>girate {count} componenti rovesciate</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>turned {count} triangles to face as the others do</source>
        <translation>
            <numerusform>girato {count} triangolo per guardare come gli altri</numerusform>
            <numerusform>girati {count} triangoli per guardare come gli altri</numerusform>
        </translation>
    </message>
    <message>
        <source>turning the part may need fewer</source>
        <translation>girando il pezzo forse ne servono meno</translation>
    </message>
    <message>
        <source>turns about the nozzle</source>
        <translation>rotazioni attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>two commands in one line</source>
        <translation>due comandi in una riga</translation>
    </message>
    <message numerus="yes">
        <source>united {count} overlapping components</source>
        <translation>
            <numerusform>unita {count} componente sovrapposta</numerusform>
            <numerusform>unite {count} componenti sovrapposte</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown cell &apos;{id}&apos;</source>
        <translation>cella &apos;{id}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown cell &apos;{name}&apos;</source>
        <translation>cella &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown colour &apos;{name}&apos;</source>
        <translation>colore &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown failure</source>
        <translation>errore sconosciuto</translation>
    </message>
    <message>
        <source>unknown format &apos;{id}&apos;</source>
        <translation>formato &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown format &apos;{name}&apos;</source>
        <translation>formato &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown growth &apos;{name}&apos;</source>
        <translation>crescita &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown infill &apos;{id}&apos;</source>
        <translation>riempimento &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown key &apos;{key}&apos;</source>
        <translation>chiave &apos;{key}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown mode &apos;{name}&apos;</source>
        <translation>modalità &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown parameter &apos;{key}&apos;</source>
        <translation>parametro &apos;{key}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown picture &apos;{name}&apos;</source>
        <translation>immagine &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown platform &apos;{name}&apos;</source>
        <translation>piattaforma &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown process &apos;{id}&apos;</source>
        <translation>processo &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown process &apos;{name}&apos;</source>
        <translation>processo &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown robot &apos;{id}&apos;</source>
        <translation>robot &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown sample &apos;{name}&apos;</source>
        <translation>esempio &apos;{name}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>unknown stage &apos;{name}&apos;</source>
        <translation>fase &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>unknown view &apos;{name}&apos;</source>
        <translation>vista &apos;{name}&apos; sconosciuta</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print the part larger</source>
        <translation>usa un ugello più fine, o stampa il pezzo più grande</translation>
    </message>
    <message>
        <source>use a larger platform (fit:MARGIN), or turn the part</source>
        <translation>usa una piattaforma più grande (fit:MARGIN), o gira il pezzo</translation>
    </message>
    <message>
        <source>use a slimmer head, turn the part, or print it larger</source>
        <translation>usa una testa più snella, gira il pezzo, o stampalo più grande</translation>
    </message>
    <message>
        <source>use a slimmer print head or thinner layers</source>
        <translation>usa una testina più snella o strati più sottili</translation>
    </message>
    <message>
        <source>use a smaller platform or place the part higher</source>
        <translation>usa una piattaforma più piccola o metti il pezzo più in alto</translation>
    </message>
    <message>
        <source>use a thinner rod, or print the part larger</source>
        <translation>usa una barra più sottile, o stampa il pezzo più grande</translation>
    </message>
    <message>
        <source>use at least {least}</source>
        <translation>usa almeno {least}</translation>
    </message>
    <message>
        <source>use at most {side} cells a side and {millions} million in all</source>
        <translation>usa al massimo {side} celle per lato e {millions} milioni in tutto</translation>
    </message>
    <message>
        <source>use infill zigzag or concentric, or mode lathe</source>
        <translation>usa il riempimento zigzag o concentric, o la modalità lathe</translation>
    </message>
    <message>
        <source>use lower layers or a finer nozzle, or print the part larger</source>
        <translation>usa strati più bassi o un ugello più fine, o stampa il pezzo più grande</translation>
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
        <source>voxels of {width} need about {needed} of memory, {available} are free</source>
        <translation>voxel di {width} richiedono circa {needed} di memoria, ne sono liberi {available}</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>pareti</translation>
    </message>
    <message>
        <source>what is unloaded was not loaded and run</source>
        <translation>ciò che viene scaricato non era stato caricato ed eseguito</translation>
    </message>
    <message>
        <source>winding angle</source>
        <translation>angolo avvolgimento</translation>
    </message>
    <message>
        <source>woven</source>
        <translation>intrecciato</translation>
    </message>
    <message>
        <source>write 1 for the part, 0 for air, - for the platform</source>
        <translation>scrivi 1 per il pezzo, 0 per l&apos;aria, - per la piattaforma</translation>
    </message>
    <message>
        <source>write 1 where the part is</source>
        <translation>scrivi 1 dove sta il pezzo</translation>
    </message>
    <message>
        <source>write files</source>
        <translation>scrittura dei file</translation>
    </message>
    <message>
        <source>write flat, flat:Z, radius:R or mesh:FILE, in mm</source>
        <translation>scrivi flat, flat:Z, radius:R o mesh:FILE, in mm</translation>
    </message>
    <message>
        <source>write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm</source>
        <translation>scrivi coppie come -20,2.5 0,2.5 0,3.5 20,3.5 in mm</translation>
    </message>
    <message>
        <source>write refused programs</source>
        <translation>scrivi i programmi respinti</translation>
    </message>
    <message>
        <source>write rows of 0 and 1, and - for the platform</source>
        <translation>scrivi righe di 0 e 1, e - per la piattaforma</translation>
    </message>
    <message>
        <source>write the program again, or plan anew with this change</source>
        <translation>scrivi di nuovo il programma, o pianifica di nuovo con questa modifica</translation>
    </message>
    <message>
        <source>write what every stage made</source>
        <translation>scrivi il risultato di ogni fase</translation>
    </message>
    <message>
        <source>write x,y,z in mm</source>
        <translation>scrivi x,y,z in mm</translation>
    </message>
    <message>
        <source>write x,y,z in mm, as 10,0,5</source>
        <translation>scrivi x,y,z in mm, come 10,0,5</translation>
    </message>
    <message>
        <source>write {format}</source>
        <translation>scrittura {format}</translation>
    </message>
    <message>
        <source>write {form}</source>
        <translation>scrivi {form}</translation>
    </message>
    <message>
        <source>write {form}, in mm</source>
        <translation>scrivi {form}, in mm</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x runs back at point {i}</source>
        <translation>x torna indietro al punto {i}</translation>
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
        <source>{area:.3g} hang where a support has nothing to stand on</source>
        <translation>{area:.3g} pendono dove un supporto non ha su che poggiare</translation>
    </message>
    <message>
        <source>{area:.3g} lean over by more than {angle}</source>
        <translation>{area:.3g} si inclinano di oltre {angle}</translation>
    </message>
    <message>
        <source>{area:.3g} of the part lean out by more than {angle:.3g} over lower layers, the most at x = {x:.4g}, radius {radius:.4g}</source>
        <translation>{area:.3g} del pezzo sporgono di oltre {angle:.3g} sugli strati inferiori, il più a x = {x:.4g}, raggio {radius:.4g}</translation>
    </message>
    <message>
        <source>{area:.3g} of the part lean out by more than {angle:.3g} over lower layers, the most at {at:.4g}</source>
        <translation>{area:.3g} del pezzo sporgono di oltre {angle:.3g} sugli strati inferiori, il più a {at:.4g}</translation>
    </message>
    <message numerus="yes">
        <source>{bad} of {facets} facets have coordinates that are no numbers or beyond all measure, the first is facet {first}</source>
        <translation>
            <numerusform>{bad} di {facets} faccette ha coordinate che non sono numeri o fuori misura, la prima è la faccetta {first}</numerusform>
            <numerusform>{bad} di {facets} faccette hanno coordinate che non sono numeri o fuori misura, la prima è la faccetta {first}</numerusform>
        </translation>
    </message>
    <message>
        <source>{blocked} of {pieces} pieces: something printed before is in the head&apos;s way</source>
        <translation>{blocked} di {pieces} parti: qualcosa stampato prima intralcia la testina</translation>
    </message>
    <message numerus="yes">
        <source>{columns} more columns carry what would be missed</source>
        <translation>
            <numerusform>un&apos;altra colonna porta ciò che mancherebbe</numerusform>
            <numerusform>altre {columns} colonne portano ciò che mancherebbe</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} components that are inside out, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} componente rovesciata, a {first:.2f}</numerusform>
            <numerusform>{count} componenti rovesciate, la prima a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} duplicate triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} triangolo doppio, a {first:.2f}</numerusform>
            <numerusform>{count} triangoli doppi, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges whose triangles face opposite ways, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} spigolo i cui triangoli guardano in versi opposti, a {first:.2f}</numerusform>
            <numerusform>{count} spigoli i cui triangoli guardano in versi opposti, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with more than two triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} spigolo con più di due triangoli, a {first:.2f}</numerusform>
            <numerusform>{count} spigoli con più di due triangoli, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} open edges in {loops} loops, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} spigolo aperto in {loops} contorni, il primo a {first:.2f}</numerusform>
            <numerusform>{count} spigoli aperti in {loops} contorni, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} pairs of triangles that cut each other, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} coppia di triangoli che si tagliano, a {first:.2f}</numerusform>
            <numerusform>{count} coppie di triangoli che si tagliano, la prima a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} triangles without area, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} triangolo senza area, a {first:.2f}</numerusform>
            <numerusform>{count} triangoli senza area, il primo a {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} voxels</source>
        <translation>
            <numerusform>{count} voxel</numerusform>
            <numerusform>{count} voxel</numerusform>
        </translation>
    </message>
    <message>
        <source>{file}, byte {byte}</source>
        <translation>{file}, byte {byte}</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}, riga {line}</translation>
    </message>
    <message>
        <source>{file}, line {line}, column {column}</source>
        <translation>{file}, riga {line}, colonna {column}</translation>
    </message>
    <message>
        <source>{first} and {second} collide</source>
        <translation>{first} e {second} si scontrano</translation>
    </message>
    <message>
        <source>{first} meets {second} in the finished motion</source>
        <translation>{first} tocca {second} nel movimento finito</translation>
    </message>
    <message>
        <source>{found} is none of 0, 1 and -</source>
        <translation>{found} non è né 0 né 1 né -</translation>
    </message>
    <message>
        <source>{joint} at {angle:.1f}, its limit is {limit:.1f#}</source>
        <translation>{joint} a {angle:.1f}, il suo limite è {limit:.1f#}</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}, its limit is {limit:.1f#}</source>
        <translation>{joint} a {speed:.1f}, il suo limite è {limit:.1f#}</translation>
    </message>
    <message>
        <source>{left:.3g#} of {whole:.4g} of the part are in no layer</source>
        <translation>{left:.3g#} di {whole:.4g} del pezzo non sono in alcuno strato</translation>
    </message>
    <message>
        <source>{length:.1f} of bead have nothing beneath them, the first of them here</source>
        <translation>{length:.1f} di cordone non hanno nulla sotto, il primo è qui</translation>
    </message>
    <message numerus="yes">
        <source>{missed} of {voxels} voxels have nothing printed under them</source>
        <translation>
            <numerusform>{missed} di {voxels} voxel non ha nulla di stampato sotto</numerusform>
            <numerusform>{missed} di {voxels} voxel non hanno nulla di stampato sotto</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} motions from here on not in the plan</source>
        <translation>
            <numerusform>{motions} movimento da qui in poi non è nel piano</numerusform>
            <numerusform>{motions} movimenti da qui in poi non sono nel piano</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions missing before this one</source>
        <translation>
            <numerusform>manca {motions} movimento pianificato prima di questo</numerusform>
            <numerusform>mancano {motions} movimenti pianificati prima di questo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions missing between {before} and this one</source>
        <translation>
            <numerusform>manca {motions} movimento pianificato tra {before} e questo</numerusform>
            <numerusform>mancano {motions} movimenti pianificati tra {before} e questo</numerusform>
        </translation>
    </message>
    <message>
        <source>{option}: a value is not finite</source>
        <translation>{option}: un valore non è finito</translation>
    </message>
    <message>
        <source>{option}: {wanted} numbers wanted, {given} given</source>
        <translation>{option}: servono {wanted} numeri, dati {given}</translation>
    </message>
    <message>
        <source>{outside:.2f} of the part&apos;s volume is laid outside it, {noRoom:.2f} finds no room</source>
        <translation>il {outside:.2f} del volume del pezzo è deposto fuori da esso, il {noRoom:.2f} non trova posto</translation>
    </message>
    <message numerus="yes">
        <source>{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is under them</source>
        <translation>
            <numerusform>{patches} superficie ({area:.1f}) comincia nel vuoto: sotto non ha né la piastra né uno strato precedente</numerusform>
            <numerusform>{patches} superfici ({area:.1f}) cominciano nel vuoto: sotto non hanno né la piastra né uno strato precedente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are too small for a bead or would begin in the air and are not laid ({volume:.1f} in all, the largest {largest:.1f})</source>
        <translation>
            <numerusform>{pieces} parte di uno strato è troppo piccola per un cordone o comincerebbe nel vuoto e non viene deposta ({volume:.1f})</numerusform>
            <numerusform>{pieces} parti di strati sono troppo piccole per un cordone o comincerebbero nel vuoto e non vengono deposte ({volume:.1f} in tutto, la più grande {largest:.1f})</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are too small for a bead or would begin in the air, {volume:.3g} of {whole:.3g#}: they are not laid</source>
        <translation>
            <numerusform>{pieces} parte di uno strato è troppo piccola per un cordone o comincerebbe nel vuoto, {volume:.3g} di {whole:.3g#}: non viene deposta</numerusform>
            <numerusform>{pieces} parti di strati sono troppo piccole per un cordone o comincerebbero nel vuoto, {volume:.3g} di {whole:.3g#}: non vengono deposte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers have neither the rod nor an earlier layer under them</source>
        <translation>
            <numerusform>una parte di uno strato non ha sotto né la barra né uno strato precedente</numerusform>
            <numerusform>{pieces} parti di strati non hanno sotto né la barra né uno strato precedente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers have neither the surface nor an earlier layer under them</source>
        <translation>
            <numerusform>una parte di uno strato non ha sotto né la superficie né uno strato precedente</numerusform>
            <numerusform>{pieces} parti di strati non hanno sotto né la superficie né uno strato precedente</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers have nothing under them</source>
        <translation>
            <numerusform>{pieces} parte di uno strato non ha nulla sotto</numerusform>
            <numerusform>{pieces} parti di strati non hanno nulla sotto</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} places where the text is not what was planned</source>
        <translation>
            <numerusform>{places} punto in cui il testo non è quello pianificato</numerusform>
            <numerusform>{places} punti in cui il testo non è quello pianificato</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the thinnest is {thinnest:.2f} thick</source>
        <translation>
            <numerusform>{places} punto più piccolo è più sottile di un voxel di {voxel}; è spesso {thinnest:.2f}</numerusform>
            <numerusform>{places} punti più piccoli sono più sottili di un voxel di {voxel}; questo è il più grande, il più sottile è spesso {thinnest:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places lean over too far, {area:.3g} together; this is the largest of them</source>
        <translation>
            <numerusform>{places} punto più piccolo si inclina troppo, {area:.3g}</numerusform>
            <numerusform>{places} punti più piccoli si inclinano troppo, {area:.3g} in tutto; questo è il più grande</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{place}: no way to {pieces} pieces of paths was found that keeps clear of everything</source>
        <translation>
            <numerusform>{place}: non si è trovata una via per {pieces} tratto di percorso che stia lontana da tutto</numerusform>
            <numerusform>{place}: non si è trovata una via per {pieces} tratti di percorso che stia lontana da tutto</numerusform>
        </translation>
    </message>
    <message>
        <source>{place}: the cell prints up to {radius} from the rod&apos;s axis and {along} from its middle</source>
        <translation>{place}: la cella stampa fino a {radius} dall&apos;asse della barra e {along} dal suo centro</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into the platform</source>
        <translation>{place}: la testina entrerebbe nella piattaforma</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into what is printed already</source>
        <translation>{place}: la testina entrerebbe in ciò che è già stampato</translation>
    </message>
    <message>
        <source>{place}: the robot can be here, but cannot come from or go on to a neighbouring place without lifting</source>
        <translation>{place}: il robot può stare qui, ma non può venire da un punto vicino o proseguire verso di esso senza sollevarsi</translation>
    </message>
    <message>
        <source>{place}: the robot cannot bring this place under the nozzle: out of reach, or beyond a joint&apos;s limits, however the part is turned about the nozzle</source>
        <translation>{place}: il robot non può portare questo punto sotto l&apos;ugello: fuori portata, o oltre i limiti di un giunto, comunque si giri il pezzo attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>{place}: {first} would meet {second}, however the part is turned about the nozzle</source>
        <translation>{place}: {first} toccherebbe {second}, comunque si giri il pezzo attorno all&apos;ugello</translation>
    </message>
    <message>
        <source>{points} points do not make a circle: it takes three</source>
        <translation>{points} punti non fanno un cerchio: ne servono tre</translation>
    </message>
    <message>
        <source>{share:.0f} of the layers&apos; area is thinner than {least} or thicker than {most}</source>
        <translation>il {share:.0f} dell&apos;area degli strati è più sottile di {least} o più spesso di {most}</translation>
    </message>
    <message>
        <source>{share:.2f} of the part is in no bead; most of it round the place given</source>
        <translation>il {share:.2f} del pezzo non è in alcun cordone; per lo più attorno al punto indicato</translation>
    </message>
    <message>
        <source>{sizes} mm</source>
        <translation>{sizes} mm</translation>
    </message>
    <message>
        <source>{there} of the {promised} facets that the header promises are there</source>
        <translation>ci sono {there} delle {promised} faccette che l&apos;intestazione promette</translation>
    </message>
    <message>
        <source>{threshold} {value:.4g} (limit {limit:.4g})</source>
        <translation>{threshold} {value:.4g} (limite {limit:.4g})</translation>
    </message>
    <message>
        <source>{value} is beyond process {process}</source>
        <translation>{value} è oltre il processo {process}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} more voxels are missed in smaller groups ({groups}); this is the largest</source>
        <translation>
            <numerusform>manca un altro voxel; è questo</numerusform>
            <numerusform>mancano altri {voxels} voxel in gruppi più piccoli ({groups}); questo è il più grande</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: from step {step} on they lie inside the front, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm</source>
        <translation>
            <numerusform>{voxels} voxel è in ombra: dal passo {step} in poi sta dentro il fronte, sotto la sua faccetta tra {a:.0f}, {b:.0f} e {c:.0f} mm</numerusform>
            <numerusform>{voxels} voxel sono in ombra: dal passo {step} in poi stanno dentro il fronte, sotto la sua faccetta tra {a:.0f}, {b:.0f} e {c:.0f} mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: from step {step} on they lie inside the front, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm; {more} more hang on them</source>
        <translation>
            <numerusform>{voxels} voxel è in ombra: dal passo {step} in poi sta dentro il fronte, sotto la sua faccetta tra {a:.0f}, {b:.0f} e {c:.0f} mm; altri {more} dipendono da esso</numerusform>
            <numerusform>{voxels} voxel sono in ombra: dal passo {step} in poi stanno dentro il fronte, sotto la sua faccetta tra {a:.0f}, {b:.0f} e {c:.0f} mm; altri {more} dipendono da essi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: inside the front before they were reached</source>
        <translation>
            <numerusform>{voxels} voxel è in ombra: dentro il fronte prima di essere raggiunto</numerusform>
            <numerusform>{voxels} voxel sono in ombra: dentro il fronte prima di essere raggiunti</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: inside the front before they were reached; {more} more hang on them</source>
        <translation>
            <numerusform>{voxels} voxel è in ombra: dentro il fronte prima di essere raggiunto; altri {more} dipendono da esso</numerusform>
            <numerusform>{voxels} voxel sono in ombra: dentro il fronte prima di essere raggiunti; altri {more} dipendono da essi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are unreached: no path through the part from the platform</source>
        <translation>
            <numerusform>{voxels} voxel non è raggiunto: nessuna via attraverso il pezzo dalla piattaforma</numerusform>
            <numerusform>{voxels} voxel non sono raggiunti: nessuna via attraverso il pezzo dalla piattaforma</numerusform>
        </translation>
    </message>
    <message>
        <source>{voxels} voxels in a grid of {cells} cells need about {needed} of memory, {available} are free</source>
        <translation>{voxels} voxel in una griglia di {cells} celle richiedono circa {needed} di memoria, ne sono liberi {available}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels lie below the plate</source>
        <translation>
            <numerusform>{voxels} voxel sta sotto la piastra</numerusform>
            <numerusform>{voxels} voxel stanno sotto la piastra</numerusform>
        </translation>
    </message>
    <message>
        <source>{where}, entry {number}</source>
        <translation>{where}, voce {number}</translation>
    </message>
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
        <source>repair the mesh, or use curved mode, which takes any mesh</source>
        <translation>ripara la mesh, o usa la modalità curva, che accetta qualsiasi mesh</translation>
    </message>
    <message>
        <source>the section of the mesh by a plane crosses itself</source>
        <translation>la sezione della mesh con un piano interseca se stessa</translation>
    </message>
    <message>
        <source>EGL cannot start</source>
        <translation>EGL non può partire</translation>
    </message>
    <message>
        <source>EGL lacks platform displays</source>
        <translation>a EGL mancano gli schermi di piattaforma</translation>
    </message>
    <message>
        <source>its functions cannot be found</source>
        <translation>le sue funzioni non si trovano</translation>
    </message>
    <message>
        <source>no context can be made</source>
        <translation>non si può creare un contesto</translation>
    </message>
    <message>
        <source>the context cannot be used</source>
        <translation>il contesto non si può usare</translation>
    </message>
    <message>
        <source>Plate of the cell</source>
        <translation>Piastra della cella</translation>
    </message>
    <message>
        <source>and further places, the first at {place}: something would meet on the way there, so they are left out</source>
        <translation>e altri punti, il primo a {place}: lungo la via qualcosa si urterebbe, perciò vengono tralasciati</translation>
    </message>
    <message>
        <source>cell {cell} comes without plates</source>
        <translation>la cella {cell} non ha piastre</translation>
    </message>
    <message>
        <source>choose another platform, or another cell</source>
        <translation>scegliere un&apos;altra piattaforma, o un&apos;altra cella</translation>
    </message>
    <message>
        <source>copy it to a file first</source>
        <translation>copiarlo prima in un file</translation>
    </message>
    <message>
        <source>give --platform disc:DIAMETER, or another platform</source>
        <translation>indicare --platform disc:DIAMETER, o un&apos;altra piattaforma</translation>
    </message>
    <message>
        <source>is no ordinary file, but a device or a pipe</source>
        <translation>non è un file ordinario, ma un dispositivo o una pipe</translation>
    </message>
    <message>
        <source>look at these places in the picture; turn the part where they matter</source>
        <translation>guardare questi punti nell&apos;immagine; girare il pezzo dove contano</translation>
    </message>
    <message>
        <source>no way of building takes platform {platform} in cell {cell}</source>
        <translation>nessun modo di costruire prende la piattaforma {platform} nella cella {cell}</translation>
    </message>
    <message>
        <source>plate of the cell</source>
        <translation>piastra della cella</translation>
    </message>
    <message>
        <source>transfers</source>
        <translation>spostamenti</translation>
    </message>
    <message>
        <source>{place}: something would meet on the way here, so this place is left out</source>
        <translation>{place}: lungo la via fin qui qualcosa si urterebbe, perciò il punto viene tralasciato</translation>
    </message>
    <message numerus="yes">
        <source>{place}: the arm would not get away from where {pieces} pieces of paths end</source>
        <translation>
            <numerusform>{place}: il braccio non riuscirebbe ad allontanarsi da dove finisce {pieces} tratto di percorso</numerusform>
            <numerusform>{place}: il braccio non riuscirebbe ad allontanarsi da dove finiscono {pieces} tratti di percorsi</numerusform>
        </translation>
    </message>
    <message>
        <source>pieces are not cut out of a mesh with defects</source>
        <translation>da una mesh con difetti non si ritagliano pezzi</translation>
    </message>
    <message>
        <source>&apos;{units}&apos; is no unit of length</source>
        <translation>&apos;{units}&apos; non è un&apos;unità di lunghezza</translation>
    </message>
    <message>
        <source>25.4 times as large</source>
        <translation>25,4 volte più grande</translation>
    </message>
    <message>
        <source>A thousand times as large</source>
        <translation>Mille volte più grande</translation>
    </message>
    <message>
        <source>A thousandth of the size</source>
        <translation>Un millesimo della grandezza</translation>
    </message>
    <message>
        <source>As large as the least bead needs it</source>
        <translation>Grande quanto serve al cordone più stretto</translation>
    </message>
    <message>
        <source>As large as the robot reaches</source>
        <translation>Grande quanto il robot raggiunge</translation>
    </message>
    <message>
        <source>Centre the part</source>
        <translation>Centra il pezzo</translation>
    </message>
    <message>
        <source>It is in inches</source>
        <translation>È in pollici</translation>
    </message>
    <message>
        <source>It is in metres</source>
        <translation>È in metri</translation>
    </message>
    <message>
        <source>It is in micrometres</source>
        <translation>È in micrometri</translation>
    </message>
    <message>
        <source>Over the middle of the platform&apos;s place</source>
        <translation>Sopra il centro del posto della piattaforma</translation>
    </message>
    <message>
        <source>Print at scale {scale}</source>
        <translation>Stampa in scala {scale}</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>Adatta la scala</translation>
    </message>
    <message>
        <source>Use a finer process</source>
        <translation>Usa un processo più fine</translation>
    </message>
    <message>
        <source>With the widest bead that these walls have room for</source>
        <translation>Con il cordone più largo per cui queste pareti hanno posto</translation>
    </message>
    <message>
        <source>give one of {known}</source>
        <translation>indicare uno di {known}</translation>
    </message>
    <message>
        <source>give the units that it was drawn in (--units)</source>
        <translation>indicare le unità in cui è stato disegnato (--units)</translation>
    </message>
    <message>
        <source>place the part over the middle, or use a platform that reaches there</source>
        <translation>mettere il pezzo sopra il centro, o usare una piattaforma che arrivi fin lì</translation>
    </message>
    <message>
        <source>print it at scale {scale}, or with a process of narrower beads</source>
        <translation>stamparlo in scala {scale}, o con un processo dai cordoni più stretti</translation>
    </message>
    <message>
        <source>print it smaller (--scale fit), or give the units that it was drawn in (--units)</source>
        <translation>stamparlo più piccolo (--scale fit), o indicare le unità in cui è stato disegnato (--units)</translation>
    </message>
    <message>
        <source>the part is {size:.3g} long, if its file is in millimetres</source>
        <translation>il pezzo è lungo {size:.3g}, se il suo file è in millimetri</translation>
    </message>
    <message>
        <source>the part is {size:.4g} long, if its file is in millimetres</source>
        <translation>il pezzo è lungo {size:.4g}, se il suo file è in millimetri</translation>
    </message>
    <message>
        <source>the platform lies {distance:.0f} beside what carries it: it would float</source>
        <translation>la piattaforma è {distance:.0f} accanto a ciò che la regge: resterebbe sospesa</translation>
    </message>
    <message>
        <source>use a process of narrower beads; as large as it had to be it is out of the robot&apos;s reach</source>
        <translation>usare un processo dai cordoni più stretti; grande quanto dovrebbe essere, il robot non lo raggiunge</translation>
    </message>
    <message>
        <source>{share:.3g} of the part are walls thinner than the least bead of {least}, most of them {usual:.2f}</source>
        <translation>{share:.3g} del pezzo sono pareti più sottili del cordone più stretto di {least}, per lo più {usual:.2f}</translation>
    </message>
    <message>
        <source>Stand it the best way</source>
        <translation>Appoggia nel modo migliore</translation>
    </message>
    <message>
        <source>With the most contact for what leans over, and the fewest voxels missed</source>
        <translation>Con il maggior contatto per lo sbalzo che c’è e il minor numero di voxel mancati</translation>
    </message>
    <message>
        <source>give degrees about x, y and z: 90,0,0</source>
        <translation>indica i gradi attorno a x, y e z: 90,0,0</translation>
    </message>
    <message>
        <source>stand it that way, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another of its ways to stand</source>
        <translation>appoggialo in quel modo, girato di {x:.3g} attorno a x, {y:.3g} attorno a y e {z:.3g} attorno a z, oppure scegli un altro dei suoi appoggi</translation>
    </message>
    <message>
        <source>the part lies badly: {contact:.0f} of it touch the plate, {overhang:.0f} lean over, and one pass of growth misses {missed:.2g}; it can stand on {bestContact:.0f} with {bestOverhang:.0f} leaning over and {bestMissed:.2g} missed</source>
        <translation>il pezzo è appoggiato male: {contact:.0f} toccano il piatto, {overhang:.0f} sono a sbalzo e una passata di crescita ne manca {missed:.2g}; può appoggiare su {bestContact:.0f} con {bestOverhang:.0f} a sbalzo e {bestMissed:.2g} mancati</translation>
    </message>
    <message>
        <source>turn &apos;{turn}&apos; is not three angles</source>
        <translation>la rotazione «{turn}» non è fatta di tre angoli</translation>
    </message>
    <message>
        <source>ways to stand</source>
        <translation>modi di appoggio</translation>
    </message>
    <message>
        <source>{length:.1f} of a bead have nothing right beneath them; this material bridges {bridge:.1f}</source>
        <translation>{length:.1f} di un cordone non hanno nulla subito sotto; questo materiale ne scavalca {bridge:.1f}</translation>
    </message>
    <message>
        <source>a pedestal made for the part clears the head&apos;s way; it comes with its drawing</source>
        <translation>un piedistallo fatto per il pezzo lascia libera la testa; viene con il suo disegno</translation>
    </message>
    <message numerus="yes">
        <source>on this plate {here} voxels would be missed without columns, on a pedestal as wide as the part&apos;s foot {there}</source>
        <translation>
            <numerusform>su questo piano si perderebbe {here} voxel senza colonne, su un piedistallo largo quanto la base del pezzo {there}</numerusform>
            <numerusform>su questo piano si perderebbero {here} voxel senza colonne, su un piedistallo largo quanto la base del pezzo {there}</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;unitfactor&apos; is not above 0</source>
        <translation>«unitfactor» non è maggiore di 0</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not above 0, or larger than anything printed</source>
        <translation>«{attribute}» non è maggiore di 0, o più grande di ogni stampa</translation>
    </message>
    <message>
        <source>&apos;{element}&apos; outside tool-paths</source>
        <translation>«{element}» fuori dai percorsi</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; calls itself</source>
        <translation>«{name}» richiama sé stessa</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is called as it cannot be</source>
        <translation>«{name}» è chiamata in un modo impossibile</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; needs a mass</source>
        <translation>«{name}» richiede una massa</translation>
    </message>
    <message>
        <source>&apos;{path}&apos; is no name of a part in the package</source>
        <translation>«{path}» non è il nome di una parte del pacchetto</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; may not stand here: it changes the machine amid the print</source>
        <translation>«{word}» non può stare qui: cambia la macchina durante la stampa</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; slows the arm: the flow would not follow</source>
        <translation>«{word}» rallenta il braccio: il flusso non lo seguirebbe</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; tells the arm another load</source>
        <translation>«{word}» dichiara al braccio un altro carico</translation>
    </message>
    <message>
        <source>A 3MF with tool-paths (.build.3mf) is printed along these. Off: its object is planned anew.</source>
        <translation>Un 3MF con percorsi (.build.3mf) si stampa lungo questi. Disattivato: il suo oggetto viene pianificato da capo.</translation>
    </message>
    <message>
        <source>Adds NAME.build.3mf: the tool-paths of the plan in 6 axes for other programs (3MF Toolpath Extension).</source>
        <translation>Aggiunge NAME.build.3mf: i percorsi del piano a 6 assi per altri programmi (3MF Toolpath Extension).</translation>
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
        <translation>Programmi</translation>
    </message>
    <message>
        <source>RAPID modules</source>
        <translation>Moduli RAPID</translation>
    </message>
    <message>
        <source>URScript for</source>
        <translation>URScript per</translation>
    </message>
    <message>
        <source>a TriggL before its TriggEquip</source>
        <translation>un TriggL prima del suo TriggEquip</translation>
    </message>
    <message>
        <source>a bead is laid by a motion in joints, planned is a straight one</source>
        <translation>un cordone è deposto con un moto ai giunti, ne è previsto uno rettilineo</translation>
    </message>
    <message>
        <source>a character that no program holds: is this a binary file?</source>
        <translation>un carattere che nessun programma contiene: è un file binario?</translation>
    </message>
    <message>
        <source>a larger nozzle, or slower tool-paths</source>
        <translation>un ugello più grande, o percorsi più lenti</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos; without a range above 0 or without a factor of e, f, g and h</source>
        <translation>un modificatore di «{attribute}» senza intervallo sopra 0 o senza fattore tra e, f, g e h</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos;, which cannot be followed</source>
        <translation>un modificatore di «{attribute}», che non si può seguire</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos;, which its profile lacks</source>
        <translation>un modificatore di «{attribute}», che manca al suo profilo</translation>
    </message>
    <message>
        <source>a modifier of type &apos;{type}&apos;, which is not known</source>
        <translation>un modificatore di tipo «{type}», sconosciuto</translation>
    </message>
    <message>
        <source>a modifier outside a profile</source>
        <translation>un modificatore fuori da un profilo</translation>
    </message>
    <message>
        <source>a point is more than a kilometre away</source>
        <translation>un punto è a più di un chilometro</translation>
    </message>
    <message>
        <source>a point&apos;s frame has no direction</source>
        <translation>il riferimento di un punto non ha direzione</translation>
    </message>
    <message>
        <source>a second call outside the functions</source>
        <translation>una seconda chiamata fuori dalle funzioni</translation>
    </message>
    <message>
        <source>a segment of fewer than two points</source>
        <translation>un segmento di meno di due punti</translation>
    </message>
    <message>
        <source>a segment of type &apos;{type}&apos; among tool-paths of {axes} axes</source>
        <translation>un segmento di tipo «{type}» tra percorsi a {axes} assi</translation>
    </message>
    <message>
        <source>a support point of a modifier outside a point</source>
        <translation>un punto d&apos;appoggio di un modificatore fuori da un punto</translation>
    </message>
    <message>
        <source>a thread of its own is not read</source>
        <translation>un thread a parte non viene letto</translation>
    </message>
    <message>
        <source>a tool-path lies beyond what a build file can say</source>
        <translation>un percorso sta oltre ciò che un file di costruzione può dire</translation>
    </message>
    <message>
        <source>a work object that robot and external axis move is not read</source>
        <translation>un oggetto di lavoro mosso da robot e asse esterno non è letto</translation>
    </message>
    <message>
        <source>a {point} where none can be</source>
        <translation>un {point} dove non può stare</translation>
    </message>
    <message>
        <source>another tool than the one that prints</source>
        <translation>un utensile diverso da quello che stampa</translation>
    </message>
    <message>
        <source>asks for the extension &apos;{name}&apos;, which is not known</source>
        <translation>chiede l&apos;estensione «{name}», sconosciuta</translation>
    </message>
    <message>
        <source>at the controller&apos;s own speeds {share:.2f} of the beads&apos; length get more than 5 % too much or too little material, the first of them here</source>
        <translation>alle velocità proprie del controllore {share:.2f} della lunghezza dei cordoni riceve oltre il 5 % di materiale in più o in meno, il primo qui</translation>
    </message>
    <message>
        <source>bead {bead}</source>
        <translation>cordone {bead}</translation>
    </message>
    <message>
        <source>choose a bead before it or after it</source>
        <translation>scegliere un cordone prima o dopo</translation>
    </message>
    <message>
        <source>choose an earlier place</source>
        <translation>scegliere un punto precedente</translation>
    </message>
    <message>
        <source>factors of &apos;{attribute}&apos; are finer than its modifier&apos;s type</source>
        <translation>i fattori di «{attribute}» sono più fini del tipo del modificatore</translation>
    </message>
    <message>
        <source>from the front (x to the right, z up)</source>
        <translation>di fronte (x a destra, z in alto)</translation>
    </message>
    <message>
        <source>from the side (y to the right, z up)</source>
        <translation>di lato (y a destra, z in alto)</translation>
    </message>
    <message>
        <source>give --program</source>
        <translation>indicare --program</translation>
    </message>
    <message>
        <source>give --program, a file from {first} to {last}</source>
        <translation>indicare --program, un file da {first} a {last}</translation>
    </message>
    <message>
        <source>give the process that the tool-paths were made for</source>
        <translation>indicare il processo per cui i percorsi sono stati fatti</translation>
    </message>
    <message>
        <source>gravity other than that of an arm that stands upright</source>
        <translation>gravità diversa da quella di un braccio in piedi</translation>
    </message>
    <message>
        <source>has a document type, which is not taken</source>
        <translation>ha un tipo di documento, che non è accettato</translation>
    </message>
    <message>
        <source>holds neither an object nor beads that say how wide and high they are</source>
        <translation>non contiene né un oggetto né cordoni che dicano larghezza e altezza</translation>
    </message>
    <message>
        <source>holds no tool-paths</source>
        <translation>non contiene percorsi</translation>
    </message>
    <message>
        <source>is more than a joint of the robot is given</source>
        <translation>è più di quanto è dato a un giunto del robot</translation>
    </message>
    <message>
        <source>is no layer of tool-paths</source>
        <translation>non è uno strato di percorsi</translation>
    </message>
    <message>
        <source>leave scale and units as they are, or give givenToolPaths=false</source>
        <translation>lasciare scala e unità come sono, o dare givenToolPaths=false</translation>
    </message>
    <message>
        <source>line {line} may be of any of {count} files</source>
        <translation>la riga {line} può essere di uno qualsiasi di {count} file</translation>
    </message>
    <message>
        <source>lines end in two ways, from here on another</source>
        <translation>le righe finiscono in due modi, da qui in poi in un altro</translation>
    </message>
    <message>
        <source>more than a zip file can hold</source>
        <translation>più di quanto un file zip possa contenere</translation>
    </message>
    <message>
        <source>more tool-path points than can be planned</source>
        <translation>più punti di quanti se ne possano pianificare</translation>
    </message>
    <message>
        <source>motions per file</source>
        <translation>movimenti per file</translation>
    </message>
    <message>
        <source>near singular poses the arm would leave its planned turn</source>
        <translation>vicino alle singolarità il braccio lascerebbe l&apos;orientamento previsto</translation>
    </message>
    <message>
        <source>no motion stands at line {line} or after it</source>
        <translation>nessun moto alla riga {line} o dopo</translation>
    </message>
    <message>
        <source>no object in the file: the part is what its beads make</source>
        <translation>nessun oggetto nel file: il pezzo è ciò che fanno i suoi cordoni</translation>
    </message>
    <message>
        <source>not a program of this job</source>
        <translation>non è un programma di questo lavoro</translation>
    </message>
    <message>
        <source>not the head of a function without arguments</source>
        <translation>non è l&apos;intestazione di una funzione senza argomenti</translation>
    </message>
    <message>
        <source>nothing is printed from there on</source>
        <translation>da lì in poi non si stampa nulla</translation>
    </message>
    <message>
        <source>of {count} sets of tool-paths the first was taken</source>
        <translation>di {count} insiemi di percorsi è stato preso il primo</translation>
    </message>
    <message>
        <source>only the flow at a motion&apos;s beginning is read</source>
        <translation>si legge solo il flusso all&apos;inizio di un movimento</translation>
    </message>
    <message>
        <source>take the program of the cell&apos;s own controller</source>
        <translation>usare il programma del controllore della cella</translation>
    </message>
    <message>
        <source>the arm is told to carry {mass:.2f} kg, some {planned:.2f} kg are planned</source>
        <translation>al braccio è dichiarato un carico di {mass:.2f} kg, ne sono previsti circa {planned:.2f} kg</translation>
    </message>
    <message>
        <source>the beads are thinner than can be filled with cells</source>
        <translation>i cordoni sono troppo sottili per essere riempiti di celle</translation>
    </message>
    <message>
        <source>the beads reach too far to be filled with cells</source>
        <translation>i cordoni si estendono troppo per essere riempiti di celle</translation>
    </message>
    <message>
        <source>the build&apos;s tool-paths {id} are not there</source>
        <translation>i percorsi {id} della costruzione non ci sono</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is given twice</source>
        <translation>il fattore «{factor}» è dato due volte</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is not within 0 and 1</source>
        <translation>il fattore «{factor}» non è tra 0 e 1</translation>
    </message>
    <message>
        <source>the file begins with a byte-order mark: save it as plain text</source>
        <translation>il file inizia con un BOM: salvarlo come testo semplice</translation>
    </message>
    <message numerus="yes">
        <source>the file does not say how wide, high or fast {points} points of its tool-paths are printed: taken from process {process}</source>
        <translation>
            <numerusform>il file non dice larghezza, altezza o velocità di {points} punto dei suoi percorsi: prese dal processo {process}</numerusform>
            <numerusform>il file non dice larghezza, altezza o velocità di {points} punti dei suoi percorsi: prese dal processo {process}</numerusform>
        </translation>
    </message>
    <message>
        <source>the first motion, from wherever the arm stands, is a fast one</source>
        <translation>il primo moto, da dovunque si trovi il braccio, è veloce</translation>
    </message>
    <message>
        <source>the frames of tool-paths look into the part; taken the other way round</source>
        <translation>i riferimenti dei percorsi guardano dentro il pezzo; presi al contrario</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is defined twice</source>
        <translation>la funzione «{defined}» è definita due volte</translation>
    </message>
    <message>
        <source>the job has no program that a line could be of</source>
        <translation>il lavoro non ha un programma a cui la riga possa appartenere</translation>
    </message>
    <message>
        <source>the job holds no motion to take up</source>
        <translation>il lavoro non contiene un moto da riprendere</translation>
    </message>
    <message>
        <source>the layer &apos;{path}&apos; is not related to the model</source>
        <translation>lo strato «{path}» non è collegato al modello</translation>
    </message>
    <message>
        <source>the layer &apos;{path}&apos; is there twice</source>
        <translation>lo strato «{path}» c&apos;è due volte</translation>
    </message>
    <message>
        <source>the part as it stands</source>
        <translation>il pezzo così com&apos;è</translation>
    </message>
    <message>
        <source>the part {id} of a segment is not in its layer</source>
        <translation>la parte {id} di un segmento non è nel suo strato</translation>
    </message>
    <message>
        <source>the profile &apos;{uuid}&apos; is not in the model</source>
        <translation>il profilo «{uuid}» non è nel modello</translation>
    </message>
    <message>
        <source>the profile &apos;{uuid}&apos; is there twice</source>
        <translation>il profilo «{uuid}» c&apos;è due volte</translation>
    </message>
    <message>
        <source>the profile {id} of a segment is not in its layer</source>
        <translation>il profilo {id} di un segmento non è nel suo strato</translation>
    </message>
    <message>
        <source>the robot holds the tool or the work object, one of them</source>
        <translation>il robot tiene l&apos;utensile o l&apos;oggetto di lavoro, uno dei due</translation>
    </message>
    <message>
        <source>the support points of a modifier do not rise between 0 and 1</source>
        <translation>i punti d&apos;appoggio di un modificatore non crescono tra 0 e 1</translation>
    </message>
    <message>
        <source>the tool-paths that came with the part are damaged</source>
        <translation>i percorsi giunti col pezzo sono danneggiati</translation>
    </message>
    <message>
        <source>the unit &apos;{unit}&apos; is not known</source>
        <translation>l&apos;unità «{unit}» è sconosciuta</translation>
    </message>
    <message>
        <source>the {format} program, for another controller, is not handed over: {failed}</source>
        <translation>il programma {format}, per un altro controllore, non viene consegnato: {failed}</translation>
    </message>
    <message>
        <source>there is no bead {bead}; the plan has {beads}</source>
        <translation>non c&apos;è il cordone {bead}; il piano ne ha {beads}</translation>
    </message>
    <message>
        <source>this motion is told to speed up {times:.1f} times as hard as planned</source>
        <translation>a questo moto è chiesta un&apos;accelerazione {times:.1f} volte quella prevista</translation>
    </message>
    <message>
        <source>tool-paths of a file are printed in the size that it gives</source>
        <translation>i percorsi di un file si stampano nella misura che esso dà</translation>
    </message>
    <message>
        <source>tool-paths of the file</source>
        <translation>percorsi del file</translation>
    </message>
    <message>
        <source>two modifiers of &apos;{attribute}&apos; or by one factor</source>
        <translation>due modificatori di «{attribute}» o con un solo fattore</translation>
    </message>
    <message>
        <source>unpacks to more than it can mean</source>
        <translation>si espande più di quanto possa significare</translation>
    </message>
    <message>
        <source>unparsed text in a layer&apos;s data</source>
        <translation>testo non analizzato nei dati di uno strato</translation>
    </message>
    <message>
        <source>unparsed text in a tool-path&apos;s data</source>
        <translation>testo non analizzato nei dati di un percorso</translation>
    </message>
    <message>
        <source>waits before and after tool-paths are left out</source>
        <translation>le attese prima e dopo i percorsi sono tralasciate</translation>
    </message>
    <message>
        <source>write a build file</source>
        <translation>scrivi un file di costruzione</translation>
    </message>
    <message>
        <source>write a proof of each program</source>
        <translation>scrivi una prova per ogni programma</translation>
    </message>
    <message>
        <source>write the program again: with times instead of speeds where the format knows them</source>
        <translation>scrivere di nuovo il programma: con tempi al posto di velocità dove il formato li conosce</translation>
    </message>
    <message>
        <source>{celsius} °C is no heat to print {material} with</source>
        <translation>{celsius} °C non è una temperatura per stampare {material}</translation>
    </message>
    <message>
        <source>{length:.0f} of filament are drawn back: out of the hot end</source>
        <translation>{length:.0f} di filamento ritratti: fuori dall&apos;ugello</translation>
    </message>
    <message>
        <source>{part}: proof of the {format} program</source>
        <translation>{part}: prova del programma {format}</translation>
    </message>
    <message>
        <source>{place}: no way leads from home to where the print is to go on, clear of what is printed by then</source>
        <translation>{place}: nessuna via porta dalla posizione di riposo a dove la stampa deve riprendere, libera da ciò che è già stampato</translation>
    </message>
    <message numerus="yes">
        <source>{points} points of the file&apos;s tool-paths ask for more than the extruder&apos;s {limit}: printed slower</source>
        <translation>
            <numerusform>{points} punto dei percorsi del file chiede più dei {limit} dell&apos;estrusore: stampato più lentamente</numerusform>
            <numerusform>{points} punti dei percorsi del file chiedono più dei {limit} dell&apos;estrusore: stampati più lentamente</numerusform>
        </translation>
    </message>
    <message>
        <source>{volume:.3f} are pushed out before the first bead, planned are {planned:.3f}</source>
        <translation>prima del primo cordone escono {volume:.3f}, ne sono previsti {planned:.3f}</translation>
    </message>
    <message>
        <source>{volume:.3f} flow out here while the nozzle stands for {time:.3f}</source>
        <translation>qui escono {volume:.3f} mentre l&apos;ugello sta fermo per {time:.3f}</translation>
    </message>
    <message>
        <source>$APO.CDIS is not set before this motion</source>
        <translation>$APO.CDIS non è impostato prima di questo movimento</translation>
    </message>
    <message>
        <source>$IPO_MODE is #BASE or #TCP</source>
        <translation>$IPO_MODE è #BASE o #TCP</translation>
    </message>
    <message>
        <source>$VEL.CP is not set before this motion</source>
        <translation>$VEL.CP non è impostato prima di questo movimento</translation>
    </message>
    <message>
        <source>&apos;ChangeTCP&apos; between PVTEnter and PVTExit</source>
        <translation>&apos;ChangeTCP&apos; fra PVTEnter e PVTExit</translation>
    </message>
    <message>
        <source>&apos;Cnt&apos; is 0, or 1 with two distances</source>
        <translation>&apos;Cnt&apos; è 0, oppure 1 con due distanze</translation>
    </message>
    <message>
        <source>&apos;Dly&apos; needs its seconds</source>
        <translation>&apos;Dly&apos; vuole i suoi secondi</translation>
    </message>
    <message>
        <source>&apos;EMvs&apos; needs its work coordinates, 1 to 8</source>
        <translation>&apos;EMvs&apos; vuole le sue coordinate di lavoro, da 1 a 8</translation>
    </message>
    <message>
        <source>&apos;Mvs&apos; and &apos;EMvs&apos; in one program: which of them moves the nozzle?</source>
        <translation>&apos;Mvs&apos; ed &apos;EMvs&apos; nello stesso programma: quale dei due muove l&apos;ugello?</translation>
    </message>
    <message>
        <source>&apos;PTP&apos; by millimetres a second</source>
        <translation>&apos;PTP&apos; in millimetri al secondo</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; takes 0, joints, or 1, poses</source>
        <translation>&apos;PVTEnter&apos; vuole 0, giunti, oppure 1, pose</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; without PVTExit before it</source>
        <translation>&apos;PVTEnter&apos; senza PVTExit prima</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; is missing before the end</source>
        <translation>&apos;PVTExit&apos; manca prima della fine</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; without PVTEnter before it</source>
        <translation>&apos;PVTExit&apos; senza PVTEnter prima</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; needs six positions, six velocities and its seconds</source>
        <translation>&apos;PVTPoint&apos; vuole sei posizioni, sei velocità e i suoi secondi</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; with a time or a velocity that makes no sense</source>
        <translation>&apos;PVTPoint&apos; con un tempo o una velocità senza senso</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; without PVTEnter before it</source>
        <translation>&apos;PVTPoint&apos; senza PVTEnter prima</translation>
    </message>
    <message>
        <source>&apos;Wth&apos; with what is no output</source>
        <translation>&apos;Wth&apos; con qualcosa che non è un&apos;uscita</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; without a sensible value</source>
        <translation>&apos;{name}&apos; senza un valore sensato</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is a frame that only the controller knows</source>
        <translation>&apos;{word}&apos; è un riferimento che solo il controllore conosce</translation>
    </message>
    <message>
        <source>A motion that the plan makes in less than {time} ms takes as long, and its flow is as much less.</source>
        <translation>Un movimento che il piano compie in meno di {time} ms dura altrettanto, e il suo flusso cala in proporzione.</translation>
    </message>
    <message>
        <source>Corners are passed without a stop, as if rounded by an arc {distance:.3g} beside them.</source>
        <translation>Gli spigoli si passano senza sosta, come arrotondati da un arco a {distance:.3g} da essi.</translation>
    </message>
    <message>
        <source>E1 is missing: an external axis moves the base</source>
        <translation>Manca E1: un asse esterno muove la base</translation>
    </message>
    <message>
        <source>ENDDAT is missing: the file was cut short</source>
        <translation>Manca ENDDAT: il file è stato troncato</translation>
    </message>
    <message>
        <source>G-code with B and C (a table that tilts and turns)</source>
        <translation>G-code con B e C (una tavola che si inclina e gira)</translation>
    </message>
    <message>
        <source>G-code with B and C: how far the plate&apos;s centre stands beside the axis that the table tilts about, along X.</source>
        <translation>G-code con B e C: quanto il centro del piatto sta di lato all&apos;asse di inclinazione della tavola, lungo X.</translation>
    </message>
    <message>
        <source>G-code with B and C: how far the plate&apos;s top lies above the axis that the table tilts about.</source>
        <translation>G-code con B e C: quanto la faccia del piatto sta sopra l&apos;asse di inclinazione della tavola.</translation>
    </message>
    <message>
        <source>G-code with B and C: whether B and C are the right-handed turn of the part, or that of the tool about a part that stands.</source>
        <translation>G-code con B e C: se B e C sono la rotazione destrorsa del pezzo, o quella dell&apos;utensile attorno a un pezzo fermo.</translation>
    </message>
    <message>
        <source>Joint speeds are told in percent: all of it is taken for 180 degrees/s, and those travels&apos; times are estimates.</source>
        <translation>Le velocità dei giunti sono in percentuale: il cento per cento si prende per 180 gradi/s, e i tempi di quegli spostamenti sono stime.</translation>
    </message>
    <message>
        <source>Joints speed up at {acceleration:.0f}/s2 where the text says nothing else.</source>
        <translation>I giunti accelerano a {acceleration:.0f}/s2 dove il testo non dice altro.</translation>
    </message>
    <message>
        <source>KRL (KUKA)</source>
        <translation>KRL (KUKA)</translation>
    </message>
    <message>
        <source>KRL memory</source>
        <translation>memoria KRL</translation>
    </message>
    <message>
        <source>MELFA-BASIC V (Mitsubishi)</source>
        <translation>MELFA-BASIC V (Mitsubishi)</translation>
    </message>
    <message>
        <source>Motions speed up as their text says, and at once where it says nothing.</source>
        <translation>I movimenti accelerano come dice il testo, e di colpo dove non dice nulla.</translation>
    </message>
    <message>
        <source>No motion is shorter than the controller&apos;s cycle of {cycle} ms.</source>
        <translation>Nessun movimento dura meno del ciclo del controllore, {cycle} ms.</translation>
    </message>
    <message>
        <source>None of this was tried on a machine: begin slowly, with the extruder cold.</source>
        <translation>Nulla di ciò è stato provato su una macchina: cominciare piano, con l&apos;estrusore freddo.</translation>
    </message>
    <message>
        <source>Plain G-code (three axes, flat jobs)</source>
        <translation>G-code semplice (tre assi, lavori piani)</translation>
    </message>
    <message>
        <source>Points of a bead nearer than {time} ms or {way} are joined where the bead stays the same.</source>
        <translation>I punti di un cordone più vicini di {time} ms o {way} si uniscono dove il cordone resta lo stesso.</translation>
    </message>
    <message>
        <source>Power Low holds the speed down: Power High is missing</source>
        <translation>Power Low tiene bassa la velocità: manca Power High</translation>
    </message>
    <message>
        <source>ROT where the tool does not turn</source>
        <translation>ROT dove l&apos;utensile non gira</translation>
    </message>
    <message>
        <source>Room for programs on the controller: a longer one says so in its head.</source>
        <translation>Spazio per i programmi nel controllore: uno più lungo lo dice in testa.</translation>
    </message>
    <message>
        <source>SPEL+ (Epson)</source>
        <translation>SPEL+ (Epson)</translation>
    </message>
    <message>
        <source>ScriptExit() is missing at the end</source>
        <translation>Manca ScriptExit() alla fine</translation>
    </message>
    <message>
        <source>Straight motions speed up at {acceleration} mm/s2 where the text says nothing else.</source>
        <translation>I movimenti rettilinei accelerano a {acceleration} mm/s2 dove il testo non dice altro.</translation>
    </message>
    <message>
        <source>TMscript (Techman)</source>
        <translation>TMscript (Techman)</translation>
    </message>
    <message>
        <source>The arm stands where a motion has no blend.</source>
        <translation>Il braccio si ferma dove un movimento non ha raccordo.</translation>
    </message>
    <message>
        <source>The controller looks as far ahead as it has to.</source>
        <translation>Il controllore guarda avanti quanto serve.</translation>
    </message>
    <message>
        <source>The controller looks {motions} motions ahead.</source>
        <translation>Il controllore guarda avanti di {motions} movimenti.</translation>
    </message>
    <message>
        <source>The time that outputs take, and how the arm lags behind, are not counted.</source>
        <translation>Il tempo che prendono le uscite e il ritardo del braccio non sono contati.</translation>
    </message>
    <message>
        <source>The turn of the tool may have a limit of its own, a radian as long as {way:.0f} of way: of both laws the worse counts for the flow.</source>
        <translation>La rotazione dell&apos;utensile può avere un limite proprio, un radiante lungo quanto {way:.0f} di percorso: per il flusso vale la peggiore delle due leggi.</translation>
    </message>
    <message>
        <source>WAIT SEC needs its seconds</source>
        <translation>WAIT SEC vuole i suoi secondi</translation>
    </message>
    <message>
        <source>Wait needs its seconds</source>
        <translation>Wait vuole i suoi secondi</translation>
    </message>
    <message>
        <source>a G0 under G93: nobody knows how long it takes</source>
        <translation>un G0 sotto G93: nessuno sa quanto duri</translation>
    </message>
    <message>
        <source>a base other than the robot&apos;s own: write positions in that</source>
        <translation>una base diversa da quella del robot: scrivere le posizioni in quella</translation>
    </message>
    <message>
        <source>a base that only the robot knows: write its numbers</source>
        <translation>una base che solo il robot conosce: scriverne i numeri</translation>
    </message>
    <message>
        <source>a blend is no sensible number</source>
        <translation>un raccordo che non è un numero sensato</translation>
    </message>
    <message>
        <source>a call of another program that cannot be followed</source>
        <translation>una chiamata di un altro programma che non si può seguire</translation>
    </message>
    <message>
        <source>a coordinate is missing, and it is not known where the arm stands</source>
        <translation>manca una coordinata, e non si sa dove sia il braccio</translation>
    </message>
    <message>
        <source>a flow that is no whole number from 0 to {most}</source>
        <translation>un flusso che non è un numero intero da 0 a {most}</translation>
    </message>
    <message>
        <source>a frame of another length than it says</source>
        <translation>un pacchetto lungo diversamente da quanto dice</translation>
    </message>
    <message>
        <source>a frame that is no script for a listen node</source>
        <translation>un pacchetto che non è uno script per un nodo di ascolto</translation>
    </message>
    <message>
        <source>a frame whose checksum is wrong: it was changed or cut</source>
        <translation>un pacchetto con la somma di controllo sbagliata: è stato cambiato o troncato</translation>
    </message>
    <message>
        <source>a frame without its length</source>
        <translation>un pacchetto senza la sua lunghezza</translation>
    </message>
    <message>
        <source>a frame without its name</source>
        <translation>un pacchetto senza il suo nome</translation>
    </message>
    <message>
        <source>a load needs its mass</source>
        <translation>un carico vuole la sua massa</translation>
    </message>
    <message>
        <source>a mass is no sensible number</source>
        <translation>una massa che non è un numero sensato</translation>
    </message>
    <message>
        <source>a motion of its own between PVTEnter and PVTExit</source>
        <translation>un movimento a sé fra PVTEnter e PVTExit</translation>
    </message>
    <message>
        <source>a motion that only turns needs ROT</source>
        <translation>un movimento che gira soltanto vuole ROT</translation>
    </message>
    <message>
        <source>a motion without F: under G93 each has its own</source>
        <translation>un movimento senza F: sotto G93 ognuno ha la sua</translation>
    </message>
    <message>
        <source>a motion without G93: its F is no time</source>
        <translation>un movimento senza G93: la sua F non è un tempo</translation>
    </message>
    <message>
        <source>a motion&apos;s numbers are not those that its letters say</source>
        <translation>i numeri di un movimento non sono quelli che dicono le sue lettere</translation>
    </message>
    <message>
        <source>a pose before ChangeTCP: whose pose is it?</source>
        <translation>una posa prima di ChangeTCP: di chi è?</translation>
    </message>
    <message>
        <source>a position before Tool: whose is it?</source>
        <translation>una posizione prima di Tool: di chi è?</translation>
    </message>
    <message>
        <source>a step of more than 127 characters</source>
        <translation>un passo di più di 127 caratteri</translation>
    </message>
    <message>
        <source>a straight motion before any Spd</source>
        <translation>un movimento rettilineo prima di ogni Spd</translation>
    </message>
    <message>
        <source>a straight motion by per cent of a speed that is not known</source>
        <translation>un movimento rettilineo in percentuale di una velocità non nota</translation>
    </message>
    <message>
        <source>a straight motion to joints</source>
        <translation>un movimento rettilineo verso valori dei giunti</translation>
    </message>
    <message>
        <source>a target that is no position in a robot&apos;s reach</source>
        <translation>un bersaglio che non è una posizione alla portata di un robot</translation>
    </message>
    <message>
        <source>a text has {characters} characters; its controller takes {most}</source>
        <translation>un testo ha {characters} caratteri; il suo controllore ne accetta {most}</translation>
    </message>
    <message>
        <source>a tool is a position</source>
        <translation>un utensile è una posizione</translation>
    </message>
    <message>
        <source>a tool that only the robot knows: write its numbers</source>
        <translation>un utensile che solo il robot conosce: scriverne i numeri</translation>
    </message>
    <message>
        <source>a tool, local or control point that only the controller knows</source>
        <translation>un utensile, un riferimento locale o un punto di controllo che solo il controllore conosce</translation>
    </message>
    <message>
        <source>accelerations other than the arm&apos;s own</source>
        <translation>accelerazioni diverse da quelle del braccio</translation>
    </message>
    <message>
        <source>an acceleration is no sensible number</source>
        <translation>un&apos;accelerazione che non è un numero sensato</translation>
    </message>
    <message>
        <source>an analogue output outside 0 to 10 V</source>
        <translation>un&apos;uscita analogica fuori da 0 a 10 V</translation>
    </message>
    <message>
        <source>an angle goes the long way round</source>
        <translation>un angolo fa il giro lungo</translation>
    </message>
    <message>
        <source>an output at once, not where the motions are</source>
        <translation>un&apos;uscita immediata, non dove sono i movimenti</translation>
    </message>
    <message>
        <source>an output behind CONTINUE runs ahead of the arm</source>
        <translation>un&apos;uscita dopo CONTINUE precede il braccio</translation>
    </message>
    <message>
        <source>an output is 0 or 1</source>
        <translation>un&apos;uscita è 0 o 1</translation>
    </message>
    <message>
        <source>an output of the extruder&apos;s among others</source>
        <translation>un&apos;uscita dell&apos;estrusore in mezzo ad altre</translation>
    </message>
    <message>
        <source>axes are no target of a straight motion</source>
        <translation>gli assi non sono bersaglio di un movimento rettilineo</translation>
    </message>
    <message>
        <source>format {format} cannot lean the nozzle: this job leans it by {angle}</source>
        <translation>il formato {format} non può inclinare l&apos;ugello: questo lavoro lo inclina di {angle}</translation>
    </message>
    <message>
        <source>how &apos;{word}&apos; rounds a corner is not known to the reader</source>
        <translation>come &apos;{word}&apos; arrotondi uno spigolo non è noto al lettore</translation>
    </message>
    <message>
        <source>joints of a straight motion may be reached in another posture</source>
        <translation>i giunti di un movimento rettilineo si possono raggiungere in un&apos;altra postura</translation>
    </message>
    <message>
        <source>leave it out, or give --format {format}</source>
        <translation>ometterla, oppure dare --format {format}</translation>
    </message>
    <message>
        <source>lines end with LF alone: a listen node takes CR LF</source>
        <translation>le righe finiscono col solo LF: un nodo di ascolto vuole CR LF</translation>
    </message>
    <message>
        <source>material before X, Y and Z are all known</source>
        <translation>materiale prima che X, Y e Z siano tutti noti</translation>
    </message>
    <message>
        <source>material before X, Y, Z, B and C are all known</source>
        <translation>materiale prima che X, Y, Z, B e C siano tutti noti</translation>
    </message>
    <message>
        <source>must be 1 or -1</source>
        <translation>deve essere 1 o -1</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>deve essere true o false</translation>
    </message>
    <message>
        <source>no motion of format {format} is in it: line {line}: {what}</source>
        <translation>non contiene alcun movimento del formato {format}: riga {line}: {what}</translation>
    </message>
    <message>
        <source>no procedure is defined</source>
        <translation>nessuna procedura è definita</translation>
    </message>
    <message>
        <source>no program calls this file</source>
        <translation>nessun programma chiama questo file</translation>
    </message>
    <message>
        <source>not all axes are given</source>
        <translation>non tutti gli assi sono dati</translation>
    </message>
    <message>
        <source>not understood: where the plate is over the tilt axis</source>
        <translation>non capito: dove sta il piatto sopra l&apos;asse di inclinazione</translation>
    </message>
    <message>
        <source>nothing begins that ends here</source>
        <translation>non comincia nulla che finisca qui</translation>
    </message>
    <message>
        <source>nothing of this file is run</source>
        <translation>nulla di questo file viene eseguito</translation>
    </message>
    <message>
        <source>only a trigger at a motion&apos;s beginning is read</source>
        <translation>si legge solo un trigger all&apos;inizio di un movimento</translation>
    </message>
    <message>
        <source>only an output that stays as it is set is read</source>
        <translation>si legge solo un&apos;uscita che resta come è impostata</translation>
    </message>
    <message>
        <source>other work coordinates than before: a second nozzle</source>
        <translation>coordinate di lavoro diverse da prima: un secondo ugello</translation>
    </message>
    <message>
        <source>part {part}, job {job}, cell {cell} with robot {robot}</source>
        <translation>pezzo {part}, lavoro {job}, cella {cell} con robot {robot}</translation>
    </message>
    <message>
        <source>plate above the tilt axis</source>
        <translation>piatto sopra l&apos;asse di inclinazione</translation>
    </message>
    <message>
        <source>plate beside the tilt axis</source>
        <translation>piatto a lato dell&apos;asse di inclinazione</translation>
    </message>
    <message>
        <source>speed, time to reach it and blend are whole numbers</source>
        <translation>velocità, tempo per raggiungerla e raccordo sono numeri interi</translation>
    </message>
    <message>
        <source>step numbers ascend, to 32767 at most</source>
        <translation>i numeri di passo crescono, fino a 32767 al massimo</translation>
    </message>
    <message>
        <source>straight is the tool&apos;s way or the external control point&apos;s, not both</source>
        <translation>rettilineo è il percorso dell&apos;utensile o quello del punto di controllo esterno, non entrambi</translation>
    </message>
    <message>
        <source>table&apos;s angles turn</source>
        <translation>gli angoli della tavola girano</translation>
    </message>
    <message>
        <source>take {formats}, or a mode with flat layers</source>
        <translation>prendere {formats}, oppure un modo a strati piani</translation>
    </message>
    <message>
        <source>text behind a frame</source>
        <translation>testo dopo un pacchetto</translation>
    </message>
    <message>
        <source>the last point of PVT has a velocity</source>
        <translation>l&apos;ultimo punto di PVT ha una velocità</translation>
    </message>
    <message>
        <source>the line has {characters} characters; its controller takes {most}</source>
        <translation>la riga ha {characters} caratteri; il suo controllore ne accetta {most}</translation>
    </message>
    <message>
        <source>the long way round, or angles turned by themselves</source>
        <translation>il giro lungo, oppure angoli girati da soli</translation>
    </message>
    <message>
        <source>the nozzle goes over the plate before the table stands: B and C are not known</source>
        <translation>l&apos;ugello va sopra il piatto prima che la tavola sia ferma: B e C non sono noti</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>il pezzo</translation>
    </message>
    <message>
        <source>the procedure has no end</source>
        <translation>la procedura non ha fine</translation>
    </message>
    <message>
        <source>the program has no End</source>
        <translation>il programma non ha End</translation>
    </message>
    <message>
        <source>the program says that it is for another cell: {program}; this job is {job}</source>
        <translation>il programma dice di essere per un&apos;altra cella: {program}; questo lavoro è {job}</translation>
    </message>
    <message>
        <source>the program says that it is of another job: {program}; this job is {job}</source>
        <translation>il programma dice di essere di un altro lavoro: {program}; questo lavoro è {job}</translation>
    </message>
    <message>
        <source>the program {name} is not here</source>
        <translation>il programma {name} non è qui</translation>
    </message>
    <message>
        <source>the table turns before the nozzle is up: Z is not known yet</source>
        <translation>la tavola gira prima che l&apos;ugello sia in alto: Z non è ancora noto</translation>
    </message>
    <message>
        <source>the tool (ISO 841)</source>
        <translation>l&apos;utensile (ISO 841)</translation>
    </message>
    <message>
        <source>the tool does not turn evenly along its way</source>
        <translation>l&apos;utensile non gira in modo uniforme lungo il percorso</translation>
    </message>
    <message>
        <source>the velocities lead off the way to this point</source>
        <translation>le velocità portano fuori dal percorso verso questo punto</translation>
    </message>
    <message>
        <source>work coordinates that P_WkCord does not set</source>
        <translation>coordinate di lavoro che P_WkCord non imposta</translation>
    </message>
    <message>
        <source>{frame} is not set before this motion</source>
        <translation>{frame} non è impostato prima di questo movimento</translation>
    </message>
    <message>
        <source>{option} is an option of {having}; written are {formats}</source>
        <translation>{option} è un&apos;opzione di {having}; si scrivono {formats}</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is missing</source>
        <translation>manca &apos;{attribute}&apos;</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is no three numbers: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; non è fatto di tre numeri: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>expand it first: xacro FILE &gt; arm.urdf</source>
        <translation>espanderlo prima: xacro FILE &gt; arm.urdf</translation>
    </message>
    <message>
        <source>from &apos;{base}&apos; to &apos;{tip}&apos; {count} axes turn; six are needed</source>
        <translation>da &apos;{base}&apos; a &apos;{tip}&apos; girano {count} assi; ne servono sei</translation>
    </message>
    <message>
        <source>give the cell another home; where only the shapes that enclose two links overlap, list the pair under neverMeet in the robot&apos;s file</source>
        <translation>dare alla cella un&apos;altra posizione di riposo; dove si sovrappongono solo le forme che racchiudono due membri, elencare la coppia sotto neverMeet nel file del robot</translation>
    </message>
    <message>
        <source>has no links</source>
        <translation>non ha membri</translation>
    </message>
    <message>
        <source>has no tip: no joint moves</source>
        <translation>non ha punta: nessun giunto si muove</translation>
    </message>
    <message>
        <source>has several tips: {names}</source>
        <translation>ha più punte: {names}</translation>
    </message>
    <message>
        <source>has two bases, &apos;{first}&apos; and &apos;{second}&apos;: no joint leads from one to the other</source>
        <translation>ha due basi, &apos;{first}&apos; e &apos;{second}&apos;: nessun giunto porta dall&apos;una all&apos;altra</translation>
    </message>
    <message>
        <source>is a xacro file</source>
        <translation>è un file xacro</translation>
    </message>
    <message>
        <source>is no URDF: it begins with &lt;{element}&gt;</source>
        <translation>non è un URDF: comincia con &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; follows &apos;{other}&apos; (mimic), which is not taken</source>
        <translation>il giunto &apos;{joint}&apos; segue &apos;{other}&apos; (mimic), che non si accetta</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an axis of no length</source>
        <translation>il giunto &apos;{joint}&apos; ha un asse senza lunghezza</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has its lower limit not below its upper</source>
        <translation>il giunto &apos;{joint}&apos; ha il limite inferiore non sotto il superiore</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; is of no type that is known: &apos;{type}&apos;</source>
        <translation>il giunto &apos;{joint}&apos; non è di un tipo noto: &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; is {type}; only joints that turn are taken</source>
        <translation>il giunto &apos;{joint}&apos; è {type}; si accettano solo giunti che girano</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; names a link that is not there: &apos;{link}&apos;</source>
        <translation>il giunto &apos;{joint}&apos; nomina un membro che non c&apos;è: &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; hangs on two joints, &apos;{first}&apos; and &apos;{second}&apos;: a loop, which is not taken</source>
        <translation>il membro &apos;{link}&apos; è appeso a due giunti, &apos;{first}&apos; e &apos;{second}&apos;: un anello, che non si accetta</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; is on a loop, which is not taken</source>
        <translation>il membro &apos;{link}&apos; è su un anello, che non si accetta</translation>
    </message>
    <message>
        <source>name one: --tip</source>
        <translation>nominarne una: --tip</translation>
    </message>
    <message>
        <source>name the links between which they are: --base, --tip</source>
        <translation>nominare i membri fra cui si trovano: --base, --tip</translation>
    </message>
    <message>
        <source>the base &apos;{base}&apos; moves beside the way to &apos;{tip}&apos;</source>
        <translation>la base &apos;{base}&apos; si muove fuori dalla via verso &apos;{tip}&apos;</translation>
    </message>
    <message>
        <source>two links are named &apos;{link}&apos;</source>
        <translation>due membri si chiamano &apos;{link}&apos;</translation>
    </message>
    <message>
        <source>{first} meets {second} where the arm rests: nothing can be moved</source>
        <translation>{first} tocca {second} dove il braccio riposa: nulla si può muovere</translation>
    </message>
    <message>
        <source>{option}: no link is named &apos;{name}&apos;</source>
        <translation>{option}: nessun membro si chiama &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>A file node of PolyScope needs the function to be called behind its end; text that is sent to port 30001 or 30002 runs by itself and must not call it.</source>
        <translation>Un nodo file di PolyScope vuole che la funzione sia chiamata dopo la sua fine; un testo mandato alla porta 30001 o 30002 parte da solo e non deve chiamarla.</translation>
    </message>
    <message>
        <source>a file node</source>
        <translation>un nodo file</translation>
    </message>
    <message>
        <source>a port</source>
        <translation>una porta</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no text that the extruder takes</source>
        <translation>&apos;{text}&apos; non è un testo che l&apos;estrusore accetta</translation>
    </message>
    <message>
        <source>As an ordinary printer does, the nozzle upright throughout</source>
        <translation>Come una comune stampante, l&apos;ugello sempre verticale</translation>
    </message>
    <message>
        <source>For each travel, where the extruder can; 0: stays as it is.</source>
        <translation>A ogni spostamento, se l&apos;estrusore può; 0: resta com&apos;è.</translation>
    </message>
    <message>
        <source>How the nozzle is filled before the part begins: on the plate, or in the air beside it where it has no room. It is waste.</source>
        <translation>Come si riempie l&apos;ugello prima che il pezzo cominci: sul piatto, o in aria accanto dove non c&apos;è posto. È scarto.</translation>
    </message>
    <message>
        <source>Of the line beside the part.</source>
        <translation>Della linea accanto al pezzo.</translation>
    </message>
    <message>
        <source>Print in flat layers</source>
        <translation>Stampa a strati piani</translation>
    </message>
    <message>
        <source>a filament of no sensible diameter</source>
        <translation>un filamento di diametro senza senso</translation>
    </message>
    <message>
        <source>a line beside the part</source>
        <translation>una linea accanto al pezzo</translation>
    </message>
    <message>
        <source>a motion is missing in the stream of filament, or comes twice</source>
        <translation>nel flusso di filamento manca un movimento, o ce n&apos;è uno due volte</translation>
    </message>
    <message>
        <source>a ring round the part</source>
        <translation>un anello attorno al pezzo</translation>
    </message>
    <message>
        <source>a text to be sent is needed</source>
        <translation>serve un testo da inviare</translation>
    </message>
    <message>
        <source>an external axis behind one that is not used is not read</source>
        <translation>un asse esterno dietro a uno non usato non viene letto</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>estrusore</translation>
    </message>
    <message>
        <source>filament drawn back</source>
        <translation>filamento ritirato</translation>
    </message>
    <message>
        <source>filament runs back</source>
        <translation>il filamento torna indietro</translation>
    </message>
    <message>
        <source>format {format} has no words for extruder {extruder} that keep step with the motion</source>
        <translation>il formato {format} non ha parole per l&apos;estrusore {extruder} al passo col movimento</translation>
    </message>
    <message>
        <source>has a name that is taken already: &apos;{name}&apos;</source>
        <translation>ha un nome già preso: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>has minMm not below maxMm</source>
        <translation>ha minMm non inferiore a maxMm</translation>
    </message>
    <message>
        <source>length of the prime</source>
        <translation>lunghezza dell&apos;innesco</translation>
    </message>
    <message>
        <source>must be empty: the plate is on the flange</source>
        <translation>deve essere vuoto: il piatto è sulla flangia</translation>
    </message>
    <message>
        <source>must be fewer: robot and axes are {most} at most</source>
        <translation>devono essere meno: robot e assi sono al più {most}</translation>
    </message>
    <message>
        <source>must be turning or sliding, is &apos;{kind}&apos;</source>
        <translation>deve essere turning o sliding, è &apos;{kind}&apos;</translation>
    </message>
    <message>
        <source>must have a direction</source>
        <translation>deve avere una direzione</translation>
    </message>
    <message>
        <source>must turn the rod about its own axis, the work frame&apos;s x</source>
        <translation>deve girare l&apos;asta attorno al suo asse, la x del riferimento di lavoro</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>innesco</translation>
    </message>
    <message>
        <source>take extruder {extruders}</source>
        <translation>usa l&apos;estrusore {extruders}</translation>
    </message>
    <message>
        <source>the extruder goes on or off where it cannot</source>
        <translation>l&apos;estrusore si accende o si spegne dove non può</translation>
    </message>
    <message>
        <source>the extruder runs back while the nozzle moves</source>
        <translation>l&apos;estrusore torna indietro mentre l&apos;ugello si muove</translation>
    </message>
    <message>
        <source>the extruder runs where the program does not stand</source>
        <translation>l&apos;estrusore gira dove il programma non sta fermo</translation>
    </message>
    <message>
        <source>the extruder runs where the program has it off</source>
        <translation>l&apos;estrusore gira dove il programma lo ha spento</translation>
    </message>
    <message>
        <source>the filament that was drawn back is not back</source>
        <translation>il filamento ritirato non è tornato</translation>
    </message>
    <message>
        <source>the file {file} begins with {procedure}: a module is called as its first procedure</source>
        <translation>il file {file} comincia con {procedure}: un modulo si chiama come la sua prima procedura</translation>
    </message>
    <message>
        <source>the stream of filament has no end: the file was cut short</source>
        <translation>il flusso di filamento non ha fine: il file è stato troncato</translation>
    </message>
    <message>
        <source>the stream of filament has nothing for this motion</source>
        <translation>il flusso di filamento non ha nulla per questo movimento</translation>
    </message>
    <message>
        <source>this arm keeps the nozzle upright, and the layers lean it, first at {place}</source>
        <translation>questo braccio tiene l&apos;ugello verticale, e gli strati lo inclinano, dapprima in {place}</translation>
    </message>
    <message>
        <source>time runs back in the stream of filament</source>
        <translation>nel flusso di filamento il tempo torna indietro</translation>
    </message>
    <message>
        <source>unknown extruder &apos;{id}&apos;</source>
        <translation>estrusore &apos;{id}&apos; sconosciuto</translation>
    </message>
    <message>
        <source>use mode flat, or planar with upright layers</source>
        <translation>usa la modalità flat, o planar con strati verticali</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}/s, its limit is {limit:.1f#}</source>
        <translation>{joint} a {speed:.1f}/s, il suo limite è {limit:.1f#}</translation>
    </message>
    <message>
        <source>Castelli serial</source>
        <translation>seriale Castelli</translation>
    </message>
    <message>
        <source>E stream</source>
        <translation>flusso E</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>uscite</translation>
    </message>
    <message>
        <source>the cell&apos;s</source>
        <translation>della cella</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is beyond all measure: &apos;{text}&apos;</source>
        <translation>&apos;{attribute}&apos; è fuori misura: &apos;{text}&apos;</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is a cell of the program&apos;s own</source>
        <translation>&apos;{id}&apos; è una cella del programma</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is no name of a cell</source>
        <translation>&apos;{id}&apos; non è un nome di cella</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is no number</source>
        <translation>&apos;{word}&apos; non è un numero</translation>
    </message>
    <message>
        <source>How turns about the nozzle are made smooth: quickly, or by a search for the least jerk of the joints, which takes as long again as the rest of the motion.</source>
        <translation>Come si rendono regolari le rotazioni attorno all&apos;ugello: in fretta, o cercando il minimo strappo dei giunti, che richiede altrettanto tempo del resto del moto.</translation>
    </message>
    <message>
        <source>Poses reached</source>
        <translation>Pose raggiunte</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, OFF, 3MF, COLLADA and glTF can be read</source>
        <translation>si leggono STL, OBJ, PLY, OFF, 3MF, COLLADA e glTF</translation>
    </message>
    <message>
        <source>a frame takes three points or more</source>
        <translation>un riferimento richiede almeno tre punti</translation>
    </message>
    <message>
        <source>a measured number is not finite</source>
        <translation>un numero misurato non è finito</translation>
    </message>
    <message>
        <source>a quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>la lunghezza di un quaternione è {length:.4g}, non 1</translation>
    </message>
    <message>
        <source>a robot named &apos;{id}&apos; comes along with the program</source>
        <translation>un robot di nome &apos;{id}&apos; è già nel programma</translation>
    </message>
    <message>
        <source>a row holds the robot&apos;s joints</source>
        <translation>una riga contiene i giunti del robot</translation>
    </message>
    <message>
        <source>a row holds x,y,z,qw,qx,qy,qz; for joints name the robot</source>
        <translation>una riga contiene x,y,z,qw,qx,qy,qz; per i giunti indica il robot</translation>
    </message>
    <message>
        <source>a tool tip takes four poses or more</source>
        <translation>la punta di un utensile richiede almeno quattro pose</translation>
    </message>
    <message>
        <source>at rest {first} meets {second}</source>
        <translation>a riposo {first} tocca {second}</translation>
    </message>
    <message>
        <source>bring plate and nozzle nearer to the arm</source>
        <translation>avvicina piatto e ugello al braccio</translation>
    </message>
    <message>
        <source>cannot be read: not a mesh, or damaged</source>
        <translation>illeggibile: non è una mesh, o è danneggiata</translation>
    </message>
    <message>
        <source>cannot be read: voluta-mesh-reader is missing beside this program</source>
        <translation>illeggibile: accanto a questo programma manca voluta-mesh-reader</translation>
    </message>
    <message>
        <source>cell {cell} has no plate to map</source>
        <translation>la cella {cell} non ha un piatto</translation>
    </message>
    <message>
        <source>evened out</source>
        <translation>livellate</translation>
    </message>
    <message>
        <source>give the arm another name: --id</source>
        <translation>dai un altro nome al braccio: --id</translation>
    </message>
    <message>
        <source>give three rows x,y,z (origin, on x, beside it), or three or more rows of six: a point in the frame, and where it was touched</source>
        <translation>dai tre righe x,y,z (origine, su x, di lato), o almeno tre righe di sei: un punto nel riferimento e dove è stato toccato</translation>
    </message>
    <message>
        <source>is damaged: reading it ended badly</source>
        <translation>è danneggiato: la lettura è finita male</translation>
    </message>
    <message>
        <source>least jerk of whole paths</source>
        <translation>minimo strappo di percorsi interi</translation>
    </message>
    <message>
        <source>leave out the row, or measure it again</source>
        <translation>togli la riga o rimisurala</translation>
    </message>
    <message>
        <source>lengths in a URDF are metres</source>
        <translation>in un URDF le lunghezze sono in metri</translation>
    </message>
    <message>
        <source>look through its limits and solids in the description, or name its links: --base, --tip</source>
        <translation>controlla limiti e solidi nella descrizione, o indica i link: --base, --tip</translation>
    </message>
    <message>
        <source>make it lighter, or take a stronger robot</source>
        <translation>alleggeriscilo, o prendi un robot più forte</translation>
    </message>
    <message>
        <source>measure another point</source>
        <translation>misura un altro punto</translation>
    </message>
    <message>
        <source>measure another pose</source>
        <translation>misura un&apos;altra posa</translation>
    </message>
    <message>
        <source>measure three points</source>
        <translation>misura tre punti</translation>
    </message>
    <message>
        <source>move one of them, or let the arm rest otherwise</source>
        <translation>sposta uno dei due, o cambia la posa di riposo</translation>
    </message>
    <message>
        <source>move one of them, or make the stem or the nozzle longer</source>
        <translation>sposta uno dei due, o allunga lo stelo o l&apos;ugello</translation>
    </message>
    <message>
        <source>move the nozzle&apos;s frame</source>
        <translation>sposta il riferimento dell&apos;ugello</translation>
    </message>
    <message>
        <source>no folder for cells of one&apos;s own</source>
        <translation>nessuna cartella per le celle proprie</translation>
    </message>
    <message>
        <source>no table of points</source>
        <translation>non è una tabella di punti</translation>
    </message>
    <message>
        <source>places for the plate</source>
        <translation>posti per il piatto</translation>
    </message>
    <message>
        <source>poses {first} and {second} are the same</source>
        <translation>le pose {first} e {second} sono uguali</translation>
    </message>
    <message>
        <source>set HOME, or VOLUTA_DATA to a folder</source>
        <translation>imposta HOME, o VOLUTA_DATA su una cartella</translation>
    </message>
    <message>
        <source>smooth turns</source>
        <translation>rotazioni regolari</translation>
    </message>
    <message>
        <source>take a cell with a plate</source>
        <translation>prendi una cella con un piatto</translation>
    </message>
    <message>
        <source>take a point well beside the line through the others</source>
        <translation>prendi un punto ben fuori dalla retta per gli altri</translation>
    </message>
    <message>
        <source>take another name</source>
        <translation>scegli un altro nome</translation>
    </message>
    <message>
        <source>takes too long to read</source>
        <translation>la lettura dura troppo</translation>
    </message>
    <message>
        <source>the arm reaches above a plate nowhere, clear of itself and the table (reach {reach} mm)</source>
        <translation>il braccio non arriva da nessuna parte sopra un piatto senza toccare sé stesso o il tavolo (sbraccio {reach} mm)</translation>
    </message>
    <message>
        <source>the arm reaches {reach} mm, which no arm does</source>
        <translation>il braccio arriverebbe a {reach} mm, come nessun braccio</translation>
    </message>
    <message>
        <source>the arm&apos;s description</source>
        <translation>la descrizione del braccio</translation>
    </message>
    <message>
        <source>the flange carries {carried:.3g} kg, the robot {most:.3g} kg</source>
        <translation>la flangia porta {carried:.3g} kg, il robot {most:.3g} kg</translation>
    </message>
    <message>
        <source>the nozzle is inside {body}</source>
        <translation>l&apos;ugello è dentro {body}</translation>
    </message>
    <message>
        <source>the plate is out of the arm&apos;s reach</source>
        <translation>il piatto è fuori dalla portata del braccio</translation>
    </message>
    <message>
        <source>the points lie on a line: the frame could turn about it</source>
        <translation>i punti stanno su una retta: il riferimento potrebbe ruotarle attorno</translation>
    </message>
    <message>
        <source>the poses turn the flange about one axis only, or hardly</source>
        <translation>le pose ruotano la flangia attorno a un solo asse, o quasi per nulla</translation>
    </message>
    <message>
        <source>tilt it by 30 degrees or more about two axes</source>
        <translation>inclinala di almeno 30 gradi attorno a due assi</translation>
    </message>
    <message>
        <source>turn the flange between one pose and the next</source>
        <translation>ruota la flangia tra una posa e la successiva</translation>
    </message>
    <message>
        <source>two of the three points are the same</source>
        <translation>due dei tre punti sono uguali</translation>
    </message>
    <message>
        <source>use letters, digits, dashes and dots</source>
        <translation>usa lettere, cifre, trattini e punti</translation>
    </message>
    <message>
        <source>where the head reaches</source>
        <translation>dove arriva la testa</translation>
    </message>
    <message>
        <source>wherever the nozzle gets to the plate, {first} meets {second}</source>
        <translation>ovunque l&apos;ugello arrivi al piatto, {first} tocca {second}</translation>
    </message>
    <message>
        <source>{found} numbers in a row, not {wanted}</source>
        <translation>{found} numeri in una riga, non {wanted}</translation>
    </message>
    <message>
        <source>{found} numbers in a row, {wanted} in the first</source>
        <translation>{found} numeri in una riga, {wanted} nella prima</translation>
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
        <source>Events set the analogue output where a motion begins (TriggEquip); by speed it follows the real speed of the TCP, so that slow corners get no more (TriggSpeed).</source>
        <translation>Gli eventi impostano l&apos;uscita analogica dove inizia un moto (TriggEquip); per velocità essa segue la velocità reale del TCP, così gli angoli lenti non ricevono di più (TriggSpeed).</translation>
    </message>
    <message>
        <source>How far the nozzle may lean from its planned direction where that makes the joints&apos; motion smoother. With least jerk of whole paths only.</source>
        <translation>Di quanto l&apos;ugello può inclinarsi dalla direzione prevista dove ciò rende più regolare il moto dei giunti. Solo con minimo strappo di percorsi interi.</translation>
    </message>
    <message>
        <source>How the nozzle stands about its own axis: as it suits the arm, or by a rule, where what it carries has a front. By a rule fewer places are reached.</source>
        <translation>Come sta l&apos;ugello attorno al proprio asse: come conviene al braccio, o secondo una regola, se ciò che porta ha un davanti. Con una regola si raggiungono meno punti.</translation>
    </message>
    <message>
        <source>Joint stream (MELFA Mxt, with packets and sender)</source>
        <translation>Flusso di giunti (MELFA Mxt, con pacchetti e mittente)</translation>
    </message>
    <message>
        <source>Joint stream (Universal Robots, with receiver and sender)</source>
        <translation>Flusso di giunti (Universal Robots, con ricevente e mittente)</translation>
    </message>
    <message>
        <source>MELFA stream: a packet is sent each cycle of the controller.</source>
        <translation>Flusso MELFA: a ogni ciclo del controllore si invia un pacchetto.</translation>
    </message>
    <message>
        <source>RAPID: the flow goes by</source>
        <translation>RAPID: il flusso segue</translation>
    </message>
    <message>
        <source>a flow in proportion to the speed is no sensible number</source>
        <translation>un flusso in proporzione alla velocità non è un numero sensato</translation>
    </message>
    <message>
        <source>a second stream</source>
        <translation>un secondo flusso</translation>
    </message>
    <message>
        <source>a stream begins with one way to the start, and has no other</source>
        <translation>un flusso comincia con un solo percorso verso l&apos;inizio, e non ne ha altri</translation>
    </message>
    <message>
        <source>a stream of {count} packets is longer than a file should be</source>
        <translation>un flusso di {count} pacchetti è più lungo di quanto un file debba essere</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>lungo il percorso</translation>
    </message>
    <message>
        <source>along the plate</source>
        <translation>lungo il piatto</translation>
    </message>
    <message>
        <source>as the arm goes best</source>
        <translation>come conviene al braccio</translation>
    </message>
    <message>
        <source>controller of the stream</source>
        <translation>controllore del flusso</translation>
    </message>
    <message>
        <source>directions may lean</source>
        <translation>le direzioni possono inclinarsi</translation>
    </message>
    <message>
        <source>events at points</source>
        <translation>eventi nei punti</translation>
    </message>
    <message>
        <source>format {format} tells joints of another maker&apos;s arm than the {robot} of cell {cell}</source>
        <translation>il formato {format} indica i giunti del braccio di un altro costruttore, non del {robot} della cella {cell}</translation>
    </message>
    <message>
        <source>least turn from upright</source>
        <translation>minima rotazione dalla verticale</translation>
    </message>
    <message>
        <source>not the header of a joint stream</source>
        <translation>non è l&apos;intestazione di un flusso di giunti</translation>
    </message>
    <message>
        <source>not what takes this stream: &apos;{code}&apos;</source>
        <translation>non è ciò che riceve questo flusso: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>packet {number} is not what the rows make</source>
        <translation>il pacchetto {number} non corrisponde alle righe</translation>
    </message>
    <message>
        <source>take melfa</source>
        <translation>usa melfa</translation>
    </message>
    <message>
        <source>the TCP&apos;s speed</source>
        <translation>la velocità del TCP</translation>
    </message>
    <message>
        <source>the arm waits elsewhere than where it stands</source>
        <translation>il braccio attende in un punto diverso da dove si trova</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not off at the end</source>
        <translation>alla fine le uscite dell&apos;estrusore non sono spente</translation>
    </message>
    <message>
        <source>the flow goes by the speed of a motion whose way is not known</source>
        <translation>il flusso segue la velocità di un moto di cui non si conosce il percorso</translation>
    </message>
    <message>
        <source>the program that takes the stream was cut short</source>
        <translation>il programma che riceve il flusso è troncato</translation>
    </message>
    <message>
        <source>the row that ends the stream is missing: the file was cut short</source>
        <translation>manca la riga che chiude il flusso: il file è troncato</translation>
    </message>
    <message>
        <source>this is not the program that receives a stream</source>
        <translation>non è il programma che riceve un flusso</translation>
    </message>
    <message>
        <source>this line is not as Voluta writes it; it is the same for every job</source>
        <translation>questa riga non è come la scrive Voluta; è uguale per ogni lavoro</translation>
    </message>
    <message>
        <source>turn of the nozzle</source>
        <translation>rotazione dell&apos;ugello</translation>
    </message>
    <message>
        <source>Filament that the external axis feeds before it is set to 0 anew: as far as it may go.</source>
        <translation>Filamento che l&apos;asse esterno spinge prima di essere riportato a 0: fin dove può andare.</translation>
    </message>
    <message>
        <source>How far the nozzle goes back over its bead, or on along one that closes, with the extruder off, before it lifts for the next. 0: it lifts where the bead ends.</source>
        <translation>Di quanto l&apos;ugello torna sul suo cordone, o prosegue lungo uno che si chiude, a estrusore spento, prima di sollevarsi per il prossimo. 0: si solleva dove il cordone finisce.</translation>
    </message>
    <message>
        <source>How the program tells the extruder how much to give: outputs, one on and off, one for the flow; Castelli serial, texts over a socket; E stream, a file of amounts over time; external axis, mm of filament in each motion.</source>
        <translation>Come il programma dice all&apos;estrusore quanto dare: uscite, una acceso e spento, una per il flusso; seriale di Castelli, testi su un socket; flusso E, un file di quantità nel tempo; asse esterno, mm di filamento in ogni moto.</translation>
    </message>
    <message>
        <source>all of the mesh is one point</source>
        <translation>tutta la mesh è un solo punto</translation>
    </message>
    <message>
        <source>at {x:.3f#}, {y:.3f#}, {z:.3f}, turned by {rx:.3f#}, {ry:.3f#}, {rz:.3f}</source>
        <translation>in {x:.3f#}, {y:.3f#}, {z:.3f}, ruotato di {rx:.3f#}, {ry:.3f#}, {rz:.3f}</translation>
    </message>
    <message>
        <source>between two lifts more than {length:.0f} of filament are laid: more than the extruder&apos;s axis goes</source>
        <translation>tra due sollevamenti si depongono più di {length:.0f} di filamento: più di quanto va l&apos;asse dell&apos;estrusore</translation>
    </message>
    <message>
        <source>external axes that move alone are read of the extruder, with a time</source>
        <translation>gli assi esterni che si muovono da soli si leggono come estrusore, con un tempo</translation>
    </message>
    <message>
        <source>external axis</source>
        <translation>asse esterno</translation>
    </message>
    <message>
        <source>extruder axis: range</source>
        <translation>asse dell&apos;estrusore: corsa</translation>
    </message>
    <message>
        <source>just as many numbers as are needed: they always agree, and nothing tells how sure the result is</source>
        <translation>tanti numeri quanti ne servono: concordano sempre, e nulla dice quanto sia sicuro il risultato</translation>
    </message>
    <message>
        <source>take a greater {option}</source>
        <translation>usa un valore maggiore di {option}</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is missing</source>
        <translation>manca l&apos;asse dell&apos;estrusore</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is not set to 0 before this motion</source>
        <translation>l&apos;asse dell&apos;estrusore non è portato a 0 prima di questo moto</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is slowed: the arm would wait for it</source>
        <translation>l&apos;asse dell&apos;estrusore è rallentato: il braccio lo aspetterebbe</translation>
    </message>
    <message>
        <source>wipe</source>
        <translation>pulizia</translation>
    </message>
    <message>
        <source>{rows} rows, {rms:.3f} apart on average and {worst:.3f} at most: sure to {place:.3f}</source>
        <translation>{rows} righe, scarto medio {rms:.3f} e massimo {worst:.3f}: sicuro entro {place:.3f}</translation>
    </message>
    <message>
        <source>{rows} rows, {rms:.3f} apart on average and {worst:.3f} at most: sure to {place:.3f} and {turn:.3f}</source>
        <translation>{rows} righe, scarto medio {rms:.3f} e massimo {worst:.3f}: sicuro entro {place:.3f} e {turn:.3f}</translation>
    </message>
    <message>
        <source>Extended G-code: writes beside it a RAPID module that reads the file on an ABB controller and runs arm and extruder by it.</source>
        <translation>G-code esteso: scrive accanto un modulo RAPID che legge il file su un controllore ABB e muove con esso braccio ed estrusore.</translation>
    </message>
    <message>
        <source>Lines by data link (MELFA-BASIC V, with receiver and sender)</source>
        <translation>Righe via data link (MELFA-BASIC V, con ricevitore e mittente)</translation>
    </message>
    <message>
        <source>a RAPID module (ABB)</source>
        <translation>un modulo RAPID (ABB)</translation>
    </message>
    <message>
        <source>a module that reads G-code cannot turn the {axis} of cell {cell}: G-code does not say where it is</source>
        <translation>un modulo che legge G-code non può girare {axis} della cella {cell}: il G-code non dice dove si trova</translation>
    </message>
    <message>
        <source>a position before the tool: whose is it?</source>
        <translation>una posizione prima dell&apos;utensile: di chi è?</translation>
    </message>
    <message>
        <source>another full flow than the process has</source>
        <translation>un altro flusso pieno rispetto a quello del processo</translation>
    </message>
    <message>
        <source>extended G-code is read by</source>
        <translation>il G-code esteso è letto da</translation>
    </message>
    <message>
        <source>its count (G92 C)</source>
        <translation>il suo conto (G92 C)</translation>
    </message>
    <message>
        <source>motions by joints to joints and to poses in one stream</source>
        <translation>movimenti dei giunti verso giunti e verso pose in un solo flusso di righe</translation>
    </message>
    <message>
        <source>not the header of lines for a data link</source>
        <translation>non è l&apos;intestazione di righe per un data link</translation>
    </message>
    <message>
        <source>not what takes these lines: &apos;{code}&apos;</source>
        <translation>non è ciò che riceve queste righe: &apos;{code}&apos;</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>niente</translation>
    </message>
    <message>
        <source>set tableTurns to {turns} or more</source>
        <translation>imposta tableTurns a {turns} o più</translation>
    </message>
    <message>
        <source>take rapid</source>
        <translation>usa rapid</translation>
    </message>
    <message>
        <source>the arm does not stand where this line begins</source>
        <translation>il braccio non si trova dove comincia questa riga</translation>
    </message>
    <message>
        <source>the extruder is on in a motion by joints</source>
        <translation>l&apos;estrusore è acceso in un movimento dei giunti</translation>
    </message>
    <message>
        <source>the file, the start or the full flow of the job is not there, or twice</source>
        <translation>il file, l&apos;inizio o il flusso pieno del lavoro manca, o c&apos;è due volte</translation>
    </message>
    <message>
        <source>the first line is no motion by joints to the start</source>
        <translation>la prima riga non è un movimento dei giunti verso l&apos;inizio</translation>
    </message>
    <message>
        <source>the layer &apos;{path}&apos; has no height above the one before</source>
        <translation>lo strato &apos;{path}&apos; non ha altezza sopra quello precedente</translation>
    </message>
    <message>
        <source>the line that ends the stream is missing: the file was cut short</source>
        <translation>manca la riga che chiude il flusso: il file è stato troncato</translation>
    </message>
    <message>
        <source>the program that takes the lines was cut short</source>
        <translation>il programma che riceve le righe è stato troncato</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>la tavola</translation>
    </message>
    <message>
        <source>the table would turn further than {turns} turns to a side within a bead</source>
        <translation>la tavola girerebbe oltre {turns} giri per parte entro un cordone</translation>
    </message>
    <message>
        <source>this is not the module that reads G-code</source>
        <translation>questo non è il modulo che legge il G-code</translation>
    </message>
    <message>
        <source>tool-paths of type &apos;{type}&apos; without beads; what a nozzle lays is read</source>
        <translation>percorsi di tipo &apos;{type}&apos; senza cordoni; si legge ciò che un ugello deposita</translation>
    </message>
    <message>
        <source>turns until C goes back</source>
        <translation>giri prima che C torni indietro</translation>
    </message>
    <message>
        <source>what goes back of C</source>
        <translation>che cosa torna indietro di C</translation>
    </message>
    <message>
        <source>Beads under what would hang just over the plate or over what is printed, which is laid thicker where that is enough. They come off.</source>
        <translation>Cordoni sotto ciò che penderebbe appena sopra il piatto o sopra quanto è già stampato; dove basta, il cordone stesso è deposto più spesso. Si staccano.</translation>
    </message>
    <message>
        <source>Lines by EthernetKRL (KUKA, with receiver and sender)</source>
        <translation>Righe via EthernetKRL (KUKA, con ricevitore e mittente)</translation>
    </message>
    <message>
        <source>an axis that carries the robot is missing</source>
        <translation>manca un asse che porta il robot</translation>
    </message>
    <message numerus="yes">
        <source>beads of support ({volume:.3g}) are laid under {paths} beads that would hang just over the plate or over what is printed</source>
        <translation>
            <numerusform>cordoni di supporto ({volume:.3g}) sono deposti sotto {paths} cordone che penderebbe appena sopra il piatto o sopra quanto è stampato</numerusform>
            <numerusform>cordoni di supporto ({volume:.3g}) sono deposti sotto {paths} cordoni che penderebbero appena sopra il piatto o sopra quanto è stampato</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{paths} beads would hang beside what is printed: each is laid after the one inwards of it and pressed against that, the nozzle leaning by up to {lean:.0f} more</source>
        <translation>
            <numerusform>{paths} cordone penderebbe accanto a quanto è stampato: è deposto dopo quello più interno e premuto contro di esso, con l&apos;ugello inclinato fino a {lean:.0f} in più</numerusform>
            <numerusform>{paths} cordoni penderebbero accanto a quanto è stampato: ciascuno è deposto dopo quello più interno e premuto contro di esso, con l&apos;ugello inclinato fino a {lean:.0f} in più</numerusform>
        </translation>
    </message>
    <message>
        <source>where that is not wanted, turn the part or print it in flat layers with supports</source>
        <translation>se non lo si vuole, girare il pezzo o stamparlo a strati piani con supporti</translation>
    </message>
    <message>
        <source>format {format} knows no external axis: it cannot move the {axis} of cell {cell}</source>
        <translation>il formato {format} non conosce assi esterni: non può muovere {axis} della cella {cell}</translation>
    </message>
    <message>
        <source>must be platform behind an axis that carries the platform</source>
        <translation>deve essere platform dopo un asse che porta la piattaforma</translation>
    </message>
    <message>
        <source>must be platform or robot, is &apos;{carries}&apos;</source>
        <translation>deve essere platform o robot, è &apos;{carries}&apos;</translation>
    </message>
    <message>
        <source>positions are in a base, or of a nozzle that stands: one of them has to be set</source>
        <translation>le posizioni sono in una base, o di un ugello fisso: va impostato uno dei due</translation>
    </message>
    <message>
        <source>support under what hangs low</source>
        <translation>supporto sotto ciò che pende basso</translation>
    </message>
    <message>
        <source>the program has its nozzle {distance:.2f} and {angle:.2f} from where the cell&apos;s stands</source>
        <translation>il programma ha l&apos;ugello a {distance:.2f} e {angle:.2f} da dove sta quello della cella</translation>
    </message>
    <message numerus="yes">
        <source>{waypoints} waypoints, {share:.2g} of the material, are left out here and there, as told above</source>
        <translation>
            <numerusform>{waypoints} punto del percorso, {share:.2g} del materiale, viene tralasciato qua e là, come detto sopra</numerusform>
            <numerusform>{waypoints} punti del percorso, {share:.2g} del materiale, vengono tralasciati qua e là, come detto sopra</numerusform>
        </translation>
    </message>
    <message>
        <source>As large as the robot gets to all of it</source>
        <translation>Grande quanto basta perché il robot arrivi ovunque</translation>
    </message>
    <message>
        <source>print it at scale {scale:.3g}, turn it, or use a larger robot</source>
        <translation>stampalo in scala {scale:.3g}, giralo o usa un robot più grande</translation>
    </message>
    <message>
        <source>use flat layers, where the nozzle need not lean, turn the part, or use a larger robot</source>
        <translation>usa strati piani, in cui l&apos;ugello non deve inclinarsi, gira il pezzo o usa un robot più grande</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-paths&apos; points are out of the robot&apos;s reach</source>
        <translation>{share:.2g} dei punti dei percorsi è fuori dalla portata del robot</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-paths&apos; points are out of the robot&apos;s reach; at {size:.2g} of this size it would get to them</source>
        <translation>{share:.2g} dei punti dei percorsi è fuori dalla portata del robot; al {size:.2g} di questa dimensione ci arriverebbe</translation>
    </message>
    <message>
        <source>Let Voluta choose</source>
        <translation>Lascia scegliere Voluta</translation>
    </message>
    <message>
        <source>Tries the ways of building one after the other, until nothing hangs or is missed</source>
        <translation>Prova i modi di costruire uno dopo l’altro, finché nulla pende o manca</translation>
    </message>
    <message>
        <source>turn the part, or let Voluta choose the way of building</source>
        <translation>gira il pezzo, o lascia che Voluta scelga il modo di costruire</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is a word of the language: no function may be called so</source>
        <translation>&apos;{name}&apos; è una parola del linguaggio: nessuna funzione può chiamarsi così</translation>
    </message>
    <message>
        <source>&apos;{number}&apos; is a number with a decimal comma, or one of thousands</source>
        <translation>&apos;{number}&apos; può essere un numero con la virgola decimale o uno di migliaia</translation>
    </message>
    <message>
        <source>A fifth smaller than now</source>
        <translation>Un quinto più piccolo di adesso</translation>
    </message>
    <message>
        <source>Adds a page to hand over beside each program, NAME.proof.html and NAME.proof.pdf: the verdict, what was checked, and how near to its limits it comes; its figures as NAME.proof.json; and NAME.printed.stl, the part as printed, as a solid.</source>
        <translation>Aggiunge accanto a ogni programma una pagina da consegnare, NOME.proof.html e NOME.proof.pdf: l&apos;esito, che cosa è stato verificato e quanto ci si avvicina ai limiti; i valori in NOME.proof.json; e NOME.printed.stl, il pezzo stampato come solido.</translation>
    </message>
    <message>
        <source>Allow less clearance</source>
        <translation>Ammetti meno distanza</translation>
    </message>
    <message>
        <source>Amount: {share:.1f} of the part&apos;s volume is laid; {least:.0f#} to {most:.0f} are allowed.</source>
        <translation>Quantità: si depone il {share:.1f} del volume del pezzo; ammesso da {least:.0f#} a {most:.0f}.</translation>
    </message>
    <message>
        <source>Arm, joints and their limits: not checked, as the program says where the nozzle is and not where the arm is.</source>
        <translation>Braccio, giunti e loro limiti: non verificati, perché il programma dice dov&apos;è l&apos;ugello e non dov&apos;è il braccio.</translation>
    </message>
    <message>
        <source>As large as the cell&apos;s largest plate carries</source>
        <translation>Grande quanto porta il piatto più grande della cella</translation>
    </message>
    <message>
        <source>As wide as the part&apos;s foot and 20 mm more, on a stem of its own</source>
        <translation>Larga quanto la base del pezzo e 20 mm in più, su un suo gambo</translation>
    </message>
    <message>
        <source>Bead section: wrong by more than 5 % over {share:.2f} of the printed length; at most {limit:.0f}.</source>
        <translation>Sezione del cordone: errata di oltre il 5 % sul {share:.2f} della lunghezza stampata; al massimo {limit:.0f}.</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Costruito in</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Chosen: {way} ({values})</source>
        <translation>Scelta: {way} ({values})</translation>
    </message>
    <message>
        <source>Close the rims</source>
        <translation>Chiudi i bordi</translation>
    </message>
    <message>
        <source>Closest approach of arm, plate and part: {way:.1f} apart.</source>
        <translation>Distanza minima fra braccio, piatto e pezzo: {way:.1f}.</translation>
    </message>
    <message>
        <source>Collisions of head, plate and part: {collisions}; none is allowed.</source>
        <translation>Collisioni di testa, piatto e pezzo: {collisions}; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Collisions: {collisions}; none is allowed.</source>
        <translation>Collisioni: {collisions}; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Fill: {share:.1f} of the part is filled; {limit:.0f} are required.</source>
        <translation>Riempimento: è pieno il {share:.1f} del pezzo; richiesto {limit:.0f}.</translation>
    </message>
    <message>
        <source>Flat patches over the rims: the part becomes solid</source>
        <translation>Toppe piane sui bordi: il pezzo diventa solido</translation>
    </message>
    <message>
        <source>G-code with B and C: beyond so many turns to a side C goes back by whole turns in a travel; 0: as few turns as the beads allow where the table goes back, one where its count does.</source>
        <translation>G-code con B e C: oltre tanti giri da un lato C torna indietro di giri interi durante uno spostamento; 0: i giri più pochi che i cordoni permettono dove torna indietro la tavola, uno dove lo fa il suo conteggio.</translation>
    </message>
    <message>
        <source>G-code with B and C: the table is wound back amid a travel, with the nozzle above all that it lifts. Of a table that turns without end the count alone may go back: it stays where it is.</source>
        <translation>G-code con B e C: la tavola viene riavvolta durante uno spostamento, con l&apos;ugello sopra tutto ciò che solleva. Di una tavola che gira senza fine può tornare indietro il solo conteggio: essa resta dov&apos;è.</translation>
    </message>
    <message>
        <source>G94 is missing behind the last motion: what runs next would take F for times</source>
        <translation>G94 manca dopo l&apos;ultimo movimento: il programma seguente prenderebbe F per tempi</translation>
    </message>
    <message>
        <source>Half as high, as far as the process goes</source>
        <translation>Alti la metà, fin dove arriva il processo</translation>
    </message>
    <message>
        <source>Half as large again</source>
        <translation>Una volta e mezza</translation>
    </message>
    <message>
        <source>Half the distance that the arm keeps from itself and from the part</source>
        <translation>Metà della distanza che il braccio tiene da sé stesso e dal pezzo</translation>
    </message>
    <message>
        <source>Half-carried: {share:.1f} of the bead length lies on less than half its width.</source>
        <translation>Appoggio parziale: il {share:.1f} della lunghezza dei cordoni poggia su meno di metà larghezza.</translation>
    </message>
    <message>
        <source>How full the part is: the mean along the view, of beads with round edges</source>
        <translation>Quanto è pieno il pezzo: la media lungo la vista, di cordoni con bordi tondi</translation>
    </message>
    <message>
        <source>In a usual cell; Voluta chooses the way of building</source>
        <translation>In una cella abituale; Voluta sceglie il modo di costruire</translation>
    </message>
    <message>
        <source>It is for another controller than the cell&apos;s own.</source>
        <translation>È per un controllore diverso da quello della cella.</translation>
    </message>
    <message>
        <source>It prints the rest of a part that was stopped.</source>
        <translation>Stampa il resto di un pezzo interrotto.</translation>
    </message>
    <message>
        <source>Joint range: joint {name} comes nearest to its limit, {angle:.1f} from it.</source>
        <translation>Corsa dei giunti: il giunto {name} è il più vicino al limite, a {angle:.1f}.</translation>
    </message>
    <message>
        <source>Joint speed: joint {name} comes nearest to its limit, at {share:.0f} of it.</source>
        <translation>Velocità dei giunti: il giunto {name} è il più vicino al limite, al {share:.0f}.</translation>
    </message>
    <message>
        <source>Keep more clearance</source>
        <translation>Tieni più distanza</translation>
    </message>
    <message>
        <source>Limits of flow and blends: {violations} violations; none is allowed.</source>
        <translation>Limiti di portata e raccordi: {violations} violazioni; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Limits of joints, speeds and flow: {violations} violations; none is allowed.</source>
        <translation>Limiti di giunti, velocità e portata: {violations} violazioni; nessuna è ammessa.</translation>
    </message>
    <message>
        <source>Longer programs are cut into files to be run in turn; 0: as the format has it (URScript and RAPID 5000, KRL 2500, MELFA 6500, SPEL+ one file).</source>
        <translation>I programmi più lunghi sono divisi in file da eseguire uno dopo l&apos;altro; 0: come prevede il formato (URScript e RAPID 5000, KRL 2500, MELFA 6500, SPEL+ un file solo).</translation>
    </message>
    <message>
        <source>Longest unsupported run: {length:.1f}; this material bridges {bridge:.1f}.</source>
        <translation>Tratto più lungo senza appoggio: {length:.1f}; questo materiale supera {bridge:.1f}.</translation>
    </message>
    <message>
        <source>Make a platform for the part</source>
        <translation>Fai una piattaforma per il pezzo</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Nothing passes; shown is the least bad: {way} ({values})</source>
        <translation>Nessun modo è accettato; si mostra il meno peggio: {way} ({values})</translation>
    </message>
    <message>
        <source>Nozzle, head and material that this way of building comes with</source>
        <translation>Ugello, testa e materiale che accompagnano questo modo di costruire</translation>
    </message>
    <message>
        <source>Open surfaces</source>
        <translation>Superfici aperte</translation>
    </message>
    <message>
        <source>Overfill: {share:.1f} of the part&apos;s volume lies outside it or found no room; at most {limit:.0f}.</source>
        <translation>Eccesso: il {share:.1f} del volume del pezzo è fuori da esso o non trova posto; al massimo {limit:.0f}.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Passed: this program prints the part as planned.</source>
        <translation>Superato: questo programma stampa il pezzo come previsto.</translation>
    </message>
    <message>
        <source>Path: the nozzle leaves its planned path by {way:.3f} at most; {limit:.2f} are allowed.</source>
        <translation>Percorso: l&apos;ugello si scosta dal percorso previsto di {way:.3f} al massimo; ammesso {limit:.2f}.</translation>
    </message>
    <message>
        <source>Planned
time</source>
        <translation>Tempo
previsto</translation>
    </message>
    <message>
        <source>Positions are mm in the work frame: from the middle of the platform&apos;s top, z out of it. The part as printed, as a solid: {file}</source>
        <translation>Le posizioni sono in mm nel sistema di lavoro: dal centro del piano della piattaforma, z verso l&apos;esterno. Il pezzo stampato, come solido: {file}</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>Innesco</translation>
    </message>
    <message>
        <source>Print it larger</source>
        <translation>Stampalo più grande</translation>
    </message>
    <message>
        <source>Print it smaller</source>
        <translation>Stampalo più piccolo</translation>
    </message>
    <message>
        <source>Print lower layers</source>
        <translation>Stampa strati più bassi</translation>
    </message>
    <message>
        <source>Print on a plate</source>
        <translation>Stampa su un piatto</translation>
    </message>
    <message>
        <source>Print time</source>
        <translation>Tempo di stampa</translation>
    </message>
    <message>
        <source>Program files, with the SHA-256 of each</source>
        <translation>File del programma, con lo SHA-256 di ciascuno</translation>
    </message>
    <message>
        <source>Refused: do not run this program.</source>
        <translation>Rifiutato: non eseguire questo programma.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Robot and plate that this way of building comes with</source>
        <translation>Robot e piatto che accompagnano questo modo di costruire</translation>
    </message>
    <message>
        <source>Singular poses: isotropy falls to {ratio:.3f} (0 is singular, 1 is even).</source>
        <translation>Pose singolari: l&apos;isotropia scende a {ratio:.3f} (0 è singolare, 1 è uniforme).</translation>
    </message>
    <message>
        <source>The next one with a larger plate</source>
        <translation>La prossima con un piatto più grande</translation>
    </message>
    <message>
        <source>The smallest of the cell&apos;s plates that carries the part</source>
        <translation>Il più piccolo dei piatti della cella che porta il pezzo</translation>
    </message>
    <message>
        <source>Thicken to a wall</source>
        <translation>Ispessisci a parete</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Utensile</translation>
    </message>
    <message>
        <source>Try more turns</source>
        <translation>Prova più rotazioni</translation>
    </message>
    <message>
        <source>Trying {way} ({number} of {count})</source>
        <translation>Prova di {way} ({number} di {count})</translation>
    </message>
    <message>
        <source>Twice as many turns about the nozzle at each place; planning takes longer</source>
        <translation>Il doppio delle rotazioni attorno all&apos;ugello in ogni punto; la pianificazione dura di più</translation>
    </message>
    <message>
        <source>Twice the distance that the arm keeps from itself and from the part</source>
        <translation>Il doppio della distanza che il braccio tiene da sé stesso e dal pezzo</translation>
    </message>
    <message>
        <source>Two beads wide, half of it on either side of the surface</source>
        <translation>Larga due cordoni, metà per lato della superficie</translation>
    </message>
    <message>
        <source>Unsupported: {share:.2f} of the bead length has nothing beneath it; at most {limit:.1f}.</source>
        <translation>Senza appoggio: il {share:.2f} della lunghezza dei cordoni non ha nulla sotto; al massimo {limit:.1f}.</translation>
    </message>
    <message>
        <source>Use a larger cell</source>
        <translation>Usa una cella più grande</translation>
    </message>
    <message>
        <source>Use longer motions</source>
        <translation>Usa movimenti più lunghi</translation>
    </message>
    <message>
        <source>Use shorter motions</source>
        <translation>Usa movimenti più corti</translation>
    </message>
    <message>
        <source>Use the cell&apos;s plate</source>
        <translation>Usa il piatto della cella</translation>
    </message>
    <message>
        <source>Use the usual cell</source>
        <translation>Usa la cella abituale</translation>
    </message>
    <message>
        <source>Use the usual process</source>
        <translation>Usa il processo abituale</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, moved the nozzle along it without an arm, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta ha riletto il programma, ha mosso l&apos;ugello lungo di esso senza un braccio e {checks} verifica non è superata.</numerusform>
            <numerusform>Voluta ha riletto il programma, ha mosso l&apos;ugello lungo di esso senza un braccio e {checks} verifiche non sono superate.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, moved the nozzle along it without an arm, and measured what it prints.</source>
        <translation>Voluta ha riletto il programma, ha mosso l&apos;ugello lungo di esso senza un braccio e ha misurato ciò che stampa.</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta ha riletto il programma, l&apos;ha eseguito su un modello del robot e del suo controllore e {checks} verifica non è superata.</numerusform>
            <numerusform>Voluta ha riletto il programma, l&apos;ha eseguito su un modello del robot e del suo controllore e {checks} verifiche non sono superate.</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and measured what it prints.</source>
        <translation>Voluta ha riletto il programma, l&apos;ha eseguito su un modello del robot e del suo controllore e ha misurato ciò che stampa.</translation>
    </message>
    <message>
        <source>Voluta {version}, {date}</source>
        <translation>Voluta {version}, {date}</translation>
    </message>
    <message>
        <source>Waypoints half as far apart; the program gets longer</source>
        <translation>Punti distanti la metà; il programma si allunga</translation>
    </message>
    <message>
        <source>Waypoints twice as far apart</source>
        <translation>Punti distanti il doppio</translation>
    </message>
    <message>
        <source>What becomes of a part whose surface has wide rims or no thickness: it is refused, its rims are closed with patches, or the surface becomes a wall two beads wide.</source>
        <translation>Che cosa si fa di un pezzo la cui superficie ha bordi larghi o nessuno spessore: viene rifiutato, i bordi si chiudono con toppe, o la superficie diventa una parete larga due cordoni.</translation>
    </message>
    <message>
        <source>What was checked, and where it comes nearest to its limit</source>
        <translation>Che cosa è stato verificato e dove ci si avvicina di più al limite</translation>
    </message>
    <message>
        <source>Which modules and list of signals the controller loads: IRC5 (RobotWare 6) or OmniCore (RobotWare 7).</source>
        <translation>Quali moduli e quale elenco di segnali carica il controllore: IRC5 (RobotWare 6) oppure OmniCore (RobotWare 7).</translation>
    </message>
    <message>
        <source>a ball at vertex {vertex}, which is not there</source>
        <translation>una sfera al vertice {vertex}, che non c&apos;è</translation>
    </message>
    <message>
        <source>a beam to vertex {vertex}, which is not there</source>
        <translation>una trave al vertice {vertex}, che non c&apos;è</translation>
    </message>
    <message>
        <source>a beam without a radius</source>
        <translation>una trave senza raggio</translation>
    </message>
    <message>
        <source>a picture of a sheet is no PNG</source>
        <translation>un&apos;immagine del foglio non è un PNG</translation>
    </message>
    <message>
        <source>a stop that lasts until the operator goes on</source>
        <translation>un arresto che dura finché l&apos;operatore non prosegue</translation>
    </message>
    <message>
        <source>a trigger for the output</source>
        <translation>un trigger per l&apos;uscita</translation>
    </message>
    <message>
        <source>a wait until the nozzle is hot</source>
        <translation>un&apos;attesa finché l&apos;ugello è caldo</translation>
    </message>
    <message>
        <source>a wall of {wall:.2f} is too thin for so large a surface: it would come to {facets:.2g} triangles</source>
        <translation>una parete di {wall:.2f} è troppo sottile per una superficie così grande: darebbe {facets:.2g} triangoli</translation>
    </message>
    <message>
        <source>absolute positions</source>
        <translation>posizioni assolute</translation>
    </message>
    <message>
        <source>after {time}</source>
        <translation>dopo {time}</translation>
    </message>
    <message>
        <source>an object of the unknown type &apos;{type}&apos;</source>
        <translation>un oggetto del tipo sconosciuto &apos;{type}&apos;</translation>
    </message>
    <message>
        <source>an output of the extruder set where the arm does not stop: it takes effect elsewhere, or stops the arm on the bead</source>
        <translation>un&apos;uscita dell&apos;estrusore impostata dove il braccio non si ferma: ha effetto altrove, o ferma il braccio sul cordone</translation>
    </message>
    <message>
        <source>as the robot&apos;s controller</source>
        <translation>come il controllore del robot</translation>
    </message>
    <message>
        <source>at {place:.1f}</source>
        <translation>in {place:.1f}</translation>
    </message>
    <message>
        <source>clear this place, or use a larger plate (--platform)</source>
        <translation>liberare questo punto, oppure usare un piano più grande (--platform)</translation>
    </message>
    <message>
        <source>close</source>
        <translation>chiudi</translation>
    </message>
    <message>
        <source>closed the rims of an open surface: {share:.3g} of the surface are patches</source>
        <translation>chiusi i bordi di una superficie aperta: il {share:.3g} della superficie sono toppe</translation>
    </message>
    <message>
        <source>curved layers</source>
        <translation>strati curvi</translation>
    </message>
    <message>
        <source>curved layers on a pedestal</source>
        <translation>strati curvi su un piedistallo</translation>
    </message>
    <message>
        <source>curved layers with supports</source>
        <translation>strati curvi con supporti</translation>
    </message>
    <message>
        <source>decimal commas read as decimal points</source>
        <translation>virgole decimali lette come punti decimali</translation>
    </message>
    <message>
        <source>export it as a triangle mesh</source>
        <translation>esportalo come mesh di triangoli</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>esportalo con il punto decimale</translation>
    </message>
    <message>
        <source>flat layers</source>
        <translation>strati piani</translation>
    </message>
    <message>
        <source>flat layers with supports</source>
        <translation>strati piani con supporti</translation>
    </message>
    <message>
        <source>foot of the part: {length:.0f} by {width:.0f}, more than the cell&apos;s largest plate ({plate}) carries</source>
        <translation>base del pezzo: {length:.0f} per {width:.0f}, più di quanto porta il piatto più grande della cella ({plate})</translation>
    </message>
    <message>
        <source>has a disc inside another</source>
        <translation>ha un disco dentro un altro</translation>
    </message>
    <message>
        <source>holds nothing to print: {what}</source>
        <translation>non contiene nulla da stampare: {what}</translation>
    </message>
    <message>
        <source>holds sliced G-code (&apos;{member}&apos;) and no model</source>
        <translation>contiene G-code già affettato (&apos;{member}&apos;) e nessun modello</translation>
    </message>
    <message>
        <source>how amounts of filament are counted</source>
        <translation>come si contano le quantità di filamento</translation>
    </message>
    <message>
        <source>infill density {density} cannot be printed yet: parts are filled solid</source>
        <translation>la densità di riempimento {density} non si può ancora stampare: i pezzi sono pieni</translation>
    </message>
    <message>
        <source>infill density {density} of the project is left out: parts are filled solid</source>
        <translation>la densità di riempimento {density} del progetto è ignorata: i pezzi sono pieni</translation>
    </message>
    <message>
        <source>is UTF-16 that is damaged or cut short</source>
        <translation>è in UTF-16 danneggiato o troncato</translation>
    </message>
    <message>
        <source>is UTF-32, which cannot be read</source>
        <translation>è in UTF-32, che non si può leggere</translation>
    </message>
    <message>
        <source>is none of the colours: &apos;{name}&apos;</source>
        <translation>non è tra i colori: &apos;{name}&apos;</translation>
    </message>
    <message>
        <source>kept as sentences in an older project: plan again for what can be done</source>
        <translation>conservato come frasi in un progetto più vecchio: pianifica di nuovo per sapere che cosa si può fare</translation>
    </message>
    <message>
        <source>layer height {height}, platform: {platform}</source>
        <translation>altezza degli strati {height}, piattaforma: {platform}</translation>
    </message>
    <message>
        <source>layer height {height}, supports: {supports}, platform: {platform}</source>
        <translation>altezza degli strati {height}, supporti: {supports}, piattaforma: {platform}</translation>
    </message>
    <message>
        <source>layer {layer}</source>
        <translation>strato {layer}</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>ometterla</translation>
    </message>
    <message>
        <source>left out the sheets without thickness: {share:.3g} of the surface, {triangles} triangles</source>
        <translation>escluse le lamine senza spessore: il {share:.3g} della superficie, {triangles} triangoli</translation>
    </message>
    <message>
        <source>less than {share:.0f}</source>
        <translation>meno del {share:.0f}</translation>
    </message>
    <message>
        <source>line {line} of {file}</source>
        <translation>riga {line} di {file}</translation>
    </message>
    <message>
        <source>millimetres as the unit of length</source>
        <translation>i millimetri come unità di lunghezza</translation>
    </message>
    <message>
        <source>missing before this line: {statement}</source>
        <translation>manca prima di questa riga: {statement}</translation>
    </message>
    <message>
        <source>must be a colour like &quot;#d0d4d8&quot;</source>
        <translation>deve essere un colore come &quot;#d0d4d8&quot;</translation>
    </message>
    <message>
        <source>must be in 1..{most}</source>
        <translation>deve essere in 1..{most}</translation>
    </message>
    <message>
        <source>must hold as many discs as the first, at least one</source>
        <translation>deve contenere tanti dischi quanti la prima, almeno uno</translation>
    </message>
    <message>
        <source>must hold at least one solid</source>
        <translation>deve contenere almeno un solido</translation>
    </message>
    <message>
        <source>must hold {wanted} values, holds {found}</source>
        <translation>deve contenere {wanted} valori, ne contiene {found}</translation>
    </message>
    <message>
        <source>must not be along the axis</source>
        <translation>non deve essere lungo l&apos;asse</translation>
    </message>
    <message>
        <source>must not be before the one before it</source>
        <translation>non deve stare prima di quella precedente</translation>
    </message>
    <message>
        <source>no process here has narrower beads</source>
        <translation>nessun processo disponibile ha cordoni più stretti</translation>
    </message>
    <message>
        <source>nothing is left: no triangle has area or encloses a volume</source>
        <translation>non resta nulla: nessun triangolo ha area o racchiude un volume</translation>
    </message>
    <message>
        <source>nozzle {nozzle}, bead {width#} x {height}</source>
        <translation>ugello {nozzle}, cordone {width#} x {height}</translation>
    </message>
    <message>
        <source>numbers with commas, such as &apos;{number}&apos;, beside numbers with points</source>
        <translation>numeri con la virgola, come &apos;{number}&apos;, accanto a numeri con il punto</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; has a beam lattice that a mesh clips, which cannot be read</source>
        <translation>l&apos;oggetto &apos;{id}&apos; ha un reticolo di travi tagliato da una mesh, che non si può leggere</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is given in slices (slicestack), which cannot be read</source>
        <translation>l&apos;oggetto &apos;{id}&apos; è dato a strati (slicestack), che non si possono leggere</translation>
    </message>
    <message>
        <source>only the cell&apos;s own file can be changed: Edit, Edit cell</source>
        <translation>si può cambiare solo il file della cella: Modifica, Modifica cella</translation>
    </message>
    <message numerus="yes">
        <source>open surface: it ends at {rims} rims, the widest {width:.3g} wide</source>
        <translation>
            <numerusform>superficie aperta: finisce in {rims} bordo, largo {width:.3g}</numerusform>
            <numerusform>superficie aperta: finisce in {rims} bordi, il più largo {width:.3g}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>open surface: it ends at {rims} rims, the widest {width:.3g} wide at {at:.1f}</source>
        <translation>
            <numerusform>superficie aperta: finisce in {rims} bordo, largo {width:.3g} a {at:.1f}</numerusform>
            <numerusform>superficie aperta: finisce in {rims} bordi, il più largo {width:.3g} a {at:.1f}</numerusform>
        </translation>
    </message>
    <message>
        <source>open the model that it was sliced from</source>
        <translation>apri il modello da cui è stato affettato</translation>
    </message>
    <message>
        <source>openSurfaces=close makes it solid instead</source>
        <translation>openSurfaces=close ne fa invece un solido</translation>
    </message>
    <message>
        <source>openSurfaces=thicken makes a wall of the surface instead</source>
        <translation>openSurfaces=thicken ne fa invece una parete</translation>
    </message>
    <message>
        <source>openSurfaces=thicken makes walls of them instead</source>
        <translation>openSurfaces=thicken ne fa invece delle pareti</translation>
    </message>
    <message>
        <source>pieces with supports</source>
        <translation>parti piane con supporti</translation>
    </message>
    <message>
        <source>planned time</source>
        <translation>tempo previsto</translation>
    </message>
    <message>
        <source>print the part at scale {scale}, or use a cell with a larger plate or a platform made for the part</source>
        <translation>stampa il pezzo in scala {scale}, oppure usa una cella con un piatto più grande o una piattaforma fatta per il pezzo</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>rifiuta</translation>
    </message>
    <message numerus="yes">
        <source>removed the loops of {count} components that cut themselves</source>
        <translation>
            <numerusform>tolti gli anelli di {count} componente che taglia sé stesso</numerusform>
            <numerusform>tolti gli anelli di {count} componenti che tagliano sé stessi</numerusform>
        </translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>salvalo come UTF-8</translation>
    </message>
    <message>
        <source>set it by a trigger of the next motion, or write the program again</source>
        <translation>impostarla con un trigger del movimento seguente, o riscrivere il programma</translation>
    </message>
    <message>
        <source>sheet model: {share:.3g} of the surface are sheets without thickness, {triangles} triangles</source>
        <translation>modello a lamine: il {share:.3g} della superficie sono lamine senza spessore, {triangles} triangoli</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} items that are marked as not printable</source>
        <translation>
            <numerusform>saltato: {count} elemento contrassegnato come non stampabile</numerusform>
            <numerusform>saltati: {count} elementi contrassegnati come non stampabili</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;other&apos;, which are not printed</source>
        <translation>
            <numerusform>saltato: {count} oggetto di tipo &apos;other&apos;, che non si stampa</numerusform>
            <numerusform>saltati: {count} oggetti di tipo &apos;other&apos;, che non si stampano</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;surface&apos;, which have no inside</source>
        <translation>
            <numerusform>saltato: {count} oggetto di tipo &apos;surface&apos;, che non ha un interno</numerusform>
            <numerusform>saltati: {count} oggetti di tipo &apos;surface&apos;, che non hanno un interno</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} support objects</source>
        <translation>
            <numerusform>saltato: {count} oggetto di supporto</numerusform>
            <numerusform>saltati: {count} oggetti di supporto</numerusform>
        </translation>
    </message>
    <message>
        <source>the PDF is not made: {why}</source>
        <translation>il PDF non è stato creato: {why}</translation>
    </message>
    <message>
        <source>the arm passes this point at {stated:.1f} mm/s and its flow stays: {suits:.1f} mm/s suit its way</source>
        <translation>il braccio passa per questo punto a {stated:.1f} mm/s e la portata resta: al suo percorso si addicono {suits:.1f} mm/s</translation>
    </message>
    <message>
        <source>the arm stands here for {time:.2f}, the hot nozzle on the part: no wait is planned</source>
        <translation>il braccio sta fermo qui per {time:.2f}, l&apos;ugello caldo sul pezzo: nessuna attesa è prevista</translation>
    </message>
    <message>
        <source>the arm&apos;s posture at this target: {found} in the program, {planned} planned</source>
        <translation>la postura del braccio in questo punto: {found} nel programma, {planned} prevista</translation>
    </message>
    <message>
        <source>the bead to go on from is chosen on the Simulate page</source>
        <translation>il cordone da cui riprendere si sceglie nella pagina Simula</translation>
    </message>
    <message>
        <source>the distances by which corners are rounded</source>
        <translation>le distanze con cui si arrotondano gli angoli</translation>
    </message>
    <message>
        <source>the drive to the reference</source>
        <translation>la corsa al punto di riferimento</translation>
    </message>
    <message>
        <source>the findings before this one have the remedies</source>
        <translation>i rimedi sono nelle segnalazioni che precedono questa</translation>
    </message>
    <message>
        <source>the frame of the targets</source>
        <translation>il sistema di riferimento dei punti</translation>
    </message>
    <message>
        <source>the full flow</source>
        <translation>la portata massima</translation>
    </message>
    <message>
        <source>the mechanical unit</source>
        <translation>l&apos;unità meccanica</translation>
    </message>
    <message>
        <source>the message says what would help</source>
        <translation>il messaggio dice che cosa aiuterebbe</translation>
    </message>
    <message>
        <source>the part as printed, every bead laid</source>
        <translation>il pezzo stampato, con tutti i cordoni deposti</translation>
    </message>
    <message>
        <source>the plate has no room for the prime: a bead {length:.0f} long is laid in the air beside the plate and falls down here</source>
        <translation>sul piano non c&apos;è posto per l&apos;innesco: un cordone lungo {length:.0f} viene deposto in aria accanto al piano e cade qui</translation>
    </message>
    <message>
        <source>the program&apos;s text is not this plan&apos;s: nothing in the plan is to be changed</source>
        <translation>il testo del programma non è di questo piano: nel piano non c&apos;è nulla da cambiare</translation>
    </message>
    <message>
        <source>the range of the flow output</source>
        <translation>l&apos;intervallo dell&apos;uscita di portata</translation>
    </message>
    <message>
        <source>the surface crosses itself: {share:.3g} of what it encloses faces inside out and counts as outside</source>
        <translation>la superficie attraversa sé stessa: il {share:.3g} di ciò che racchiude è rovesciato e vale come esterno</translation>
    </message>
    <message>
        <source>the temperature of the nozzle, °C</source>
        <translation>la temperatura dell&apos;ugello, °C</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>ispessisci</translation>
    </message>
    <message>
        <source>thicken it to a wall (openSurfaces=thicken), close its rims to make it solid (openSurfaces=close), or close it in a modelling program</source>
        <translation>dalle lo spessore di una parete (openSurfaces=thicken), chiudi i bordi per farne un solido (openSurfaces=close) o chiudila in un programma di modellazione</translation>
    </message>
    <message>
        <source>thicken the sheets to walls (openSurfaces=thicken), or give them a thickness in a modelling program</source>
        <translation>dai alle lamine lo spessore di una parete (openSurfaces=thicken) o dagliene uno in un programma di modellazione</translation>
    </message>
    <message>
        <source>thicken the surface in a modelling program</source>
        <translation>dai spessore alla superficie in un programma di modellazione</translation>
    </message>
    <message>
        <source>thickened the open surface to a wall {wall:.2f} wide, half of it on either side</source>
        <translation>dato alla superficie aperta lo spessore di una parete di {wall:.2f}, metà per lato</translation>
    </message>
    <message numerus="yes">
        <source>turned {count} beams of a lattice into round bars</source>
        <translation>
            <numerusform>trasformata {count} trave di un reticolo in una barra tonda</numerusform>
            <numerusform>trasformate {count} travi di un reticolo in barre tonde</numerusform>
        </translation>
    </message>
    <message>
        <source>{bytes} bytes</source>
        <translation>{bytes} byte</translation>
    </message>
    <message>
        <source>{hours} h {minutes} min</source>
        <translation>{hours} h {minutes} min</translation>
    </message>
    <message numerus="yes">
        <source>{layers} layers, {way}</source>
        <translation>
            <numerusform>{layers} strato, {way}</numerusform>
            <numerusform>{layers} strati, {way}</numerusform>
        </translation>
    </message>
    <message>
        <source>{least:.0f#} to {most:.0f}</source>
        <translation>dal {least:.0f#} al {most:.0f}</translation>
    </message>
    <message>
        <source>{mass:.1f} g, supports and waste included</source>
        <translation>{mass:.1f} g, supporti e scarti compresi</translation>
    </message>
    <message>
        <source>{material}, {volume:.1f} cm3 at {density:.2f} g/cm3</source>
        <translation>{material}, {volume:.1f} cm³ a {density:.2f} g/cm³</translation>
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
        <source>{share:.0f} and more filled</source>
        <translation>pieno per il {share:.0f} e oltre</translation>
    </message>
    <message>
        <source>{statement}: {found} in the program, {planned} planned</source>
        <translation>{statement}: {found} nel programma, {planned} previsto</translation>
    </message>
    <message>
        <source>{time} on its controller</source>
        <translation>{time} sul suo controllore</translation>
    </message>
    <message>
        <source>{way}, {height} high</source>
        <translation>{way}, alti {height}</translation>
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
</context>
<context>
    <name>Resume</name>
    <message>
        <source>Bead %1 of %2</source>
        <translation>Cordone %1 di %2</translation>
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
    <name>voluta::document::Opening</name>
    <message>
        <source>the rest of %1</source>
        <translation>il resto di %1</translation>
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
    <message>
        <source>Your own cells are JSON files in %1</source>
        <translation>Le proprie celle sono file JSON in %1</translation>
    </message>
    <message>
        <source>Your own processes are JSON files in %1</source>
        <translation>I propri processi sono file JSON in %1</translation>
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
    <message>
        <source>Files (%1)</source>
        <translation>File (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Scegli un file</translation>
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
    <message>
        <source>Options of %1</source>
        <translation>Opzioni di %1</translation>
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
    <message>
        <source>before the change</source>
        <translation>prima della modifica</translation>
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
    <message>
        <source>Not checked: %1.</source>
        <translation>Non verificato: %1.</translation>
    </message>
    <message>
        <source>No problems found so far.</source>
        <translation>Finora nessun problema.</translation>
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
    <message>
        <source>Not replayed since the change</source>
        <translation>Non verificato dopo la modifica</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FrameForm</name>
    <message>
        <source>Place</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>About the fixed X, then Y, then Z axis</source>
        <translation>Attorno agli assi fissi X, poi Y, poi Z</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Lati</translation>
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
        <source>Hide</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
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
    <name>voluta::panels::ProgramFacts</name>
    <message>
        <source>What is assumed of the controller</source>
        <translation>Ipotesi sul controllore</translation>
    </message>
    <message>
        <source>%1 in one file</source>
        <translation>%1 in un file</translation>
    </message>
    <message>
        <source>%1 in %2 files</source>
        <translation>%1 in %2 file</translation>
    </message>
    <message>
        <source>Time on the controller: %1, as planned</source>
        <translation>Tempo sul controllore: %1, come previsto</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % more than the planned time of %2</source>
        <translation>Tempo sul controllore: %1, il %3 % in più del tempo previsto di %2</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % less than the planned time of %2</source>
        <translation>Tempo sul controllore: %1, il %3 % in meno del tempo previsto di %2</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ReachPanel</name>
    <message>
        <source>being looked for…</source>
        <translation>ricerca in corso…</translation>
    </message>
    <message>
        <source>No part on a plate.</source>
        <translation>Nessun pezzo su un piatto.</translation>
    </message>
    <message>
        <source>It stands beyond the cell&apos;s plate.</source>
        <translation>Sta oltre il piatto della cella.</translation>
    </message>
    <message>
        <source>All of it is reached upright.</source>
        <translation>Raggiunto tutto in verticale.</translation>
    </message>
    <message>
        <source>%1 % of it is reached upright.</source>
        <translation>Raggiunto in verticale: %1 %.</translation>
    </message>
    <message>
        <source>Tilted up to %1°: %2 %.</source>
        <translation>Inclinato fino a %1°: %2 %.</translation>
    </message>
    <message>
        <source>There %1 % is reached upright, %2 % tilted</source>
        <translation>Lì si raggiunge il %1 % in verticale, il %2 % inclinato</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portata</translation>
    </message>
    <message>
        <source>Where the head gets, over the whole height of the part; what is printed may still be in its way</source>
        <translation>Dove arriva la testa, su tutta l&apos;altezza del pezzo; ciò che è stampato può ancora ostacolarla</translation>
    </message>
    <message>
        <source>Show it on the plate</source>
        <translation>Mostra sul piatto</translation>
    </message>
    <message>
        <source>Move to best place</source>
        <translation>Sposta al posto migliore</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ResumeBar</name>
    <message>
        <source>Resume from here…</source>
        <translation>Riprendi da qui…</translation>
    </message>
    <message>
        <source>The rest of a print that was stopped there, as a project of its own</source>
        <translation>Il resto di una stampa interrotta lì, come progetto a sé</translation>
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
    <message>
        <source>Not checked since the change</source>
        <translation>Non verificato dopo la modifica</translation>
    </message>
    <message>
        <source>Carried by less than half</source>
        <translation>Retto da meno di metà</translation>
    </message>
    <message>
        <source>Longest in the air</source>
        <translation>Più lungo nel vuoto</translation>
    </message>
    <message>
        <source>Wrong flow</source>
        <translation>Flusso errato</translation>
    </message>
    <message>
        <source>Time on the controller</source>
        <translation>Tempo sul controllore</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WayCard</name>
    <message>
        <source>Contact %1 mm²</source>
        <translation>Contatto %1 mm²</translation>
    </message>
    <message>
        <source>Missed voxels %1</source>
        <translation>Voxel mancati %1</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Circa %1</translation>
    </message>
    <message>
        <source>%1 mm² touch the plate, %2 mm² lean over
%3 mm high
%4 of %5 voxels missed by one pass of growth
about %6 by its volume and height, without supports</source>
        <translation>%1 mm² toccano il piatto, %2 mm² sono a sbalzo
altezza %3 mm
%4 voxel su %5 mancati da una passata di crescita
circa %6 in base a volume e altezza, senza supporti</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WaysList</name>
    <message>
        <source>being looked for…</source>
        <translation>ricerca in corso…</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>nessuno trovato</translation>
    </message>
    <message>
        <source>it lies otherwise</source>
        <translation>è appoggiato altrimenti</translation>
    </message>
    <message>
        <source>Ways to stand</source>
        <translation>Modi di appoggio</translation>
    </message>
    <message>
        <source>Click one to lay the part so</source>
        <translation>Fai clic su uno per appoggiare così il pezzo</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WrittenBar</name>
    <message>
        <source>Open proof</source>
        <translation>Apri la verifica</translation>
    </message>
    <message>
        <source>The page to hand over: verdict, margins and hashes of the program</source>
        <translation>La pagina da consegnare: esito, margini e impronte del programma</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Mostra la cartella</translation>
    </message>
    <message>
        <source>The folder with the programs, in the file manager</source>
        <translation>La cartella con i programmi, nel gestore dei file</translation>
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
    <message>
        <source>Angle (°), way (mm)</source>
        <translation>Angolo (°), corsa (mm)</translation>
    </message>
    <message>
        <source>Speed (°/s, mm/s)</source>
        <translation>Velocità (°/s, mm/s)</translation>
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
    <message>
        <source>Moment of the print / planned time</source>
        <translation>Istante della stampa / tempo previsto</translation>
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
    <name>voluta::window::ArmImportDialog</name>
    <message>
        <source>Six axes with a spherical wrist, solved in closed form</source>
        <translation>Sei assi con polso sferico, risolti in forma chiusa</translation>
    </message>
    <message>
        <source>Six axes, 2 to 4 parallel, solved in closed form</source>
        <translation>Sei assi, da 2 a 4 paralleli, risolti in forma chiusa</translation>
    </message>
    <message>
        <source>Six axes with a bent wrist, solved by a search</source>
        <translation>Sei assi con polso piegato, risolti con una ricerca</translation>
    </message>
    <message>
        <source>Six axes, solved numerically: plans take longer</source>
        <translation>Sei assi, risolti numericamente: i piani durano di più</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Importa un braccio robotico</translation>
    </message>
    <message>
        <source>Nozzle on the arm, plate on a table</source>
        <translation>Ugello sul braccio, piatto su un tavolo</translation>
    </message>
    <message>
        <source>Plate on the arm, nozzle fixed</source>
        <translation>Piatto sul braccio, ugello fisso</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flangia</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmi</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importa</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lettura…</translation>
    </message>
    <message>
        <source>Assumed:</source>
        <translation>Supposto:</translation>
    </message>
</context>
<context>
    <name>voluta::window::BodyTree</name>
    <message>
        <source>Robot&apos;s base</source>
        <translation>Base del robot</translation>
    </message>
    <message>
        <source>Flange of %1</source>
        <translation>Flangia di %1</translation>
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
        <source>in the flange</source>
        <translation>nella flangia</translation>
    </message>
    <message>
        <source>on the last axis</source>
        <translation>sull&apos;ultimo asse</translation>
    </message>
    <message>
        <source>on the axis before it</source>
        <translation>sull&apos;asse precedente</translation>
    </message>
    <message>
        <source>in the robot&apos;s base</source>
        <translation>nella base del robot</translation>
    </message>
</context>
<context>
    <name>voluta::window::CellEditor</name>
    <message>
        <source>in the flange</source>
        <translation>nella flangia</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Modifica cella</translation>
    </message>
    <message>
        <source>Save as own cell</source>
        <translation>Salva come cella propria</translation>
    </message>
    <message>
        <source>What the flange carries before anything is printed: the plate and its stem, or head and extruder</source>
        <translation>Ciò che la flangia porta prima della stampa: il piatto col suo stelo, o testa ed estrusore</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>Estrusore</translation>
    </message>
    <message>
        <source>Carried</source>
        <translation>Carico</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>Aggiungi scatola</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Togli</translation>
    </message>
    <message>
        <source>Find rest</source>
        <translation>Trova riposo</translation>
    </message>
    <message>
        <source>Rest where the arm is clearest of everything, the nozzle over the plate</source>
        <translation>Riposo dove il braccio è più lontano da tutto, con l&apos;ugello sopra il piatto</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ripeti</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>estrusore</translation>
    </message>
    <message>
        <source>carried mass</source>
        <translation>massa portata</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>sposta %1</translation>
    </message>
    <message>
        <source>edges of %1</source>
        <translation>lati di %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Choose a body to move it</source>
        <translation>Scegli un corpo per spostarlo</translation>
    </message>
    <message>
        <source>being looked at…</source>
        <translation>controllo in corso…</translation>
    </message>
    <message>
        <source>Nothing is wrong with it.</source>
        <translation>Tutto a posto.</translation>
    </message>
    <message>
        <source>add a box</source>
        <translation>aggiungi una scatola</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>togli %1</translation>
    </message>
    <message>
        <source>being looked for…</source>
        <translation>ricerca in corso…</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>riposo</translation>
    </message>
    <message>
        <source>Nowhere over the plate is the arm clear of everything.</source>
        <translation>In nessun punto sopra il piatto il braccio è libero da tutto.</translation>
    </message>
    <message>
        <source>Replace the cell %1?</source>
        <translation>Sostituire la cella %1?</translation>
    </message>
    <message>
        <source>Add from file…</source>
        <translation>Aggiungi da file…</translation>
    </message>
    <message>
        <source>An obstacle that was drawn: a mesh, which becomes some boxes, cylinders and capsules about it</source>
        <translation>Un ostacolo disegnato: una mesh, che diventa alcuni parallelepipedi, cilindri e capsule attorno a essa</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Misura…</translation>
    </message>
    <message>
        <source>Where the body is, from points touched at the real cell</source>
        <translation>Dove sta il corpo, da punti toccati nella cella reale</translation>
    </message>
    <message>
        <source>Collision solids</source>
        <translation>Solidi di collisione</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>aggiungi %1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base, axes at 0</source>
        <translation>nella base del robot, assi a 0</translation>
    </message>
    <message>
        <source>measure %1</source>
        <translation>misura %1</translation>
    </message>
    <message>
        <source>Shows the solids that are checked for collisions over the arm</source>
        <translation>Mostra sopra il braccio i solidi controllati per le collisioni</translation>
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
    <message>
        <source>Automatic</source>
        <translation>Automatico</translation>
    </message>
    <message>
        <source>The first way of building, and the first platform, that nothing blocks.</source>
        <translation>Il primo modo di costruire, e la prima piattaforma, che nulla blocca.</translation>
    </message>
    <message>
        <source>Rejected: %1.</source>
        <translation>Scartato: %1.</translation>
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
        <source>; the proofs have no pictures: %1</source>
        <translation>; le prove non hanno immagini: %1</translation>
    </message>
    <message>
        <source>The files are being written.</source>
        <translation>I file sono in scrittura.</translation>
    </message>
    <message>
        <source>Nothing is exported</source>
        <translation>Niente è stato esportato</translation>
    </message>
    <message>
        <source>The replay refused all programs: %1.</source>
        <translation>La verifica ha rifiutato tutti i programmi: %1.</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>Sostituire i file?</translation>
    </message>
    <message>
        <source>Files are in %1 already.</source>
        <translation>In %1 ci sono già dei file.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>This is the rest of a print, made with other settings. Undo the change: Plan makes the whole part anew.</source>
        <translation>Questo è il resto di una stampa, fatta con altre impostazioni. Annullare la modifica: Pianifica rifà tutto il pezzo.</translation>
    </message>
    <message>
        <source>Slower on the controller: %1 s more</source>
        <translation>Più lento sul controllore: %1 s in più</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>Riga %1, %2</translation>
    </message>
    <message>
        <source>Verify a program</source>
        <translation>Verifica un programma</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Cannot open %1</source>
        <translation>Impossibile aprire %1</translation>
    </message>
    <message>
        <source>No program is set up on this machine to open it.</source>
        <translation>Su questa macchina nessun programma è impostato per aprirlo.</translation>
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
    <name>voluta::window::LogDialog</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 non si può leggere: %2.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Apri la cartella</translation>
    </message>
    <message>
        <source>No program here opens the folder %1.</source>
        <translation>Nessun programma qui apre la cartella %1.</translation>
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
    <name>voluta::window::MeasureDialog</name>
    <message>
        <source>Points in mm, %1, one a row. Three rows x, y, z: the origin, a point on X, and one beside it towards Y. Or three or more rows of six: where a point is in the frame, and where it was touched.</source>
        <translation>Punti in mm, %1, uno per riga. Tre righe x, y, z: l&apos;origine, un punto su X e uno di lato verso Y. O tre o più righe di sei: dove sta un punto nel riferimento e dove è stato toccato.</translation>
    </message>
    <message>
        <source>Four or more poses in which the tip touches one and the same point, tilted to different sides, one a row: the robot&apos;s joints, or x, y, z, qw, qx, qy, qz of the flange.</source>
        <translation>Quattro o più pose in cui la punta tocca lo stesso punto, inclinata da parti diverse, una per riga: i giunti del robot, o x, y, z, qw, qx, qy, qz della flangia.</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Misura %1</translation>
    </message>
    <message>
        <source>Use this frame</source>
        <translation>Usa questo riferimento</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Righe</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObstacleImport</name>
    <message>
        <source>Obstacle from a file</source>
        <translation>Ostacolo da file</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.ply *.off *.3mf *.dae *.gltf *.glb);;All files (*)</source>
        <translation>Mesh (*.stl *.obj *.ply *.off *.3mf *.dae *.gltf *.glb);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>%1 is %2 mm long. Was it drawn in metres?</source>
        <translation>%1 è lungo %2 mm. È stato disegnato in metri?</translation>
    </message>
</context>
<context>
    <name>voluta::window::PageStack</name>
    <message>
        <source>Preview</source>
        <translation>Anteprima</translation>
    </message>
    <message>
        <source>Layers, paths and programs do not follow yet: press Plan.</source>
        <translation>Strati, percorsi e programmi non sono ancora aggiornati: premi Pianifica.</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Non aggiornato</translation>
    </message>
    <message>
        <source>Made before the settings were changed: press Plan.</source>
        <translation>Fatto prima che le impostazioni cambiassero: premi Pianifica.</translation>
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
        <source>cell</source>
        <translation>cella</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>Modifica cella</translation>
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
    <message>
        <source>Resume the print from here?</source>
        <translation>Riprendere la stampa da qui?</translation>
    </message>
    <message>
        <source>%1 % of the material counts as printed. The rest opens as a project of its own; “%2” stays as it was saved.</source>
        <translation>Il %1 % del materiale conta come stampato. Il resto si apre come progetto a sé; «%2» resta com&apos;era salvato.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Riprendi</translation>
    </message>
    <message>
        <source>Parts and projects (*.stl *.obj *.ply *.off *.3mf *.dae *.gltf *.glb *.txt *.voxels *.voluta);;All files (*)</source>
        <translation>Pezzi e progetti (*.stl *.obj *.ply *.off *.3mf *.dae *.gltf *.glb *.txt *.voxels *.voluta);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>Importa un braccio robotico</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf *.xml);;All files (*)</source>
        <translation>Descrizioni di robot (*.urdf *.xml);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>There is no folder for robots of your own: set HOME.</source>
        <translation>Non c&apos;è una cartella per i robot propri: imposta HOME.</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cella</translation>
    </message>
    <message>
        <source>Imported: cell %1</source>
        <translation>Importata: cella %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ReachView</name>
    <message>
        <source>move to best place</source>
        <translation>sposta al posto migliore</translation>
    </message>
</context>
<context>
    <name>voluta::window::Runs</name>
    <message>
        <source>1 voxel, %1 missed</source>
        <translation>1 voxel, mancati: %1</translation>
    </message>
    <message>
        <source>%1 voxels, %2 missed</source>
        <translation>%1 voxel, %2 mancati</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 strati</translation>
    </message>
    <message>
        <source>1 waypoint</source>
        <translation>1 punto</translation>
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
        <source>Compared. Select a row to adopt it.</source>
        <translation>Confronto fatto. Seleziona una riga per adottarla.</translation>
    </message>
    <message>
        <source>Preview: %1, 1 growth step</source>
        <translation>Anteprima: %1, 1 passo di crescita</translation>
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
    <message>
        <source>1 piece</source>
        <translation>1 pezzo</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 pezzi</translation>
    </message>
    <message>
        <source>%1 mm² need support</source>
        <translation>%1 mm² da supportare</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 strato</translation>
    </message>
    <message>
        <source>Cancelled. What was there before stays on show.</source>
        <translation>Annullato. Resta in vista ciò che c&apos;era prima.</translation>
    </message>
    <message>
        <source>Cancelled. Press Plan to begin anew.</source>
        <translation>Annullato. Premi Pianifica per ricominciare.</translation>
    </message>
    <message>
        <source>The run has stopped: see the findings.</source>
        <translation>L&apos;elaborazione si è fermata: vedi le segnalazioni.</translation>
    </message>
    <message>
        <source>Nothing can be planned like this: see the mark in the settings.</source>
        <translation>Così non si può pianificare nulla: vedi il segno nelle impostazioni.</translation>
    </message>
    <message>
        <source>planned time %1</source>
        <translation>tempo previsto %1</translation>
    </message>
    <message>
        <source>time on the controller %1</source>
        <translation>tempo sul controllore %1</translation>
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
    <name>voluta::window::SimulatePage</name>
    <message>
        <source>Collision solids</source>
        <translation>Solidi di collisione</translation>
    </message>
    <message>
        <source>Shows the solids that are checked for collisions over the arm</source>
        <translation>Mostra sopra il braccio i solidi controllati per le collisioni</translation>
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
    <name>voluta::window::StandChooser</name>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>stand it this way</source>
        <translation>appoggia in questo modo</translation>
    </message>
</context>
<context>
    <name>voluta::window::StatusLine</name>
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
    <message>
        <source>Prime</source>
        <translation>Innesco</translation>
    </message>
</context>
<context>
    <name>voluta::window::VerifyDialog</name>
    <message>
        <source>What the replay found</source>
        <translation>Che cosa ha trovato la verifica</translation>
    </message>
    <message>
        <source>Verify %1</source>
        <translation>Verifica %1</translation>
    </message>
    <message>
        <source>The program is read and replayed against the plan on show…</source>
        <translation>Il programma viene letto e confrontato con il piano mostrato…</translation>
    </message>
    <message>
        <source>%1: passed. It prints what was planned.</source>
        <translation>%1: accettato. Stampa ciò che era previsto.</translation>
    </message>
    <message>
        <source>%1: refused. Don&apos;t run it on the robot.</source>
        <translation>%1: rifiutato. Non eseguirlo sul robot.</translation>
    </message>
    <message>
        <source>What the replay found, the first %1 of %2</source>
        <translation>Che cosa ha trovato la verifica, i primi %1 di %2</translation>
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
        <translation>Voxel futuri velati</translation>
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
