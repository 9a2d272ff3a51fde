<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>关闭窗口</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>快捷键(&amp;K)…</translation>
    </message>
    <message>
        <source>See and change the keys</source>
        <translation>查看和更改快捷键</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Light text on a dark background</source>
        <translation>深色背景，浅色文字</translation>
    </message>
    <message>
        <source>P&amp;icture…</source>
        <translation>图片(&amp;I)…</translation>
    </message>
    <message>
        <source>Save the viewport as a PNG</source>
        <translation>将视图保存为 PNG</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>The whole screen</source>
        <translation>占满整个屏幕</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>All keys at a glance</source>
        <translation>所有快捷键一览</translation>
    </message>
    <message>
        <source>Show &amp;log</source>
        <translation>显示日志(&amp;L)</translation>
    </message>
    <message>
        <source>Files opened, plans, findings and errors</source>
        <translation>打开的文件、规划、问题和错误</translation>
    </message>
    <message>
        <source>&amp;About Voluta</source>
        <translation>关于 Voluta(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>版本和许可证</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>导出(&amp;E)</translation>
    </message>
    <message>
        <source>Robot &amp;programs…</source>
        <translation>机器人程序(&amp;P)…</translation>
    </message>
    <message>
        <source>Write the chosen programs into a folder</source>
        <translation>将所选程序写入文件夹</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>层(&amp;L)</translation>
    </message>
    <message>
        <source>Go to this page</source>
        <translation>转到此页</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>移动(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>旋转(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>缩放(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Lay on face</source>
        <translation>按面放平(&amp;L)</translation>
    </message>
    <message>
        <source>Click the face to place on the plate</source>
        <translation>点击要贴到打印板上的面</translation>
    </message>
    <message>
        <source>&amp;Drop to plate</source>
        <translation>落到打印板(&amp;D)</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>将零件降到打印板上</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>居中(&amp;C)</translation>
    </message>
    <message>
        <source>Centres the part on the plate</source>
        <translation>将零件放到打印板中央</translation>
    </message>
    <message>
        <source>Place on touched &amp;points…</source>
        <translation>按触碰点放置(&amp;P)…</translation>
    </message>
    <message>
        <source>Moves the part to a cylinder measured by touching</source>
        <translation>将零件移到通过触碰测得的圆柱上</translation>
    </message>
    <message>
        <source>&amp;Prepare</source>
        <translation>准备(&amp;P)</translation>
    </message>
    <message>
        <source>Reset all &amp;parameters</source>
        <translation>重置所有参数(&amp;P)</translation>
    </message>
    <message>
        <source>Resets every parameter to its default</source>
        <translation>将每个参数恢复为默认值</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>仿真(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>新建项目(&amp;N)</translation>
    </message>
    <message>
        <source>Start without a part</source>
        <translation>从无零件开始</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a mesh or a project</source>
        <translation>打开网格或项目</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>花瓶</translation>
    </message>
    <message>
        <source>A fluted vase, 60 mm high</source>
        <translation>带凹槽的花瓶，高 60 mm</translation>
    </message>
    <message>
        <source>Mushroom</source>
        <translation>蘑菇</translation>
    </message>
    <message>
        <source>A wide cap on a stem, made of voxels</source>
        <translation>细柄宽盖，由体素组成</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>分叉</translation>
    </message>
    <message>
        <source>A stem with two branches, made of voxels</source>
        <translation>一根主干、两根分枝，由体素组成</translation>
    </message>
    <message>
        <source>Dumb-bell for tension</source>
        <translation>拉伸哑铃试样</translation>
    </message>
    <message>
        <source>A specimen of 165 × 19 × 3 mm</source>
        <translation>165 × 19 × 3 mm 的试样</translation>
    </message>
    <message>
        <source>Bar for bending</source>
        <translation>弯曲试条</translation>
    </message>
    <message>
        <source>A specimen of 250 × 10 × 5 mm</source>
        <translation>250 × 10 × 5 mm 的试样</translation>
    </message>
    <message>
        <source>Plate with a hole</source>
        <translation>带孔板</translation>
    </message>
    <message>
        <source>A specimen of 120 × 60 × 3 mm</source>
        <translation>120 × 60 × 3 mm 的试样</translation>
    </message>
    <message>
        <source>Curved bar on its mould</source>
        <translation>模具上的弧形条</translation>
    </message>
    <message>
        <source>Seven layers around a cylinder of 60 mm radius</source>
        <translation>围绕半径 60 mm 圆柱的七层</translation>
    </message>
    <message>
        <source>Rib on a gable roof</source>
        <translation>双坡屋顶上的肋</translation>
    </message>
    <message>
        <source>Ten layers over both slopes; the nozzle tilts by 60°</source>
        <translation>跨两个坡面的十层；喷嘴倾斜 60°</translation>
    </message>
    <message>
        <source>Rib on a half cylinder</source>
        <translation>半圆柱上的肋</translation>
    </message>
    <message>
        <source>Ten layers around it; the nozzle tilts by 87°</source>
        <translation>环绕其上的十层；喷嘴倾斜 87°</translation>
    </message>
    <message>
        <source>Accuracy plate</source>
        <translation>精度测试板</translation>
    </message>
    <message>
        <source>Slots and a hole of known sizes, to be measured</source>
        <translation>已知尺寸的槽和孔，供测量</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the project under a new name</source>
        <translation>以新名称保存项目</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>规划(&amp;P)</translation>
    </message>
    <message>
        <source>From the part to verified robot programs</source>
        <translation>从零件到经过验证的机器人程序</translation>
    </message>
    <message>
        <source>Plan up to the &amp;layers</source>
        <translation>只规划到层(&amp;L)</translation>
    </message>
    <message>
        <source>Stops before tool-paths and motion</source>
        <translation>在生成工具路径和运动之前停止</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Stop; the last results stay visible</source>
        <translation>停止；上次结果仍然显示</translation>
    </message>
    <message>
        <source>&amp;Update voxels while editing</source>
        <translation>编辑时更新体素(&amp;U)</translation>
    </message>
    <message>
        <source>After the first plan, voxels follow the settings; layers and paths wait for Plan</source>
        <translation>首次规划后体素随设置更新；层和路径需等“规划”</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>前(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>上(&amp;T)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>下(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>斜视(&amp;O)</translation>
    </message>
    <message>
        <source>View from this side</source>
        <translation>从这一侧观察</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>导出(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近文件(&amp;R)</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>示例(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>显示全部(&amp;E)</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>使全部内容适合视图</translation>
    </message>
    <message>
        <source>&amp;Section plane</source>
        <translation>剖切面(&amp;S)</translation>
    </message>
    <message>
        <source>Cut the view open with a plane</source>
        <translation>用平面剖开视图</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>图例(&amp;L)</translation>
    </message>
    <message>
        <source>Meaning of the colours in the view</source>
        <translation>视图中颜色的含义</translation>
    </message>
    <message>
        <source>&amp;Unrolled layer</source>
        <translation>展开层(&amp;U)</translation>
    </message>
    <message>
        <source>Shows layers around an axis unrolled, next to the view</source>
        <translation>在视图旁显示绕轴层的展开图</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>Play or pause the time-line</source>
        <translation>播放或暂停时间线</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>下一个移动</translation>
    </message>
    <message>
        <source>One move forward</source>
        <translation>前进一个移动</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>上一个移动</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>后退一个移动</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>下一层</translation>
    </message>
    <message>
        <source>One layer forward</source>
        <translation>前进一层</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>上一层</translation>
    </message>
    <message>
        <source>One layer back</source>
        <translation>后退一层</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>About Voluta</source>
        <translation>关于 Voluta</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;3D printing with robot arms: layers without support, tool-paths, motion checked against the growing part, and programs verified by replay.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Voluta %1&lt;/h3&gt;&lt;p&gt;用机械臂进行 3D 打印：无需支撑的层、工具路径、针对不断生长的零件检查的运动，以及经回放验证的程序。&lt;/p&gt;&lt;p&gt;自由软件，采用 GNU 通用公共许可证第 3 版或更高版本。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>撤销 %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>重做 %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>&amp;Resume print from here…</source>
        <translation>从此处继续打印(&amp;R)…</translation>
    </message>
    <message>
        <source>Opens the rest of a print stopped at this moment as a new project</source>
        <translation>将在此刻停止的打印的剩余部分作为新项目打开</translation>
    </message>
    <message>
        <source>&amp;Verify a program…</source>
        <translation>验证程序(&amp;V)…</translation>
    </message>
    <message>
        <source>Replay a program from disk against the plan shown</source>
        <translation>回放磁盘上的程序，与当前显示的规划对照</translation>
    </message>
    <message>
        <source>Edit &amp;cell…</source>
        <translation>编辑工作单元(&amp;C)…</translation>
    </message>
    <message>
        <source>Robot, and positions of nozzle, plate and obstacles</source>
        <translation>机器人，以及喷嘴、打印板和障碍物的位置</translation>
    </message>
    <message>
        <source>Import robot &amp;arm…</source>
        <translation>导入机械臂(&amp;A)…</translation>
    </message>
    <message>
        <source>Your own robot from its URDF, with a cell</source>
        <translation>从 URDF 导入自己的机器人，并建立工作单元</translation>
    </message>
    <message>
        <source>D&amp;uplicate part</source>
        <translation>复制零件(&amp;U)</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part beside the others</source>
        <translation>在其他零件旁添加所选零件的副本</translation>
    </message>
    <message>
        <source>&amp;Remove part</source>
        <translation>移除零件(&amp;R)</translation>
    </message>
    <message>
        <source>A&amp;dd part…</source>
        <translation>添加零件(&amp;D)…</translation>
    </message>
    <message>
        <source>Adds a part beside the others</source>
        <translation>在其他零件旁添加一个零件</translation>
    </message>
    <message>
        <source>&amp;Arrange parts</source>
        <translation>排列零件(&amp;A)</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>将所有零件并排放置，并为打印头留出空间</translation>
    </message>
    <message>
        <source>Processes and &amp;materials…</source>
        <translation>工艺和材料(&amp;M)…</translation>
    </message>
    <message>
        <source>Nozzle, bead sizes, speeds, head; own processes and materials</source>
        <translation>喷嘴、挤出线尺寸、速度、打印头；自定义工艺和材料</translation>
    </message>
    <message>
        <source>Compare with a recor&amp;ded run…</source>
        <translation>与运行记录比较(&amp;D)…</translation>
    </message>
    <message>
        <source>Lays a run that the controller recorded beside the plan shown</source>
        <translation>将控制器记录的运行与当前显示的规划并列</translation>
    </message>
    <message>
        <source>&amp;Mill from a block…</source>
        <translation>从毛坯铣削(&amp;M)…</translation>
    </message>
    <message>
        <source>Mills the part out of a block and writes the G-code, checked on the block</source>
        <translation>从毛坯铣出零件并写出 G-code，在毛坯上检查</translation>
    </message>
    <message>
        <source>Print to&amp;gether with other machines…</source>
        <translation>与其他机器一起打印(&amp;G)…</translation>
    </message>
    <message>
        <source>Places other machines beside this one and finds an order of work in which they do not meet</source>
        <translation>在本机旁放置其他机器，并找出互不相撞的工作顺序</translation>
    </message>
    <message>
        <source>Moves the part: drag a handle, or type X 10 Enter</source>
        <translation>移动零件：拖动手柄，或输入 X 10 Enter</translation>
    </message>
    <message>
        <source>Rotates the part: drag a ring, or type Z 45 Enter</source>
        <translation>旋转零件：拖动圆环，或输入 Z 45 Enter</translation>
    </message>
    <message>
        <source>Scales the part: drag a handle, or type 120 Enter for 120 %</source>
        <translation>缩放零件：拖动手柄，或输入 120 Enter 表示 120 %</translation>
    </message>
    <message>
        <source>Removes the selected parts from the plate</source>
        <translation>从打印板上移除所选零件</translation>
    </message>
    <message>
        <source>&amp;Number of copies…</source>
        <translation>份数(&amp;N)…</translation>
    </message>
    <message>
        <source>Prints the selected part several times, or as often as the plate has room</source>
        <translation>将所选零件打印多份，或打印打印板能容纳的最多份数</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copies the selected parts with their settings</source>
        <translation>复制所选零件及其设置</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Adds the copied parts beside the others</source>
        <translation>将复制的零件添加到其他零件旁</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>Selects all parts, to copy or to remove them</source>
        <translation>选中所有零件，以便复制或移除</translation>
    </message>
    <message>
        <source>Show the &amp;part</source>
        <translation>显示零件(&amp;P)</translation>
    </message>
    <message>
        <source>Fit the selected part into the view</source>
        <translation>使所选零件适合视图</translation>
    </message>
    <message>
        <source>Show the &amp;arm</source>
        <translation>显示机械臂(&amp;A)</translation>
    </message>
    <message>
        <source>On the Prepare page, shows the arm whole instead of dimmed behind the part</source>
        <translation>在“准备”页完整显示机械臂，而不是在零件后淡显</translation>
    </message>
    <message>
        <source>&amp;Find a command or setting…</source>
        <translation>查找命令或设置(&amp;F)…</translation>
    </message>
    <message>
        <source>Lists commands and settings while you type</source>
        <translation>输入时列出命令和设置</translation>
    </message>
    <message>
        <source>&amp;Quote…</source>
        <translation>报价(&amp;Q)…</translation>
    </message>
    <message>
        <source>Cost of the print, and its page for a customer</source>
        <translation>打印成本，以及给客户的报价页</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>The page of the manual about what is shown</source>
        <translation>手册中关于当前内容的页面</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>测量(&amp;E)</translation>
    </message>
    <message>
        <source>Click places on the part: radius, wall, distance, angle</source>
        <translation>点击零件上的位置：半径、壁厚、距离、角度</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Dark text on a light background</source>
        <translation>浅色背景上的深色文字</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>高对比度(&amp;H)</translation>
    </message>
    <message>
        <source>White text on black, with strong outlines</source>
        <translation>黑底白字，轮廓醒目</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>影片(&amp;F)…</translation>
    </message>
    <message>
        <source>Save a film of the robot that prints the part (WebM)</source>
        <translation>保存机器人打印零件的影片 (WebM)</translation>
    </message>
    <message>
        <source>C&amp;ut…</source>
        <translation>切割(&amp;U)…</translation>
    </message>
    <message>
        <source>Cuts the part in two with a plane, with dowels, pegs or a dovetail</source>
        <translation>用平面将零件切成两半，可加圆销、凸销或燕尾榫</translation>
    </message>
    <message>
        <source>Split to &amp;parts</source>
        <translation>拆分为零件(&amp;P)</translation>
    </message>
    <message>
        <source>Makes a part of each body of the mesh</source>
        <translation>将网格的每个实体变成一个零件</translation>
    </message>
    <message>
        <source>Re&amp;name part</source>
        <translation>重命名零件(&amp;N)</translation>
    </message>
    <message>
        <source>Edits the name of the part in the tree</source>
        <translation>在树中编辑零件名称</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>外观(&amp;K)</translation>
    </message>
    <message>
        <source>Darken cor&amp;ners</source>
        <translation>使角落变暗(&amp;N)</translation>
    </message>
    <message>
        <source>Darkens corners and gaps, so that shapes are clearer; slow without a graphics card</source>
        <translation>使角落和缝隙变暗，让形状更清晰；没有显卡时较慢</translation>
    </message>
    <message>
        <source>Re&amp;gions…</source>
        <translation>区域(&amp;G)…</translation>
    </message>
    <message>
        <source>Places in the part with settings, or layers, of their own</source>
        <translation>零件中具有自己的设置或层的位置</translation>
    </message>
    <message>
        <source>Add &amp;region…</source>
        <translation>添加区域(&amp;R)…</translation>
    </message>
    <message>
        <source>Adds a place with settings, or layers, of its own</source>
        <translation>添加具有自己的设置或层的位置</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>&quot;{text}&quot; is not a point</source>
        <translation>“{text}”不是一个点</translation>
    </message>
    <message>
        <source>&apos;end&apos; closes no function</source>
        <translation>&apos;end&apos; 没有对应的函数</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not a number</source>
        <translation>“{attribute}”不是数字</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not an integer</source>
        <translation>“{attribute}”不是整数</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex</source>
        <translation>“{corner}”不是顶点的索引</translation>
    </message>
    <message>
        <source>&apos;{corner}&apos; is not the index of a vertex read so far</source>
        <translation>“{corner}”不是已读取顶点的索引</translation>
    </message>
    <message>
        <source>&apos;{loaded}&apos; is not unloaded</source>
        <translation>“{loaded}”未卸载</translation>
    </message>
    <message>
        <source>&apos;{member}&apos; in it {what}</source>
        <translation>其中的“{member}”{what}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is called outside the function</source>
        <translation>“{name}”在函数外被调用</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not of type {type}</source>
        <translation>“{name}”不是 {type} 类型</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not declared as {type}</source>
        <translation>“{name}”未声明为 {type}</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is not known to the reader</source>
        <translation>读取器不认识“{name}”</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a weight</source>
        <translation>“{text}”不是权重</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a number</source>
        <translation>“{text}”不是数字</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not expected here</source>
        <translation>此处不应出现“{text}”</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not key=value</source>
        <translation>“{text}”不是 键=值 形式</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is neither true nor false</source>
        <translation>“{value}”既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a number</source>
        <translation>“{value}”不是数字</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not a whole number</source>
        <translation>“{value}”不是整数</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is not one of {choices}</source>
        <translation>“{value}”不在 {choices} 之中</translation>
    </message>
    <message>
        <source>&apos;{value}&apos; is out of range</source>
        <translation>“{value}”超出范围</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not known to the reader</source>
        <translation>读取器不认识“{word}”</translation>
    </message>
    <message>
        <source>--ik: the quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>--ik：四元数的长度为 {length:.4g}，而不是 1</translation>
    </message>
    <message>
        <source>0: round rod. 3 or more: prism; its diameter is measured across the corners.</source>
        <translation>0：圆棒。3 或以上：棱柱；其直径按对角测量。</translation>
    </message>
    <message>
        <source>Adaptive layers: largest distance between the edges of layers and the surface.</source>
        <translation>自适应层：层边缘与表面之间的最大距离。</translation>
    </message>
    <message>
        <source>Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, toolpath.vtp and trajectory.csv.</source>
        <translation>另外写出 voxels.vti、pieces/N.stl、pieces/cuts.json、layers.vtp、toolpath.vtp 和 trajectory.csv。</translation>
    </message>
    <message>
        <source>Also writes programs that the replay refused, as refused-NAME. For inspection only: never run them.</source>
        <translation>回放拒绝的程序也以 refused-NAME 写出。仅供查看：切勿运行。</translation>
    </message>
    <message>
        <source>Beads along circles are written as arcs (G2 and G3, movec, MoveC, CIRC), within the resolution or 0.02 mm.</source>
        <translation>沿圆的挤出线写成圆弧（G2 和 G3、movec、MoveC、CIRC），误差在分辨率或 0.02 mm 以内。</translation>
    </message>
    <message>
        <source>Layers at constant radius around the axis, or at constant distance from the rod&apos;s profile.</source>
        <translation>围绕轴线半径恒定的层，或与芯棒轮廓距离恒定的层。</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>挤出线</translation>
    </message>
    <message>
        <source>an arc on a table that tilts is not understood</source>
        <translation>不支持倾斜工作台上的圆弧</translation>
    </message>
    <message>
        <source>export straight lines</source>
        <translation>导出直线</translation>
    </message>
    <message>
        <source>Number of beads along the outline of each layer.</source>
        <translation>沿每层轮廓的挤出线数量。</translation>
    </message>
    <message>
        <source>Colli-
sions</source>
        <translation>碰
撞</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>凸前沿</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>分解</translation>
    </message>
    <message>
        <source>Direction of straight lines on the first layer, measured from x to y.</source>
        <translation>第一层直线的方向，从 x 向 y 测量。</translation>
    </message>
    <message>
        <source>Minimum distance of everything but the print head from printed material.</source>
        <translation>除打印头外的所有部分与已打印材料的最小距离。</translation>
    </message>
    <message>
        <source>Minimum distance between links, plate, nozzle holder and obstacles.</source>
        <translation>连杆、打印板、喷嘴座和障碍物之间的最小距离。</translation>
    </message>
    <message>
        <source>ENDMODULE is missing: the file was cut short</source>
        <translation>缺少 ENDMODULE：文件被截断</translation>
    </message>
    <message>
        <source>ENDPROC without a procedure</source>
        <translation>ENDPROC 没有对应的过程</translation>
    </message>
    <message>
        <source>Fermat spiral</source>
        <translation>费马螺旋</translation>
    </message>
    <message>
        <source>Field rounds</source>
        <translation>场迭代轮数</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前沿</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>间隙填充</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>生长步</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Largest overhang, measured from the vertical, that prints without support; in all modes except curved.</source>
        <translation>无需支撑即可打印的最大悬垂，从竖直方向测量；曲面层以外的所有模式。</translation>
    </message>
    <message>
        <source>Minimum distance by which the nozzle lifts off the part before it travels.</source>
        <translation>喷嘴空移前抬离零件的最小距离。</translation>
    </message>
    <message>
        <source>How many rotations of the part about the nozzle&apos;s axis are tried at each point.</source>
        <translation>每个点尝试零件绕喷嘴轴线旋转的次数。</translation>
    </message>
    <message>
        <source>Points of beads are omitted if the path, the nozzle&apos;s direction, the bead&apos;s section and the speed stay within tolerance without them; this is the tolerance of the path. 0: all points are written. Cells with external axes keep all points.</source>
        <translation>如果省略某些点后，路径、喷嘴方向、挤出线截面和速度仍在公差内，则省略这些点；此值为路径公差。0：写出所有点。带外部轴的工作单元保留所有点。</translation>
    </message>
    <message>
        <source>Rotation of straight lines from layer to layer; 0: the same direction throughout.</source>
        <translation>直线方向逐层旋转的角度；0：方向始终相同。</translation>
    </message>
    <message>
        <source>Maximum number of rounds that fit the growth order and the smooth field to each other. 0: layers follow the growth order.</source>
        <translation>生长顺序与平滑场相互拟合的最大轮数。0：层遵循生长顺序。</translation>
    </message>
    <message>
        <source>Pattern that fills the interior of each layer.</source>
        <translation>填充每层内部的图案。</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>层</translation>
    </message>
    <message>
        <source>Layer spacing</source>
        <translation>层间距</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>层</translation>
    </message>
    <message>
        <source>Surface on which flattening layers end: flat (at the part&apos;s top), flat:Z, radius:R (a larger cylinder) or mesh:FILE, placed together with the platform&apos;s mesh.</source>
        <translation>展平层终止的表面：flat（零件顶部）、flat:Z、radius:R（更大的圆柱）或 mesh:FILE，与平台的网格一起放置。</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>加载</translation>
    </message>
    <message>
        <source>Missed, cascade</source>
        <translation>遗漏，连带</translation>
    </message>
    <message>
        <source>Missed, shadowed</source>
        <translation>遗漏，被遮蔽</translation>
    </message>
    <message>
        <source>Missed, unreached</source>
        <translation>遗漏，未到达</translation>
    </message>
    <message>
        <source>Mode flat: a JSON file or JSON text with the plane or quadrilateral of each layer. Empty: horizontal layers.</source>
        <translation>平面层（flat 模式）：JSON 文件或 JSON 文本，给出每层的平面或四边形。空：水平层。</translation>
    </message>
    <message>
        <source>Mode planar: a JSON file or JSON text with a point and a normal for each cutting plane, in cutting order. Empty: automatic.</source>
        <translation>平面分块（planar 模式）：JSON 文件或 JSON 文本，按切割顺序给出每个切割平面的点和法线。空：自动。</translation>
    </message>
    <message>
        <source>Mode planar: materials or filaments of the pieces, separated by commas. The list starts over if there are more pieces. Empty: the process&apos;s material.</source>
        <translation>平面分块（planar 模式）：各分块的材料或耗材，以逗号分隔。分块更多时从头循环。空：使用工艺的材料。</translation>
    </message>
    <message>
        <source>Mode planar: beam is a beam search that checks the true shape of the head; greedy is the published scheme, based on the part&apos;s skeleton.</source>
        <translation>平面分块（planar 模式）：beam 是检查打印头真实形状的束搜索；greedy 是已发表的方案，基于零件的骨架。</translation>
    </message>
    <message>
        <source>Mode substrate: layers at constant distance from the surface, on spheres, on cylinders along x, or flattening from the surface to an end surface with varying thickness.</source>
        <translation>给定表面（substrate 模式）：与表面保持恒定距离的层、球面上的层、沿 x 的圆柱上的层，或以变化的厚度从表面展平到终止面的层。</translation>
    </message>
    <message>
        <source>Height of the first layer; in all modes except curved. 0: same as the other layers.</source>
        <translation>第一层的高度；曲面层以外的所有模式。0：与其他层相同。</translation>
    </message>
    <message>
        <source>Modes planar and flat: thinner layers where the surface is inclined, within the process&apos;s limits.</source>
        <translation>平面分块和平面层（planar、flat 模式）：在表面倾斜处使用较薄的层，不超出工艺限制。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Needs support</source>
        <translation>需要支撑</translation>
    </message>
    <message>
        <source>For helical infill: 0 winds around the axis, 90 runs along it.</source>
        <translation>用于螺旋填充：0 环绕轴线，90 沿轴线。</translation>
    </message>
    <message>
        <source>Centre of spheres and cylinders: x,y,z in mm. Empty: that of the sphere or cylinder below the part, or a point below the part.</source>
        <translation>球面和圆柱的中心：x,y,z，单位 mm。空：零件下方球面或圆柱的中心，或零件下方的一点。</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file with such pairs. A step needs two pairs at the same x. Beyond the pairs the rod keeps its own diameter. Empty: straight.</source>
        <translation>x 与半径的数对，单位 mm，如 -20,2.5 0,2.5 0,3.5 20,3.5，或包含此类数对的文件。台阶需要 x 相同的两个数对。数对范围之外芯棒保持自身直径。空：直棒。</translation>
    </message>
    <message>
        <source>Peeling rank</source>
        <translation>剥离次序</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>放置</translation>
    </message>
    <message>
        <source>RAPID (ABB)</source>
        <translation>RAPID (ABB)</translation>
    </message>
    <message>
        <source>Reach
%</source>
        <translation>可达
%</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>芯棒</translation>
    </message>
    <message>
        <source>Scheme greedy: number of thickness classes that distinguish the part&apos;s branches. 0: automatic.</source>
        <translation>greedy 方案：区分零件分枝的厚度等级数。0：自动。</translation>
    </message>
    <message>
        <source>Scheme greedy: a point x,y,z (mm) on the piece to print first; that piece must touch the plate. Empty: the piece with the largest contact area.</source>
        <translation>greedy 方案：首先打印的分块上的一点 x,y,z (mm)；该分块必须接触打印板。空：接触面积最大的分块。</translation>
    </message>
    <message>
        <source>Head shape that must clear the part printed so far. flat: a plate of unlimited width. nozzle: the real head where voxels would be lost otherwise, and under wide roofs. auto: the real head only under wide roofs.</source>
        <translation>必须避开已打印零件的打印头形状。flat：宽度无限的平板。nozzle：在否则会丢失体素处以及宽顶之下使用真实打印头。auto：仅在宽顶之下使用真实打印头。</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>裙边或帽檐</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Current growth step</source>
        <translation>当前生长步</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>支撑</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>支撑</translation>
    </message>
    <message>
        <source>Supports
mm³</source>
        <translation>支撑
mm³</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Tilt of the nozzle</source>
        <translation>喷嘴倾斜</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Too thick to print</source>
        <translation>过厚，无法打印</translation>
    </message>
    <message>
        <source>Too thin to print</source>
        <translation>过薄，无法打印</translation>
    </message>
    <message>
        <source>Tool-paths</source>
        <translation>工具路径</translation>
    </message>
    <message>
        <source>URScript (Universal Robots)</source>
        <translation>URScript (Universal Robots)</translation>
    </message>
    <message>
        <source>Use voxel width {fits}</source>
        <translation>使用体素宽度 {fits}</translation>
    </message>
    <message>
        <source>Voxel width</source>
        <translation>体素宽度</translation>
    </message>
    <message>
        <source>WaitTime without a time in seconds</source>
        <translation>WaitTime 缺少以秒为单位的时间</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Nominal layer height; limited by the process.</source>
        <translation>名义层高；受工艺限制。</translation>
    </message>
    <message>
        <source>Nominal bead width; limited by the process.</source>
        <translation>名义挤出线宽；受工艺限制。</translation>
    </message>
    <message>
        <source>The axis of the part that is aligned with the rod. auto: the axis parallel to its sides.</source>
        <translation>零件上与芯棒对齐的轴。auto：与其侧面平行的轴。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Voxel width used for growth; the layer height is independent of it.</source>
        <translation>用于生长的体素宽度；层高与其无关。</translation>
    </message>
    <message>
        <source>an arc from a position that is not known</source>
        <translation>圆弧的起始位置未知</translation>
    </message>
    <message>
        <source>an arc that changes its height is not understood</source>
        <translation>不支持高度变化的圆弧</translation>
    </message>
    <message>
        <source>an arc without its centre, I and J</source>
        <translation>圆弧缺少圆心 I 和 J</translation>
    </message>
    <message>
        <source>arc fitting</source>
        <translation>圆弧拟合</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for, or slice it with beads of this process</source>
        <translation>选择文件切片时所用的工艺，或用此工艺的挤出线重新切片</translation>
    </message>
    <message>
        <source>movec needs two poses</source>
        <translation>movec 需要两个位姿</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>the end of an arc is not at the distance of its start from the centre</source>
        <translation>圆弧终点与起点到圆心的距离不同</translation>
    </message>
    <message>
        <source>the file heats {heat}: programs heat as the material states, choose one that fits</source>
        <translation>文件要求加热 {heat}：程序按材料设定加热，请选择合适的材料</translation>
    </message>
    <message>
        <source>the three points of an arc are on a line</source>
        <translation>圆弧的三个点共线</translation>
    </message>
    <message>
        <source>unknown G command</source>
        <translation>未知的 G 指令</translation>
    </message>
    <message>
        <source>a PLY file begins with &quot;ply&quot;</source>
        <translation>PLY 文件应以 &quot;ply&quot; 开头</translation>
    </message>
    <message>
        <source>a call of a module that is not loaded</source>
        <translation>调用了未加载的模块</translation>
    </message>
    <message>
        <source>support column of {voxels} from {foot}: it carries {carried} that would be missed</source>
        <translation>从 {foot} 起的支撑柱，共 {voxels}：承载 {carried}，否则会被遗漏</translation>
    </message>
    <message>
        <source>a configuration that is not in whole quarter turns</source>
        <translation>构型不是整数个四分之一圈</translation>
    </message>
    <message>
        <source>a digital output must be 0 or 1</source>
        <translation>数字输出必须为 0 或 1</translation>
    </message>
    <message>
        <source>a direction needs nX, nY and nZ</source>
        <translation>方向需要 nX、nY 和 nZ</translation>
    </message>
    <message>
        <source>a direction is not a unit vector</source>
        <translation>方向不是单位向量</translation>
    </message>
    <message>
        <source>a face refers to vertex {vertex} of {vertices}</source>
        <translation>面引用了顶点 {vertex}，共 {vertices} 个</translation>
    </message>
    <message>
        <source>a face needs its number of corners, then the corners</source>
        <translation>面需要先给出角点数，再给出角点</translation>
    </message>
    <message>
        <source>a face needs at least three corners</source>
        <translation>面至少需要三个角点</translation>
    </message>
    <message>
        <source>a facet with fewer than three vertices</source>
        <translation>面片的顶点少于三个</translation>
    </message>
    <message>
        <source>flow of {flow:.1f}, above the extruder&apos;s limit of {limit:.1f#}</source>
        <translation>流量 {flow:.1f}，超过挤出机的极限 {limit:.1f#}</translation>
    </message>
    <message>
        <source>a joint value far outside any limit</source>
        <translation>关节值远超任何极限</translation>
    </message>
    <message>
        <source>use a larger platform, or turn the part</source>
        <translation>使用更大的平台，或转动零件</translation>
    </message>
    <message>
        <source>use a larger platform or supports, or join this piece to the part</source>
        <translation>使用更大的平台或支撑，或将此分块与零件相连</translation>
    </message>
    <message>
        <source>a line does not end with CR LF</source>
        <translation>有一行未以 CR LF 结尾</translation>
    </message>
    <message>
        <source>a line without a command</source>
        <translation>有一行没有指令</translation>
    </message>
    <message>
        <source>a list has an invalid length</source>
        <translation>列表长度无效</translation>
    </message>
    <message>
        <source>triangles with missing vertices</source>
        <translation>三角形缺少顶点</translation>
    </message>
    <message>
        <source>a module must begin with MODULE and its name</source>
        <translation>模块必须以 MODULE 及其名称开头</translation>
    </message>
    <message>
        <source>a motion before X, Y and Z are all known</source>
        <translation>在 X、Y、Z 全部已知之前就有运动</translation>
    </message>
    <message>
        <source>a motion before any speed (F)</source>
        <translation>在任何速度 (F) 之前就有运动</translation>
    </message>
    <message>
        <source>the motion never arrives: no speed or acceleration</source>
        <translation>运动永远无法到达：没有速度或加速度</translation>
    </message>
    <message>
        <source>a motion with a word {letter} is not understood</source>
        <translation>不支持带字 {letter} 的运动</translation>
    </message>
    <message>
        <source>a motion without a target</source>
        <translation>运动没有目标</translation>
    </message>
    <message>
        <source>a name is declared twice</source>
        <translation>名称重复声明</translation>
    </message>
    <message>
        <source>use a narrower bead or a lower layer height for fine detail, supports for areas that begin in the air</source>
        <translation>细节处使用更窄的挤出线或更低的层高；从空中开始的区域使用支撑</translation>
    </message>
    <message>
        <source>a picture of {width} x {height} pixels cannot be drawn</source>
        <translation>无法绘制 {width} x {height} 像素的图片</translation>
    </message>
    <message>
        <source>a platform must be a mesh, not a voxel object</source>
        <translation>平台必须是网格，不能是体素对象</translation>
    </message>
    <message>
        <source>a point has NaN or infinite coordinates</source>
        <translation>点的坐标为 NaN 或无穷大</translation>
    </message>
    <message>
        <source>a point needs three numbers</source>
        <translation>点需要三个数字</translation>
    </message>
    <message>
        <source>point too far from the origin</source>
        <translation>点离原点太远</translation>
    </message>
    <message>
        <source>a pose before set_tcp: its TCP is unknown</source>
        <translation>位姿出现在 set_tcp 之前：其 TCP 未知</translation>
    </message>
    <message>
        <source>a pose far outside any robot&apos;s reach</source>
        <translation>位姿远超任何机器人的可达范围</translation>
    </message>
    <message>
        <source>a pose p[x,y,z,rx,ry,rz] is needed</source>
        <translation>需要位姿 p[x,y,z,rx,ry,rz]</translation>
    </message>
    <message>
        <source>a position far outside any robot&apos;s reach</source>
        <translation>位置远超任何机器人的可达范围</translation>
    </message>
    <message>
        <source>a property of unknown type</source>
        <translation>属性类型未知</translation>
    </message>
    <message>
        <source>a quadrilateral cannot cut a part</source>
        <translation>四边形不能切割零件</translation>
    </message>
    <message>
        <source>a quadrilateral needs four corners</source>
        <translation>四边形需要四个角点</translation>
    </message>
    <message>
        <source>a quaternion that is not normalised</source>
        <translation>四元数未归一化</translation>
    </message>
    <message>
        <source>a rod is round or has at least three sides</source>
        <translation>芯棒为圆形或至少有三条边</translation>
    </message>
    <message>
        <source>a rod needs at least two points</source>
        <translation>芯棒至少需要两个点</translation>
    </message>
    <message>
        <source>row beyond the end of its array</source>
        <translation>行超出其数组末尾</translation>
    </message>
    <message>
        <source>a second, different TCP</source>
        <translation>第二个不同的 TCP</translation>
    </message>
    <message>
        <source>a second, different tool</source>
        <translation>第二个不同的工具</translation>
    </message>
    <message>
        <source>a shifted origin is not understood</source>
        <translation>不支持偏移的原点</translation>
    </message>
    <message>
        <source>a space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>an invalid speed</source>
        <translation>速度无效</translation>
    </message>
    <message>
        <source>a speed that is not positive</source>
        <translation>速度不是正数</translation>
    </message>
    <message>
        <source>a statement outside the procedure</source>
        <translation>过程之外的语句</translation>
    </message>
    <message>
        <source>a step at the end of the rod</source>
        <translation>芯棒端部有台阶</translation>
    </message>
    <message>
        <source>target with fewer than six joints</source>
        <translation>目标的关节少于六个</translation>
    </message>
    <message>
        <source>an invalid time</source>
        <translation>时间无效</translation>
    </message>
    <message>
        <source>a transform does not have twelve numbers</source>
        <translation>变换没有十二个数字</translation>
    </message>
    <message>
        <source>a transform contains a value that is not a number</source>
        <translation>变换中含有非数字的值</translation>
    </message>
    <message>
        <source>a triangle refers to the missing vertex {vertex}</source>
        <translation>三角形引用了不存在的顶点 {vertex}</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>顶点需要三个数字</translation>
    </message>
    <message>
        <source>use a voxel width of at most {fits}</source>
        <translation>使用不超过 {fits} 的体素宽度</translation>
    </message>
    <message>
        <source>wall {usual:.2f} thick ({thinnest:.2f} at its thinnest), thinner than a voxel of {voxel}</source>
        <translation>壁厚 {usual:.2f}（最薄处 {thinnest:.2f}），比一个体素 {voxel} 还薄</translation>
    </message>
    <message>
        <source>a waypoint number has to be an integer of at least -1</source>
        <translation>路径点编号必须是不小于 -1 的整数</translation>
    </message>
    <message>
        <source>a work object must name the mechanical unit that moves it, or be stationary</source>
        <translation>工件坐标对象必须指明移动它的机械单元，或为静止</translation>
    </message>
    <message>
        <source>an invalid zone</source>
        <translation>区域 (zone) 无效</translation>
    </message>
    <message>
        <source>a zone for orientation or external axes smaller than the TCP&apos;s</source>
        <translation>姿态或外部轴的区域 (zone) 小于 TCP 的区域</translation>
    </message>
    <message>
        <source>a {type} must have other components</source>
        <translation>{type} 必须有其他分量</translation>
    </message>
    <message>
        <source>adaptive layers</source>
        <translation>自适应层</translation>
    </message>
    <message>
        <source>add a row of - under the part, where it should be placed</source>
        <translation>在零件下方应放置处添加一行 -</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), cut there, or use curved mode</source>
        <translation>添加支撑（`supports=auto`），在该处切割，或使用曲面层</translation>
    </message>
    <message>
        <source>along</source>
        <translation>沿轴</translation>
    </message>
    <message>
        <source>unknown M command</source>
        <translation>未知的 M 指令</translation>
    </message>
    <message>
        <source>an OFF file begins with &quot;OFF&quot;</source>
        <translation>OFF 文件应以 &quot;OFF&quot; 开头</translation>
    </message>
    <message>
        <source>an analogue output outside 0..1</source>
        <translation>模拟输出超出 0..1</translation>
    </message>
    <message>
        <source>an argument of {name} is unknown or given twice</source>
        <translation>{name} 的某个参数未知或给出两次</translation>
    </message>
    <message>
        <source>an element needs its count</source>
        <translation>元素需要其数量</translation>
    </message>
    <message>
        <source>an external axis far outside any limit</source>
        <translation>外部轴远超任何极限</translation>
    </message>
    <message>
        <source>an external axis that moves no work object is not supported</source>
        <translation>不支持不移动工件坐标对象的外部轴</translation>
    </message>
    <message>
        <source>an output needs a number and a value</source>
        <translation>输出需要编号和值</translation>
    </message>
    <message>
        <source>an unknown PLY format</source>
        <translation>未知的 PLY 格式</translation>
    </message>
    <message>
        <source>an unknown line in the header</source>
        <translation>文件头中有未知的行</translation>
    </message>
    <message>
        <source>further defects from here on are not listed</source>
        <translation>此后的其他缺陷不再列出</translation>
    </message>
    <message numerus="yes">
        <source>{count} more collisions</source>
        <translation>
            <numerusform>另有 {count} 处碰撞</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more violations</source>
        <translation>
            <numerusform>另有 {count} 处违规</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} more waypoints, the first: {what}</source>
        <translation>
            <numerusform>另有 {count} 个路径点，第一个：{what}</numerusform>
        </translation>
    </message>
    <message>
        <source>{length:.0f} of the file&apos;s beads are outside the limits of process {process} (width {widthMin:.3g} to {widthMax:.3g}, height {heightMin:.3g} to {heightMax:.3g}): the worst is {width:.2f} wide and {height:.2f} high</source>
        <translation>文件中有 {length:.0f} 的挤出线超出工艺 {process} 的限制（宽 {widthMin:.3g} 至 {widthMax:.3g}，高 {heightMin:.3g} 至 {heightMax:.3g}）：最差的宽 {width:.2f}、高 {height:.2f}</translation>
    </message>
    <message numerus="yes">
        <source>{what}; {more} more voxels depend on this</source>
        <translation>
            <numerusform>{what}；另有 {more} 个体素依赖于此</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part or add supports</source>
        <translation>转动零件或添加支撑</translation>
    </message>
    <message>
        <source>another column</source>
        <translation>另一根立柱</translation>
    </message>
    <message>
        <source>argument {key} is not a valid number</source>
        <translation>参数 {key} 不是有效数字</translation>
    </message>
    <message>
        <source>around</source>
        <translation>绕轴</translation>
    </message>
    <message>
        <source>at {point:.1f}</source>
        <translation>在 {point:.1f}</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>part axis</source>
        <translation>零件轴</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>挤出线宽</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>束搜索</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; of the job file is damaged</source>
        <translation>作业文件的块“{name}”已损坏</translation>
    </message>
    <message>
        <source>break it off after printing</source>
        <translation>打印后将其掰除</translation>
    </message>
    <message>
        <source>broken precondition: {what}</source>
        <translation>前提条件被破坏：{what}</translation>
    </message>
    <message>
        <source>byte {code}</source>
        <translation>字节 {code}</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>无法读到末尾</translation>
    </message>
    <message>
        <source>cannot be read: {why}</source>
        <translation>无法读取：{why}</translation>
    </message>
    <message>
        <source>cannot be written: {why}</source>
        <translation>无法写入：{why}</translation>
    </message>
    <message>
        <source>cell {cell}</source>
        <translation>工作单元 {cell}</translation>
    </message>
    <message>
        <source>cell {cell} has a rod, but mode {mode} prints on a plate</source>
        <translation>工作单元 {cell} 带芯棒，但 {mode} 模式在打印板上打印</translation>
    </message>
    <message>
        <source>cell {id} has no rod to print on</source>
        <translation>工作单元 {id} 没有可供打印的芯棒</translation>
    </message>
    <message>
        <source>layer centre</source>
        <translation>层中心</translation>
    </message>
    <message>
        <source>check the flow and the infill density</source>
        <translation>检查流量和填充密度</translation>
    </message>
    <message>
        <source>checking layers</source>
        <translation>检查层</translation>
    </message>
    <message>
        <source>checking the motion</source>
        <translation>检查运动</translation>
    </message>
    <message>
        <source>choose a smaller `voxelMm` or `beadWidthMm`</source>
        <translation>选择更小的 `voxelMm` 或 `beadWidthMm`</translation>
    </message>
    <message>
        <source>choose layers that reach all of it (`layerShape`, `layerCentre`, `endSurface`)</source>
        <translation>选择能覆盖整个零件的层（`layerShape`、`layerCentre`、`endSurface`）</translation>
    </message>
    <message>
        <source>choose {least} to {most} pixels per side</source>
        <translation>每边选择 {least} 至 {most} 像素</translation>
    </message>
    <message>
        <source>arm clearance</source>
        <translation>机械臂安全间距</translation>
    </message>
    <message>
        <source>clearance to the part</source>
        <translation>与零件的安全间距</translation>
    </message>
    <message numerus="yes">
        <source>closed {count} holes, the largest of {edges} edges at {at:.2f}</source>
        <translation>
            <numerusform>封闭了 {count} 个孔，最大的有 {edges} 条边，位于 {at:.2f}</numerusform>
        </translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>comparing with the plan</source>
        <translation>与规划比较</translation>
    </message>
    <message>
        <source>concentric</source>
        <translation>同心</translation>
    </message>
    <message>
        <source>contact area + {sizes} mm</source>
        <translation>接触面 + {sizes} mm</translation>
    </message>
    <message numerus="yes">
        <source>cut it off after printing: it touches the part at {faces} more faces</source>
        <translation>
            <numerusform>打印后将其切除：它还接触零件的 {faces} 个面</numerusform>
        </translation>
    </message>
    <message>
        <source>truncated</source>
        <translation>被截断</translation>
    </message>
    <message>
        <source>truncated within a facet</source>
        <translation>在面片内被截断</translation>
    </message>
    <message>
        <source>truncated, or not a mesh: {what}</source>
        <translation>被截断，或不是网格：{what}</translation>
    </message>
    <message>
        <source>truncated: {bytes} bytes are too few for an STL file</source>
        <translation>被截断：{bytes} 字节对 STL 文件来说太少</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} faces</source>
        <translation>被截断：共 {wanted} 个面，只有 {there} 个</translation>
    </message>
    <message>
        <source>truncated: {there} of {wanted} vertices</source>
        <translation>被截断：共 {wanted} 个顶点，只有 {there} 个</translation>
    </message>
    <message>
        <source>cut {number}</source>
        <translation>切割 {number}</translation>
    </message>
    <message>
        <source>cutting</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>cutting layers</source>
        <translation>切割出层</translation>
    </message>
    <message>
        <source>cutting layers from the field</source>
        <translation>从场中切割出层</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>切割平面</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>圆柱</translation>
    </message>
    <message>
        <source>damaged STL: {what}</source>
        <translation>STL 已损坏：{what}</translation>
    </message>
    <message>
        <source>data of the type {type} is not known to the reader</source>
        <translation>读取器不认识 {type} 类型的数据</translation>
    </message>
    <message>
        <source>did you mean &apos;{name}&apos;?</source>
        <translation>是否想写“{name}”？</translation>
    </message>
    <message>
        <source>did you mean {name}?</source>
        <translation>是否想写 {name}？</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>disc, {sizes} mm</source>
        <translation>圆盘，{sizes} mm</translation>
    </message>
    <message>
        <source>is {height} by default, more than the default of beadWidthMm, {width}: beads are no higher than wide</source>
        <translation>默认为 {height}，大于 beadWidthMm 的默认值 {width}：挤出线的高度不能大于宽度</translation>
    </message>
    <message>
        <source>is {tolerance}, not less than the maximum of layerHeightMm, {height}: the head would pass through a layer</source>
        <translation>为 {tolerance}，不小于 layerHeightMm 的最大值 {height}：打印头会穿过一层</translation>
    </message>
    <message>
        <source>is {most:.3g} mm3/s, less than the smallest bead needs at speedMmPerS, {flow:.3g} mm3/s</source>
        <translation>为 {most:.3g} mm3/s，低于最小挤出线在 speedMmPerS 下所需的 {flow:.3g} mm3/s</translation>
    </message>
    <message>
        <source>does not rise from z = 0</source>
        <translation>未从 z = 0 开始上升</translation>
    </message>
    <message>
        <source>drop it to the plate</source>
        <translation>将其落到打印板</translation>
    </message>
    <message>
        <source>drop it to the plate, or choose a platform below it</source>
        <translation>将其落到打印板，或选择其下方的平台</translation>
    </message>
    <message>
        <source>move the part down to the plate</source>
        <translation>将零件向下移到打印板</translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} duplicate triangles</source>
        <translation>
            <numerusform>删除了 {count} 个重复三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles of sheets without volume</source>
        <translation>
            <numerusform>删除了 {count} 个无体积薄片的三角形</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>dropped {count} triangles without area</source>
        <translation>
            <numerusform>删除了 {count} 个无面积的三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>eax_a is missing: an external axis moves the work object</source>
        <translation>缺少 eax_a：有外部轴移动工件坐标对象</translation>
    </message>
    <message>
        <source>end surface</source>
        <translation>终止面</translation>
    </message>
    <message>
        <source>`endSurface` &apos;{text}&apos; is not an end surface</source>
        <translation>`endSurface` “{text}”不是终止面</translation>
    </message>
    <message>
        <source>`endSurface` mesh:FILE requires a platform that is a body</source>
        <translation>`endSurface` mesh:FILE 需要实体形式的平台</translation>
    </message>
    <message>
        <source>ending layers on the surface</source>
        <translation>使层终止于表面</translation>
    </message>
    <message>
        <source>export or copy the file again</source>
        <translation>重新导出或复制文件</translation>
    </message>
    <message>
        <source>the extruded volume decreases</source>
        <translation>挤出体积减小</translation>
    </message>
    <message>
        <source>fewest missed voxels</source>
        <translation>遗漏体素最少</translation>
    </message>
    <message>
        <source>field</source>
        <translation>场</translation>
    </message>
    <message>
        <source>file {file}, line {line}</source>
        <translation>文件 {file}，第 {line} 行</translation>
    </message>
    <message>
        <source>file {file}, line {line}: {what}</source>
        <translation>文件 {file}，第 {line} 行：{what}</translation>
    </message>
    <message>
        <source>fill the hollow first, or use `layerShape=offset`</source>
        <translation>先填实空腔，或使用 `layerShape=offset`</translation>
    </message>
    <message>
        <source>first layer</source>
        <translation>第一层</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>flatten</source>
        <translation>展平</translation>
    </message>
    <message>
        <source>flattening</source>
        <translation>展平</translation>
    </message>
    <message>
        <source>front</source>
        <translation>前沿</translation>
    </message>
    <message>
        <source>give `--cell lathe`</source>
        <translation>指定 `--cell lathe`</translation>
    </message>
    <message>
        <source>give `--mode {modes}`, or another cell</source>
        <translation>指定 `--mode {modes}`，或另一个工作单元</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`</source>
        <translation>指定 `--platform {platforms}`</translation>
    </message>
    <message>
        <source>give `--platform {platforms}`, or `endSurface` flat:Z</source>
        <translation>指定 `--platform {platforms}`，或 `endSurface` flat:Z</translation>
    </message>
    <message>
        <source>give 0, or {least#} to {most}</source>
        <translation>给出 0，或 {least#} 至 {most}</translation>
    </message>
    <message>
        <source>choose a higher end surface (`endSurface`)</source>
        <translation>选择更高的终止面（`endSurface`）</translation>
    </message>
    <message>
        <source>give a list of {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} or {&quot;corners&quot;: [four points]}, in mm</source>
        <translation>给出由 {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]} 或 {&quot;corners&quot;: [four points]} 组成的列表，单位 mm</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>给出一个数字</translation>
    </message>
    <message>
        <source>give a number from 0.0001 to 10000, or fit</source>
        <translation>给出 0.0001 至 10000 的数字，或 fit</translation>
    </message>
    <message>
        <source>give all slices the same number of rows</source>
        <translation>使所有切片的行数相同</translation>
    </message>
    <message>
        <source>give an STL, OBJ, PLY, OFF or 3MF file</source>
        <translation>提供 STL、OBJ、PLY、OFF 或 3MF 文件</translation>
    </message>
    <message>
        <source>choose an end surface over the part&apos;s foot</source>
        <translation>选择位于零件底部之上的终止面</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a narrower part</source>
        <translation>选择形状更接近的终止面，或更窄的零件</translation>
    </message>
    <message>
        <source>choose an end surface of more similar shape, or a smaller part</source>
        <translation>选择形状更接近的终止面，或更小的零件</translation>
    </message>
    <message>
        <source>give `endSurface=flat:Z` or mesh:FILE</source>
        <translation>指定 `endSurface=flat:Z` 或 mesh:FILE</translation>
    </message>
    <message>
        <source>give `orient=none`</source>
        <translation>指定 `orient=none`</translation>
    </message>
    <message>
        <source>use other cutting planes (`cutPlanes`), turn the part, or use curved mode</source>
        <translation>使用其他切割平面（`cutPlanes`），转动零件，或使用曲面层</translation>
    </message>
    <message>
        <source>give pairs of x and radius in mm, x ascending</source>
        <translation>给出 x 与半径的数对，单位 mm，x 递增</translation>
    </message>
    <message>
        <source>give planes: {&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</source>
        <translation>给出平面：{&quot;point&quot;: [x, y, z], &quot;normal&quot;: [x, y, z]}</translation>
    </message>
    <message>
        <source>verify it against the job it was written from</source>
        <translation>用写出它的作业来验证</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>给出 true 或 false</translation>
    </message>
    <message>
        <source>give {field} from {least#} to {most}</source>
        <translation>给出 {field}，{least#} 至 {most}</translation>
    </message>
    <message>
        <source>give {forms}</source>
        <translation>给出 {forms}</translation>
    </message>
    <message>
        <source>give {key}=NUMBER, 0 or more</source>
        <translation>给出 {key}=数字，不小于 0</translation>
    </message>
    <message>
        <source>give {least#} to {most}</source>
        <translation>给出 {least#} 至 {most}</translation>
    </message>
    <message>
        <source>give {least} to {most}</source>
        <translation>给出 {least} 至 {most}</translation>
    </message>
    <message>
        <source>give {least} to {most} {unit}</source>
        <translation>给出 {least} 至 {most} {unit}</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>贪心</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>生长</translation>
    </message>
    <message>
        <source>must have minDeg below maxDeg</source>
        <translation>minDeg 必须小于 maxDeg</translation>
    </message>
    <message>
        <source>must not have zero length</source>
        <translation>长度不得为零</translation>
    </message>
    <message>
        <source>head</source>
        <translation>打印头</translation>
    </message>
    <message>
        <source>helical</source>
        <translation>螺旋</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>喷嘴座</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>inches are not understood</source>
        <translation>不支持英寸</translation>
    </message>
    <message>
        <source>infill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>infill &apos;{infill}&apos; needs an axis to wind around, but layer {layer} has none</source>
        <translation>填充“{infill}”需要环绕的轴，但层 {layer} 没有轴</translation>
    </message>
    <message>
        <source>infill density</source>
        <translation>填充密度</translation>
    </message>
    <message>
        <source>infill direction</source>
        <translation>填充方向</translation>
    </message>
    <message>
        <source>install Mesa (libegl1, libgl1-mesa-dri)</source>
        <translation>安装 Mesa (libegl1, libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>is &apos;{id}&apos;, but the file is named &apos;{file}&apos;</source>
        <translation>为“{id}”，但文件名为“{file}”</translation>
    </message>
    <message>
        <source>is a directory, not a file</source>
        <translation>是目录，不是文件</translation>
    </message>
    <message>
        <source>is truncated</source>
        <translation>被截断</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>已加密</translation>
    </message>
    <message>
        <source>is larger than 1 GB</source>
        <translation>大于 1 GB</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is outside the joint&apos;s limits</source>
        <translation>超出关节极限</translation>
    </message>
    <message>
        <source>is compressed with an unsupported method</source>
        <translation>以不支持的方法压缩</translation>
    </message>
    <message>
        <source>is already used: &apos;{name}&apos;</source>
        <translation>已被使用：“{name}”</translation>
    </message>
    <message>
        <source>it is a file, not a folder</source>
        <translation>这是文件，不是文件夹</translation>
    </message>
    <message>
        <source>two blends overlap, {blend:.3f} in all on a motion of {way:.3f}: the controller skips the waypoint</source>
        <translation>两个过渡重叠，在 {way:.3f} 的运动上共 {blend:.3f}：控制器会跳过该路径点</translation>
    </message>
    <message>
        <source>joint {number}</source>
        <translation>关节 {number}</translation>
    </message>
    <message>
        <source>place the part on a larger face, or use other cutting planes (`cutPlanes`)</source>
        <translation>将零件放在更大的面上，或使用其他切割平面（`cutPlanes`）</translation>
    </message>
    <message>
        <source>layer height</source>
        <translation>层高</translation>
    </message>
    <message>
        <source>layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}</source>
        <translation>层 {layer}，x {x:.1f} y {y:.1f} z {z:.1f}</translation>
    </message>
    <message>
        <source>`layerCentre` &apos;{text}&apos; is not a point</source>
        <translation>`layerCentre` “{text}”不是一个点</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>层</translation>
    </message>
    <message>
        <source>layers are 1 to {count}</source>
        <translation>层为 1 至 {count}</translation>
    </message>
    <message>
        <source>layers around the rod</source>
        <translation>围绕芯棒的层</translation>
    </message>
    <message>
        <source>layers on this surface would fold from layer {layer} on: its normals cross before the end surface</source>
        <translation>从层 {layer} 起此表面上的层会折叠：其法线在到达终止面之前相交</translation>
    </message>
    <message>
        <source>depositing beads</source>
        <translation>沉积挤出线</translation>
    </message>
    <message>
        <source>minimum overhang</source>
        <translation>悬垂最少</translation>
    </message>
    <message>
        <source>least overhang of pieces</source>
        <translation>分块悬垂最少</translation>
    </message>
    <message>
        <source>least residual area</source>
        <translation>剩余面积最小</translation>
    </message>
    <message>
        <source>leaves a piece without a base</source>
        <translation>留下一个没有底面的分块</translation>
    </message>
    <message>
        <source>leaves a piece only {thickness:.2g} thick, thinner than a bead ({least})</source>
        <translation>留下一个厚度仅 {thickness:.2g} 的分块，薄于一条挤出线（{least}）</translation>
    </message>
    <message>
        <source>omitted: {what}</source>
        <translation>已省略：{what}</translation>
    </message>
    <message>
        <source>left to the controller</source>
        <translation>由控制器决定</translation>
    </message>
    <message>
        <source>lengths taken as mm: unknown unit &apos;{unit}&apos;</source>
        <translation>长度按 mm 处理：未知单位“{unit}”</translation>
    </message>
    <message>
        <source>lengths converted from {unit} to mm</source>
        <translation>长度已从 {unit} 换算为 mm</translation>
    </message>
    <message>
        <source>reduce the flow, or space the beads further apart</source>
        <translation>减小流量，或加大挤出线间距</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the rod there</source>
        <translation>使零件在该处相对芯棒的坡度更缓</translation>
    </message>
    <message>
        <source>give the part a gentler slope from the surface there</source>
        <translation>使零件在该处相对表面的坡度更缓</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>抬升</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>第 {line} 行</translation>
    </message>
    <message>
        <source>line {line}: {what}</source>
        <translation>第 {line} 行：{what}</translation>
    </message>
    <message>
        <source>load</source>
        <translation>加载</translation>
    </message>
    <message>
        <source>longest side {longest:.4g}: the file may be in {unit} (scale {scale})</source>
        <translation>最长边 {longest:.4g}：文件单位可能是 {unit}（比例 {scale}）</translation>
    </message>
    <message>
        <source>checking support below the beads</source>
        <translation>检查挤出线下方的支承</translation>
    </message>
    <message>
        <source>checking for collisions</source>
        <translation>检查碰撞</translation>
    </message>
    <message>
        <source>saved by a newer version of Voluta (format {format}; this version reads up to {newest})</source>
        <translation>由更新版本的 Voluta 保存（格式 {format}；此版本最高可读 {newest}）</translation>
    </message>
    <message>
        <source>make all rows equally long</source>
        <translation>使所有行长度相同</translation>
    </message>
    <message>
        <source>make the feature narrower</source>
        <translation>使该特征更窄</translation>
    </message>
    <message>
        <source>make the object from fewer and larger cells</source>
        <translation>用更少、更大的单元格构成对象</translation>
    </message>
    <message>
        <source>make the part narrower, or use `layerShape=offset`</source>
        <translation>使零件更窄，或使用 `layerShape=offset`</translation>
    </message>
    <message>
        <source>piece materials</source>
        <translation>分块材料</translation>
    </message>
    <message>
        <source>measuring the beads</source>
        <translation>测量挤出线</translation>
    </message>
    <message>
        <source>repair it in a modelling program</source>
        <translation>在建模软件中修复</translation>
    </message>
    <message>
        <source>repair the mesh in a modelling program if the result looks wrong</source>
        <translation>如果结果看起来不对，请在建模软件中修复网格</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} duplicate points</source>
        <translation>
            <numerusform>合并了 {count} 个重复点</numerusform>
        </translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>微米</translation>
    </message>
    <message>
        <source>missed voxels</source>
        <translation>遗漏的体素</translation>
    </message>
    <message>
        <source>mode {mode} does not print on platform {platform}</source>
        <translation>{mode} 模式不能在平台 {platform} 上打印</translation>
    </message>
    <message>
        <source>mode {mode} prints around a rod, but cell {cell} has none</source>
        <translation>{mode} 模式绕芯棒打印，但工作单元 {cell} 没有芯棒</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>move it so that it crosses the part</source>
        <translation>移动它，使其穿过零件</translation>
    </message>
    <message>
        <source>move or tilt the plane slightly</source>
        <translation>稍微移动或倾斜该平面</translation>
    </message>
    <message>
        <source>move the part along the rod, or use a longer rod</source>
        <translation>沿芯棒移动零件，或使用更长的芯棒</translation>
    </message>
    <message>
        <source>move the part on the rod, or extend it down to the rod there</source>
        <translation>在芯棒上移动零件，或在该处将其向下延伸到芯棒</translation>
    </message>
    <message>
        <source>move the part on the surface, or extend it down to the surface there</source>
        <translation>在表面上移动零件，或在该处将其向下延伸到表面</translation>
    </message>
    <message>
        <source>move the part onto the rod</source>
        <translation>将零件移到芯棒上</translation>
    </message>
    <message>
        <source>move the part onto the surface</source>
        <translation>将零件移到表面上</translation>
    </message>
    <message>
        <source>move the part out of the surface, or print it larger</source>
        <translation>将零件移出表面，或打印得更大</translation>
    </message>
    <message>
        <source>move the plane or remove it</source>
        <translation>移动或移除该平面</translation>
    </message>
    <message>
        <source>move the plane, or point its normal to the side to cut off</source>
        <translation>移动该平面，或使其法线指向要切除的一侧</translation>
    </message>
    <message>
        <source>move the planes, or add planes between them</source>
        <translation>移动这些平面，或在其间添加平面</translation>
    </message>
    <message>
        <source>move or remove them</source>
        <translation>移动或移除它们</translation>
    </message>
    <message>
        <source>must be a capsule, a box or a frustum</source>
        <translation>必须是胶囊体、长方体或圆台</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>必须是有限数</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>必须是列表</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>必须是数字</translation>
    </message>
    <message>
        <source>must be a pair of height and radius</source>
        <translation>必须是高度与半径的数对</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>必须是文本</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>必须是整数</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>必须是对象</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>必须大于 0</translation>
    </message>
    <message>
        <source>must be in 0..{dof}</source>
        <translation>必须在 0..{dof} 之内</translation>
    </message>
    <message>
        <source>must be greater than the rod&apos;s radius</source>
        <translation>必须大于芯棒半径</translation>
    </message>
    <message>
        <source>must be unwinds or runsOn, is &apos;{end}&apos;</source>
        <translation>必须是 unwinds 或 runsOn，现为“{end}”</translation>
    </message>
    <message>
        <source>must be world or flange, is &apos;{mount}&apos;</source>
        <translation>必须是 world 或 flange，现为“{mount}”</translation>
    </message>
    <message>
        <source>must be world: a rod is held at both ends</source>
        <translation>必须是 world：芯棒两端固定</translation>
    </message>
    <message>
        <source>must include the home position 0 in its limits</source>
        <translation>其极限必须包含原位 0</translation>
    </message>
    <message>
        <source>must have three numbers</source>
        <translation>必须有三个数字</translation>
    </message>
    <message>
        <source>must have two names</source>
        <translation>必须有两个名称</translation>
    </message>
    <message>
        <source>must have at least two sections</source>
        <translation>必须至少有两个截面</translation>
    </message>
    <message>
        <source>must have 6 joints, has {found}</source>
        <translation>必须有 6 个关节，现有 {found} 个</translation>
    </message>
    <message>
        <source>must have at least one shape</source>
        <translation>必须至少有一个形状</translation>
    </message>
    <message>
        <source>must have exactly one axis, which turns the rod</source>
        <translation>必须恰有一个轴，用于转动芯棒</translation>
    </message>
    <message>
        <source>must have {wanted} joints, has {found}</source>
        <translation>必须有 {wanted} 个关节，现有 {found} 个</translation>
    </message>
    <message>
        <source>must not be 0</source>
        <translation>不得为 0</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>不得为负</translation>
    </message>
    <message>
        <source>must differ from the nozzle&apos;s: one of them moves, the other is fixed</source>
        <translation>必须与喷嘴的不同：二者之一运动，另一个固定</translation>
    </message>
    <message>
        <source>set its axis (`rodAxis`), or rotate the part onto the rod manually</source>
        <translation>设置其轴（`rodAxis`），或手动将零件旋转到芯棒上</translation>
    </message>
    <message>
        <source>names an unknown body: &apos;{name}&apos;; did you mean &apos;{nearest}&apos;?</source>
        <translation>指定了未知的物体：“{name}”；是否为“{nearest}”？</translation>
    </message>
    <message>
        <source>names an unknown kinematic family: &apos;{id}&apos;</source>
        <translation>指定了未知的运动学类型：“{id}”</translation>
    </message>
    <message>
        <source>names no model</source>
        <translation>未指定模型</translation>
    </message>
    <message>
        <source>needs radii that are not negative, one of them greater than 0</source>
        <translation>半径不得为负，且其中一个大于 0</translation>
    </message>
    <message>
        <source>neither a plane nor a quadrilateral</source>
        <translation>既不是平面也不是四边形</translation>
    </message>
    <message numerus="yes">
        <source>no support column from the platform reaches {voxels} voxels that would be missed</source>
        <translation>
            <numerusform>没有支撑柱能从平台到达会被遗漏的 {voxels} 个体素</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown figure &apos;{key}&apos;</source>
        <translation>未知的指标“{key}”</translation>
    </message>
    <message>
        <source>no function is defined</source>
        <translation>未定义函数</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: their distance is {shortest:.3g} to {longest:.3g} mm</source>
        <translation>表面与终止面之间无论取多少层，都无法使层高保持在 {least} 至 {most} mm：其距离为 {shortest:.3g} 至 {longest:.3g} mm</translation>
    </message>
    <message>
        <source>no number of layers between the surface and the end surface keeps the layer height within {least} to {most} mm: {layers} layers would be {thinnest:.3g} to {thickest:.3g} mm high</source>
        <translation>表面与终止面之间无论取多少层，都无法使层高保持在 {least} 至 {most} mm：{layers} 层时层高为 {thinnest:.3g} 至 {thickest:.3g} mm</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>文件不存在</translation>
    </message>
    <message>
        <source>no tool-paths left</source>
        <translation>没有剩余的工具路径</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not JSON: {why}</source>
        <translation>不是 JSON：{why}</translation>
    </message>
    <message>
        <source>not a Voluta job</source>
        <translation>不是 Voluta 作业</translation>
    </message>
    <message>
        <source>invalid filament diameter</source>
        <translation>耗材直径无效</translation>
    </message>
    <message>
        <source>not a mesh file</source>
        <translation>不是网格文件</translation>
    </message>
    <message>
        <source>invalid module attributes</source>
        <translation>模块属性无效</translation>
    </message>
    <message>
        <source>not a program in any known format</source>
        <translation>不是任何已知格式的程序</translation>
    </message>
    <message>
        <source>not a row of the table</source>
        <translation>不是表格的行</translation>
    </message>
    <message>
        <source>not a zip file, or truncated</source>
        <translation>不是 zip 文件，或被截断</translation>
    </message>
    <message>
        <source>not a valid procedure header</source>
        <translation>不是有效的过程头</translation>
    </message>
    <message>
        <source>not the header of a joint table</source>
        <translation>不是关节表的表头</translation>
    </message>
    <message>
        <source>not understood: &apos;{code}&apos;</source>
        <translation>不支持：“{code}”</translation>
    </message>
    <message>
        <source>nothing is left of the mesh after repair</source>
        <translation>修复后网格没有剩余内容</translation>
    </message>
    <message>
        <source>no normal of the surface below the part hits the end surface</source>
        <translation>零件下方表面的法线都不与终止面相交</translation>
    </message>
    <message>
        <source>nothing is on the platform</source>
        <translation>平台上没有任何东西</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>喷嘴</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is missing</source>
        <translation>缺少对象“{id}”</translation>
    </message>
    <message>
        <source>objects contain each other, or there are too many to read</source>
        <translation>对象互相包含，或数量过多无法读取</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>on the plate</source>
        <translation>在打印板上</translation>
    </message>
    <message>
        <source>a stop that ends by itself or is skipped</source>
        <translation>会自行结束或被跳过的停止</translation>
    </message>
    <message>
        <source>a stop that the operator ends</source>
        <translation>由操作员结束的停止</translation>
    </message>
    <message>
        <source>only three-dimensional OFF files can be read</source>
        <translation>只能读取三维 OFF 文件</translation>
    </message>
    <message>
        <source>open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>open it with the version that saved it</source>
        <translation>用保存它的版本打开</translation>
    </message>
    <message>
        <source>ordering layers</source>
        <translation>层排序</translation>
    </message>
    <message>
        <source>to keep the orientation as given, use `orient=none`</source>
        <translation>要保持给定的朝向，使用 `orient=none`</translation>
    </message>
    <message>
        <source>`orient={orient}` is for parts on a plate; mode {mode} places them itself</source>
        <translation>`orient={orient}` 适用于打印板上的零件；{mode} 模式自行放置零件</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>不可达</translation>
    </message>
    <message>
        <source>overhang angle</source>
        <translation>悬垂角</translation>
    </message>
    <message>
        <source>pair {number}</source>
        <translation>数对 {number}</translation>
    </message>
    <message>
        <source>pairs a body with itself</source>
        <translation>将物体与自身配对</translation>
    </message>
    <message>
        <source>peeling</source>
        <translation>剥离</translation>
    </message>
    <message>
        <source>pick a point on a piece that touches the plate, or place the part on the face to start from</source>
        <translation>在接触打印板的分块上选点，或将零件放在起始面上</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>some areas are narrower than half a bead and stay empty</source>
        <translation>部分区域窄于半条挤出线，将保持空白</translation>
    </message>
    <message>
        <source>placed part</source>
        <translation>已放置的零件</translation>
    </message>
    <message>
        <source>plan again with more clearance, or place the part elsewhere</source>
        <translation>以更大的安全间距重新规划，或将零件放到别处</translation>
    </message>
    <message>
        <source>plan it without --until</source>
        <translation>不带 --until 进行规划</translation>
    </message>
    <message>
        <source>plan the part again</source>
        <translation>重新规划零件</translation>
    </message>
    <message>
        <source>plan the part further: voluta-cli plan PART -o DIR</source>
        <translation>继续规划零件：voluta-cli plan PART -o DIR</translation>
    </message>
    <message>
        <source>layer planes</source>
        <translation>层平面</translation>
    </message>
    <message>
        <source>layer planes miss the part: {planes}</source>
        <translation>层平面未碰到零件：{planes}</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; has no valid size</source>
        <translation>平台“{platform}”没有有效尺寸</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; is not a plate</source>
        <translation>平台“{platform}”不是板</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos; names no file</source>
        <translation>平台“{platform}”未指定文件</translation>
    </message>
    <message>
        <source>platform &apos;{platform}&apos;: {field} {size} is out of range</source>
        <translation>平台“{platform}”：{field} {size} 超出范围</translation>
    </message>
    <message>
        <source>point {i} is the third one at x = {x:.6g} mm</source>
        <translation>点 {i} 是 x = {x:.6g} mm 处的第三个点</translation>
    </message>
    <message>
        <source>print the part larger, or with a finer process</source>
        <translation>将零件打印得更大，或使用更精细的工艺</translation>
    </message>
    <message>
        <source>print the part smaller (scale)</source>
        <translation>将零件打印得更小 (scale)</translation>
    </message>
    <message>
        <source>printed part</source>
        <translation>打印出的零件</translation>
    </message>
    <message>
        <source>rod profile</source>
        <translation>芯棒轮廓</translation>
    </message>
    <message>
        <source>put - only under the part or beside its lowest row</source>
        <translation>只在零件下方或其最低行旁放 -</translation>
    </message>
    <message>
        <source>put - directly under the part</source>
        <translation>将 - 放在零件正下方</translation>
    </message>
    <message>
        <source>orient it by hand</source>
        <translation>手动调整朝向</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>可达</translation>
    </message>
    <message>
        <source>relative positions are not understood</source>
        <translation>不支持相对位置</translation>
    </message>
    <message>
        <source>repair</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>repair it, or use curved mode, which takes any mesh</source>
        <translation>修复它，或使用接受任何网格的曲面层</translation>
    </message>
    <message>
        <source>repair the part first</source>
        <translation>先修复零件</translation>
    </message>
    <message>
        <source>repair: check</source>
        <translation>修复：检查</translation>
    </message>
    <message>
        <source>repair: diagnosis</source>
        <translation>修复：诊断</translation>
    </message>
    <message>
        <source>repair: holes</source>
        <translation>修复：孔</translation>
    </message>
    <message>
        <source>repair: orientation</source>
        <translation>修复：朝向</translation>
    </message>
    <message>
        <source>repair: self-intersections</source>
        <translation>修复：自相交</translation>
    </message>
    <message>
        <source>replaying {format}</source>
        <translation>回放 {format}</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>已回放</translation>
    </message>
    <message>
        <source>risky area</source>
        <translation>风险面积</translation>
    </message>
    <message>
        <source>robot motion</source>
        <translation>机器人运动</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>芯棒</translation>
    </message>
    <message>
        <source>rod, {sizes} mm</source>
        <translation>芯棒，{sizes} mm</translation>
    </message>
    <message>
        <source>`rodProfile`: &apos;{text}&apos; is neither a pair x,radius nor a file</source>
        <translation>`rodProfile`：“{text}”既不是数对 x,半径，也不是文件</translation>
    </message>
    <message>
        <source>root</source>
        <translation>根部</translation>
    </message>
    <message>
        <source>size of the table of patches</source>
        <translation>面块表的大小</translation>
    </message>
    <message>
        <source>size of the table of pieces</source>
        <translation>分块表的大小</translation>
    </message>
    <message>
        <source>running the program</source>
        <translation>运行程序</translation>
    </message>
    <message>
        <source>invalid scale &apos;{scale}&apos;</source>
        <translation>比例“{scale}”无效</translation>
    </message>
    <message>
        <source>scale fit would scale the platform&apos;s mesh with the part</source>
        <translation>比例 fit 会使平台网格随零件一起缩放</translation>
    </message>
    <message>
        <source>scale the part down</source>
        <translation>缩小零件</translation>
    </message>
    <message>
        <source>scale the part down (`--scale fit`), turn it, or use a larger robot</source>
        <translation>缩小零件（`--scale fit`），转动零件，或使用更大的机器人</translation>
    </message>
    <message>
        <source>scale the part down, or move it along the rod</source>
        <translation>缩小零件，或沿芯棒移动零件</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>see the findings before this one</source>
        <translation>参见此前的问题</translation>
    </message>
    <message>
        <source>see: list formats</source>
        <translation>参见：list formats</translation>
    </message>
    <message numerus="yes">
        <source>separated non-manifold edges at {count} points</source>
        <translation>
            <numerusform>在 {count} 个点处分离了非流形边</numerusform>
        </translation>
    </message>
    <message>
        <source>set {variable}</source>
        <translation>设置 {variable}</translation>
    </message>
    <message>
        <source>set_tcp needs a pose</source>
        <translation>set_tcp 需要一个位姿</translation>
    </message>
    <message>
        <source>layer shape</source>
        <translation>层形状</translation>
    </message>
    <message>
        <source>use shorter motions or smaller blends</source>
        <translation>使用更短的运动或更小的过渡</translation>
    </message>
    <message>
        <source>rod sides</source>
        <translation>芯棒边数</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>sleep needs a time in seconds</source>
        <translation>sleep 需要以秒为单位的时间</translation>
    </message>
    <message>
        <source>slice {slice} ends after {rows} rows, the first one after {first}</source>
        <translation>切片 {slice} 在 {rows} 行后结束，第一个在 {first} 行后结束</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>print slower there, or place the part elsewhere in the cell</source>
        <translation>在该处放慢打印，或将零件放到工作单元的其他位置</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>球面</translation>
    </message>
    <message numerus="yes">
        <source>split edges at {count} T-junctions</source>
        <translation>
            <numerusform>在 {count} 个 T 形连接处拆分了边</numerusform>
        </translation>
    </message>
    <message>
        <source>stated</source>
        <translation>声明值</translation>
    </message>
    <message>
        <source>step</source>
        <translation>台阶</translation>
    </message>
    <message>
        <source>step height</source>
        <translation>台阶高度</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>支撑</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>choose a cell with a rod: `--cell lathe`</source>
        <translation>选择带芯棒的工作单元：`--cell lathe`</translation>
    </message>
    <message>
        <source>choose a shorter rod</source>
        <translation>选择更短的芯棒</translation>
    </message>
    <message>
        <source>choose a thinner rod</source>
        <translation>选择更细的芯棒</translation>
    </message>
    <message>
        <source>subtract the rod from the part</source>
        <translation>从零件中减去芯棒</translation>
    </message>
    <message>
        <source>subtract the surface from the part</source>
        <translation>从零件中减去表面</translation>
    </message>
    <message>
        <source>use {formats}</source>
        <translation>使用 {formats}</translation>
    </message>
    <message>
        <source>text after ENDMODULE</source>
        <translation>ENDMODULE 之后还有文本</translation>
    </message>
    <message>
        <source>text after the end</source>
        <translation>末尾之后还有文本</translation>
    </message>
    <message>
        <source>the arm cannot reach this target</source>
        <translation>机械臂无法到达此目标</translation>
    </message>
    <message>
        <source>the arm&apos;s configuration is not the planned one: a joint differs by {angle:.1f}</source>
        <translation>机械臂构型与规划不同：某关节相差 {angle:.1f}</translation>
    </message>
    <message>
        <source>the arm would have to change its configuration: {joint} would jump by {angle:.1f}</source>
        <translation>机械臂必须改变构型：{joint} 会跳变 {angle:.1f}</translation>
    </message>
    <message>
        <source>configuration supervision is on: ConfL\Off, ConfJ\Off</source>
        <translation>构型监控已开启：ConfL\Off, ConfJ\Off</translation>
    </message>
    <message>
        <source>the end sequence (M104 S0, M84, &apos;; end&apos;) is missing: the file is truncated</source>
        <translation>缺少结束序列（M104 S0、M84、&apos;; end&apos;）：文件被截断</translation>
    </message>
    <message>
        <source>the end sequence is missing</source>
        <translation>缺少结束序列</translation>
    </message>
    <message>
        <source>the end surface is {rise:.3g} mm above the top of the starting surface</source>
        <translation>终止面在起始表面顶部之上 {rise:.3g} mm</translation>
    </message>
    <message>
        <source>external axis {angle:.3f} off its planned position</source>
        <translation>外部轴偏离规划位置 {angle:.3f}</translation>
    </message>
    <message>
        <source>the extruder is not switched off after the last motion</source>
        <translation>最后一个运动之后挤出机未关闭</translation>
    </message>
    <message>
        <source>the extruder is off during a bead</source>
        <translation>打印挤出线时挤出机关闭</translation>
    </message>
    <message>
        <source>the extruder is on during a travel</source>
        <translation>空移时挤出机开启</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not set before this motion</source>
        <translation>此运动之前未设置挤出机的输出</translation>
    </message>
    <message>
        <source>the feature is {width:.3g} mm wide, wider than its cylinder of {cylinder:.3g} mm</source>
        <translation>该特征宽 {width:.3g} mm，比其 {cylinder:.3g} mm 的圆柱更宽</translation>
    </message>
    <message>
        <source>the file ends without &quot;endsolid&quot;: it may be truncated</source>
        <translation>文件结尾没有 &quot;endsolid&quot;：可能被截断</translation>
    </message>
    <message>
        <source>the file contains no cells</source>
        <translation>文件中没有单元格</translation>
    </message>
    <message>
        <source>the file is truncated: {what}</source>
        <translation>文件被截断：{what}</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the file&apos;s top {what}</source>
        <translation>文件的顶层{what}</translation>
    </message>
    <message>
        <source>the first module has no procedure main</source>
        <translation>第一个模块没有 main 过程</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; has no end</source>
        <translation>函数“{defined}”没有结尾</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is never called</source>
        <translation>函数“{defined}”从未被调用</translation>
    </message>
    <message>
        <source>the function is never called</source>
        <translation>该函数从未被调用</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>文件头没有结尾</translation>
    </message>
    <message>
        <source>the header line is missing</source>
        <translation>缺少文件头行</translation>
    </message>
    <message>
        <source>the header states no format</source>
        <translation>文件头未说明格式</translation>
    </message>
    <message>
        <source>the header states no facets; {facets} read</source>
        <translation>文件头未说明面片数；读取了 {facets} 个</translation>
    </message>
    <message>
        <source>the job file is inconsistent</source>
        <translation>作业文件不一致</translation>
    </message>
    <message>
        <source>the job file is inconsistent: {what}</source>
        <translation>作业文件不一致：{what}</translation>
    </message>
    <message>
        <source>the job file is truncated</source>
        <translation>作业文件被截断</translation>
    </message>
    <message>
        <source>the first line of the job file is damaged or truncated</source>
        <translation>作业文件的第一行已损坏或被截断</translation>
    </message>
    <message>
        <source>block &apos;{name}&apos; is missing in the job file</source>
        <translation>作业文件中缺少块“{name}”</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged</source>
        <translation>作业文件的文件头已损坏</translation>
    </message>
    <message>
        <source>the job file&apos;s header is damaged: {why}</source>
        <translation>作业文件的文件头已损坏：{why}</translation>
    </message>
    <message>
        <source>the job has no motion to verify against</source>
        <translation>作业中没有可用于验证的运动</translation>
    </message>
    <message>
        <source>the job contains no {result}</source>
        <translation>作业中没有 {result}</translation>
    </message>
    <message>
        <source>the letter {letter} has no number</source>
        <translation>字母 {letter} 没有数字</translation>
    </message>
    <message>
        <source>the line &apos;# end&apos; is missing: the file is truncated</source>
        <translation>缺少行 &apos;# end&apos;：文件被截断</translation>
    </message>
    <message>
        <source>the list of modules has no end</source>
        <translation>模块列表没有结尾</translation>
    </message>
    <message>
        <source>deposited volume: {share:.2f} of the part&apos;s</source>
        <translation>沉积体积：零件体积的 {share:.2f}</translation>
    </message>
    <message>
        <source>mechanical unit &apos;{text}&apos; is not active: ActUnit</source>
        <translation>机械单元“{text}”未激活：ActUnit</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>网格没有三角形</translation>
    </message>
    <message>
        <source>the mesh is empty: no facet has valid coordinates</source>
        <translation>网格为空：没有坐标有效的面片</translation>
    </message>
    <message>
        <source>the mesh is empty: the file has no triangles</source>
        <translation>网格为空：文件没有三角形</translation>
    </message>
    <message>
        <source>the mesh is not closed</source>
        <translation>网格未封闭</translation>
    </message>
    <message>
        <source>the module has no procedure</source>
        <translation>模块没有过程</translation>
    </message>
    <message>
        <source>the module with {procedure} is missing</source>
        <translation>缺少含 {procedure} 的模块</translation>
    </message>
    <message>
        <source>module {name} is missing</source>
        <translation>缺少模块 {name}</translation>
    </message>
    <message>
        <source>the normal has zero length</source>
        <translation>法线长度为零</translation>
    </message>
    <message>
        <source>nozzle {distance:.3f} off the planned path</source>
        <translation>喷嘴偏离规划路径 {distance:.3f}</translation>
    </message>
    <message>
        <source>nozzle axis {angle:.2f} off the planned direction</source>
        <translation>喷嘴轴偏离规划方向 {angle:.2f}</translation>
    </message>
    <message>
        <source>the numbers of vertices and faces are expected here</source>
        <translation>此处应为顶点数和面数</translation>
    </message>
    <message>
        <source>no part: no 1 above the platform</source>
        <translation>没有零件：平台上方没有 1</translation>
    </message>
    <message>
        <source>the object is too large</source>
        <translation>对象太大</translation>
    </message>
    <message>
        <source>the part below</source>
        <translation>下方的零件</translation>
    </message>
    <message>
        <source>the part does not touch the plate</source>
        <translation>零件未接触打印板</translation>
    </message>
    <message>
        <source>the part does not touch the platform</source>
        <translation>零件未接触平台</translation>
    </message>
    <message>
        <source>the part has no clear axis: its surface normals have no preferred direction</source>
        <translation>零件没有明确的轴：其表面法线没有优先方向</translation>
    </message>
    <message>
        <source>the part has no surface</source>
        <translation>零件没有表面</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the rod is subtracted</source>
        <translation>减去芯棒处零件未封闭或自相交</translation>
    </message>
    <message>
        <source>the part is not closed or self-intersects where the surface&apos;s body is subtracted</source>
        <translation>减去表面实体处零件未封闭或自相交</translation>
    </message>
    <message>
        <source>the part is too large for a collision grid of this resolution</source>
        <translation>零件太大，无法使用此分辨率的碰撞网格</translation>
    </message>
    <message numerus="yes">
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): {missed} missed voxels ({voxel:.2f} wide) instead of {missedBefore}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>
            <numerusform>零件绕 ({x}, {y}, {z}) 转动了 {angle:.0f}：遗漏体素 {missed} 个（宽 {voxel:.2f}），原为 {missedBefore} 个；悬垂 {overhang:.0f}，原为 {overhangBefore:.0f#}</numerusform>
        </translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): estimated overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>零件绕 ({x}, {y}, {z}) 转动了 {angle:.0f}：切割后估计悬垂 {left:.0f}（分块：{pieces}），原为 {leftBefore:.0f#}（分块：{piecesBefore}）；不切割时 {overhang:.0f}，原为 {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>零件绕 ({x}, {y}, {z}) 转动了 {angle:.0f}：悬垂 {overhang:.0f}，原为 {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): residual area on XY {xy:.0f} instead of {xyBefore:.0f#}, on XZ {xz:.0f} instead of {xzBefore:.0f#}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>零件绕 ({x}, {y}, {z}) 转动了 {angle:.0f}：XY 剩余面积 {xy:.0f}，原为 {xyBefore:.0f#}；XZ 剩余面积 {xz:.0f}，原为 {xzBefore:.0f#}；悬垂 {overhang:.0f}，原为 {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the part is {width:.3g} mm wide, at least as wide as the cylinder below it</source>
        <translation>零件宽 {width:.3g} mm，不小于其下方圆柱的宽度</translation>
    </message>
    <message>
        <source>the part misses the rod: no layer of it rests on the rod</source>
        <translation>零件未落在芯棒上：没有任何层支承在芯棒上</translation>
    </message>
    <message>
        <source>the part misses the surface: no layer of it rests on the surface</source>
        <translation>零件未落在表面上：没有任何层支承在表面上</translation>
    </message>
    <message>
        <source>the part reaches below the platform</source>
        <translation>零件低于平台</translation>
    </message>
    <message>
        <source>the part extends from x = {from:.4g} to {to:.4g} mm, beyond an end of the rod at {firstEnd:.4g} or {lastEnd:.4g} mm</source>
        <translation>零件从 x = {from:.4g} 延伸到 {to:.4g} mm，超出芯棒在 {firstEnd:.4g} 或 {lastEnd:.4g} mm 处的端部</translation>
    </message>
    <message>
        <source>the part extends {height:.3g} mm beyond the rod, less than a layer of {least:.3g} mm</source>
        <translation>零件超出芯棒 {height:.3g} mm，小于一层 {least:.3g} mm</translation>
    </message>
    <message>
        <source>the part extends to {reach:.4g} from the rod&apos;s axis; the cell prints up to {limit}</source>
        <translation>零件延伸到距芯棒轴线 {reach:.4g} 处；工作单元最远可打印到 {limit}</translation>
    </message>
    <message>
        <source>the part rises {height:.3g} mm above the surface, less than a layer of {least:.3g} mm</source>
        <translation>零件高出表面 {height:.3g} mm，小于一层 {least:.3g} mm</translation>
    </message>
    <message>
        <source>an end surface radius:R requires a cylinder along x below the part</source>
        <translation>终止面 radius:R 要求零件下方有沿 x 的圆柱</translation>
    </message>
    <message numerus="yes">
        <source>the part keeps its orientation: none of {ways} stable ones is better</source>
        <translation>
            <numerusform>零件保持其朝向：{ways} 个稳定朝向都不更好</numerusform>
        </translation>
    </message>
    <message>
        <source>the placement is not a rotation and a position in mm</source>
        <translation>放置不是由旋转和以 mm 为单位的位置组成</translation>
    </message>
    <message>
        <source>the plane misses the part</source>
        <translation>平面未碰到零件</translation>
    </message>
    <message>
        <source>the planes are not a JSON list</source>
        <translation>平面不是 JSON 列表</translation>
    </message>
    <message>
        <source>the platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>the platform&apos;s mesh is not closed</source>
        <translation>平台网格未封闭</translation>
    </message>
    <message>
        <source>the points are collinear</source>
        <translation>各点共线</translation>
    </message>
    <message>
        <source>the print head would cut into printed material, however it is tilted</source>
        <translation>无论如何倾斜，打印头都会切入已打印材料</translation>
    </message>
    <message>
        <source>the procedure has no ENDPROC</source>
        <translation>过程没有 ENDPROC</translation>
    </message>
    <message numerus="yes">
        <source>the program ends here; {motions} planned motions are missing</source>
        <translation>
            <numerusform>程序在此结束；缺少 {motions} 个规划的运动</numerusform>
        </translation>
    </message>
    <message>
        <source>the program has no motions</source>
        <translation>程序没有运动</translation>
    </message>
    <message>
        <source>the program runs from 0 to {end:.1f}</source>
        <translation>程序从 0 运行到 {end:.1f}</translation>
    </message>
    <message>
        <source>the program&apos;s data folder is missing</source>
        <translation>缺少程序的数据文件夹</translation>
    </message>
    <message>
        <source>the program&apos;s motions do not match this plan</source>
        <translation>程序的运动与此规划不符</translation>
    </message>
    <message>
        <source>the quadrilateral has no area</source>
        <translation>四边形没有面积</translation>
    </message>
    <message>
        <source>the quadrilateral is not convex</source>
        <translation>四边形不是凸的</translation>
    </message>
    <message>
        <source>the quadrilateral is not flat</source>
        <translation>四边形不是平的</translation>
    </message>
    <message>
        <source>the radius at point {i} is not positive</source>
        <translation>点 {i} 处的半径不是正数</translation>
    </message>
    <message>
        <source>not a plan&apos;s report: {why}</source>
        <translation>不是规划的报告：{why}</translation>
    </message>
    <message>
        <source>the robot motion is empty</source>
        <translation>机器人运动为空</translation>
    </message>
    <message>
        <source>the rod is thicker than the part and contains all of it</source>
        <translation>芯棒比零件粗，并包含整个零件</translation>
    </message>
    <message>
        <source>the rod extends {reach} mm from its middle; the cell has room for {room} mm</source>
        <translation>芯棒从中点延伸 {reach} mm；工作单元可容纳 {room} mm</translation>
    </message>
    <message>
        <source>the rod&apos;s radius is {radius} mm; the cell prints up to {most} mm</source>
        <translation>芯棒半径为 {radius} mm；工作单元最大可打印 {most} mm</translation>
    </message>
    <message>
        <source>the root at {x:.1f}, {y:.1f}, {z:.1f} mm is not on the plate</source>
        <translation>位于 {x:.1f}, {y:.1f}, {z:.1f} mm 的根部不在打印板上</translation>
    </message>
    <message>
        <source>the row has {cells} cells, the first one {first}</source>
        <translation>该行有 {cells} 个单元格，第一行有 {first} 个</translation>
    </message>
    <message>
        <source>the body of the surface contains the whole part</source>
        <translation>表面的实体包含整个零件</translation>
    </message>
    <message>
        <source>the voxel object is lifted by a fraction of a voxel: it is cut into new voxels</source>
        <translation>体素对象抬升了不足一个体素：将重新切成新的体素</translation>
    </message>
    <message>
        <source>the voxel object is not rotated by a multiple of 90°: it is cut into new voxels</source>
        <translation>体素对象的旋转不是 90° 的倍数：将重新切成新的体素</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>对于此尺寸的零件，体素太小</translation>
    </message>
    <message>
        <source>the {format} program is not released: {failed}</source>
        <translation>{format} 程序不予放行：{failed}</translation>
    </message>
    <message>
        <source>there is no layer {layer}</source>
        <translation>没有层 {layer}</translation>
    </message>
    <message>
        <source>no module</source>
        <translation>没有模块</translation>
    </message>
    <message>
        <source>there is no platform: no - in any row</source>
        <translation>没有平台：任何一行都没有 -</translation>
    </message>
    <message>
        <source>there is no time {time}</source>
        <translation>没有时刻 {time}</translation>
    </message>
    <message>
        <source>thicken the wall to {least} or more</source>
        <translation>将壁加厚到 {least} 或以上</translation>
    </message>
    <message>
        <source>thickness classes</source>
        <translation>厚度等级</translation>
    </message>
    <message>
        <source>OpenGL 3.2 without a display is not available: {why}</source>
        <translation>无法使用无显示器的 OpenGL 3.2：{why}</translation>
    </message>
    <message>
        <source>this is not the module that main runs next</source>
        <translation>这不是 main 接下来运行的模块</translation>
    </message>
    <message>
        <source>this motion and the one at {other} are swapped</source>
        <translation>此运动与 {other} 处的运动互换了</translation>
    </message>
    <message>
        <source>this motion deposits {volume:.3f} instead of {planned:.3f}</source>
        <translation>此运动沉积 {volume:.3f}，应为 {planned:.3f}</translation>
    </message>
    <message>
        <source>this motion takes {time:.3f} instead of {planned:.3f}</source>
        <translation>此运动用时 {time:.3f}，应为 {planned:.3f}</translation>
    </message>
    <message>
        <source>time decreases</source>
        <translation>时间减小</translation>
    </message>
    <message>
        <source>too many triangles for an STL file</source>
        <translation>三角形过多，无法存为 STL 文件</translation>
    </message>
    <message>
        <source>tool-paths</source>
        <translation>工具路径</translation>
    </message>
    <message>
        <source>touch points farther apart around the cylinder</source>
        <translation>在圆柱周围触碰相距更远的点</translation>
    </message>
    <message>
        <source>touched points</source>
        <translation>触碰点</translation>
    </message>
    <message>
        <source>trimming layers on the part</source>
        <translation>按零件修剪层</translation>
    </message>
    <message>
        <source>try a larger `voxelMm` or a smaller part</source>
        <translation>尝试更大的 `voxelMm` 或更小的零件</translation>
    </message>
    <message>
        <source>to keep its voxels, rotate it by multiples of 90° and lift it by whole voxels</source>
        <translation>要保留其体素，按 90° 的倍数旋转，并按整体素抬升</translation>
    </message>
    <message>
        <source>infill rotation per layer</source>
        <translation>填充逐层旋转角</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), add supports, or use planar or curved mode</source>
        <translation>转动零件（`orient=leastRisky`），添加支撑，或使用平面分块或曲面层</translation>
    </message>
    <message>
        <source>turn the part (`orient=leastRisky`), or use planar or curved mode</source>
        <translation>转动零件（`orient=leastRisky`），或使用平面分块或曲面层</translation>
    </message>
    <message>
        <source>turn the part about the vertical, or try more rotations (`redundancySamples`)</source>
        <translation>绕竖直轴转动零件，或尝试更多旋转角（`redundancySamples`）</translation>
    </message>
    <message>
        <source>turn the part, enlarge the platform or add supports</source>
        <translation>转动零件，加大平台或添加支撑</translation>
    </message>
    <message>
        <source>turn the part, make the platform smaller or add supports</source>
        <translation>转动零件，缩小平台或添加支撑</translation>
    </message>
    <message>
        <source>turn the part, or allow less clearance</source>
        <translation>转动零件，或允许更小的安全间距</translation>
    </message>
    <message>
        <source>turn the part, use a smaller platform, or allow less clearance</source>
        <translation>转动零件，使用更小的平台，或允许更小的安全间距</translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} inside-out components</source>
        <translation>
            <numerusform>翻转了 {count} 个内外颠倒的组件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>flipped {count} triangles to match their neighbours</source>
        <translation>
            <numerusform>翻转了 {count} 个三角形，使其与相邻三角形一致</numerusform>
        </translation>
    </message>
    <message>
        <source>turn the part: other orientations may need fewer</source>
        <translation>转动零件：其他朝向所需可能更少</translation>
    </message>
    <message>
        <source>rotations tried per point</source>
        <translation>每点尝试的旋转数</translation>
    </message>
    <message>
        <source>two commands in one line</source>
        <translation>一行中有两条指令</translation>
    </message>
    <message numerus="yes">
        <source>merged {count} overlapping components</source>
        <translation>
            <numerusform>合并了 {count} 个重叠的组件</numerusform>
        </translation>
    </message>
    <message>
        <source>unknown cell &apos;{id}&apos;</source>
        <translation>未知工作单元“{id}”</translation>
    </message>
    <message>
        <source>unknown cell &apos;{name}&apos;</source>
        <translation>未知工作单元“{name}”</translation>
    </message>
    <message>
        <source>unknown colour &apos;{name}&apos;</source>
        <translation>未知颜色“{name}”</translation>
    </message>
    <message>
        <source>unknown failure</source>
        <translation>未知故障</translation>
    </message>
    <message>
        <source>unknown format &apos;{id}&apos;</source>
        <translation>未知格式“{id}”</translation>
    </message>
    <message>
        <source>unknown format &apos;{name}&apos;</source>
        <translation>未知格式“{name}”</translation>
    </message>
    <message>
        <source>unknown growth &apos;{name}&apos;</source>
        <translation>未知生长方式“{name}”</translation>
    </message>
    <message>
        <source>unknown infill &apos;{id}&apos;</source>
        <translation>未知填充“{id}”</translation>
    </message>
    <message>
        <source>unknown key &apos;{key}&apos;</source>
        <translation>未知键“{key}”</translation>
    </message>
    <message>
        <source>unknown mode &apos;{name}&apos;</source>
        <translation>未知模式“{name}”</translation>
    </message>
    <message>
        <source>unknown parameter &apos;{key}&apos;</source>
        <translation>未知参数“{key}”</translation>
    </message>
    <message>
        <source>unknown picture &apos;{name}&apos;</source>
        <translation>未知图片“{name}”</translation>
    </message>
    <message>
        <source>unknown platform &apos;{name}&apos;</source>
        <translation>未知平台“{name}”</translation>
    </message>
    <message>
        <source>unknown process &apos;{id}&apos;</source>
        <translation>未知工艺“{id}”</translation>
    </message>
    <message>
        <source>unknown process &apos;{name}&apos;</source>
        <translation>未知工艺“{name}”</translation>
    </message>
    <message>
        <source>unknown robot &apos;{id}&apos;</source>
        <translation>未知机器人“{id}”</translation>
    </message>
    <message>
        <source>unknown sample &apos;{name}&apos;</source>
        <translation>未知示例“{name}”</translation>
    </message>
    <message>
        <source>unknown stage &apos;{name}&apos;</source>
        <translation>未知阶段“{name}”</translation>
    </message>
    <message>
        <source>unknown view &apos;{name}&apos;</source>
        <translation>未知视图“{name}”</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print the part larger</source>
        <translation>使用更细的喷嘴，或将零件打印得更大</translation>
    </message>
    <message>
        <source>use a larger platform (fit:MARGIN), or turn the part</source>
        <translation>使用更大的平台 (fit:MARGIN)，或转动零件</translation>
    </message>
    <message>
        <source>use a slimmer print head, turn the part, or print it larger</source>
        <translation>使用更细长的打印头，转动零件，或将其打印得更大</translation>
    </message>
    <message>
        <source>use a slimmer print head or thinner layers</source>
        <translation>使用更细长的打印头或更薄的层</translation>
    </message>
    <message>
        <source>use a smaller platform or place the part higher</source>
        <translation>使用更小的平台，或将零件放得更高</translation>
    </message>
    <message>
        <source>use a thinner rod, or print the part larger</source>
        <translation>使用更细的芯棒，或将零件打印得更大</translation>
    </message>
    <message>
        <source>use at least {least}</source>
        <translation>至少使用 {least}</translation>
    </message>
    <message>
        <source>use at most {side} cells a side and {millions} million in all</source>
        <translation>每边最多使用 {side} 个单元格，总数不超过 {millions} 百万</translation>
    </message>
    <message>
        <source>use infill zigzag or concentric, or mode lathe</source>
        <translation>使用 zigzag 或 concentric 填充，或 lathe 模式</translation>
    </message>
    <message>
        <source>use lower layers or a finer nozzle, or print the part larger</source>
        <translation>使用更低的层或更细的喷嘴，或将零件打印得更大</translation>
    </message>
    <message>
        <source>voxelise</source>
        <translation>体素化</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>voxels of {width} need about {needed} of memory; {available} are free</source>
        <translation>宽 {width} 的体素约需 {needed} 内存；可用 {available}</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>UnLoad of a module that was not loaded and run</source>
        <translation>UnLoad 的模块未曾加载并运行</translation>
    </message>
    <message>
        <source>winding angle</source>
        <translation>缠绕角</translation>
    </message>
    <message>
        <source>woven</source>
        <translation>编织</translation>
    </message>
    <message>
        <source>write 1 for the part, 0 for air, - for the platform</source>
        <translation>用 1 表示零件，0 表示空气，- 表示平台</translation>
    </message>
    <message>
        <source>write 1 where the part is</source>
        <translation>在零件所在处写 1</translation>
    </message>
    <message>
        <source>write files</source>
        <translation>写出文件</translation>
    </message>
    <message>
        <source>write flat, flat:Z, radius:R or mesh:FILE, in mm</source>
        <translation>写 flat、flat:Z、radius:R 或 mesh:FILE，单位 mm</translation>
    </message>
    <message>
        <source>write pairs such as -20,2.5 0,2.5 0,3.5 20,3.5 in mm</source>
        <translation>写数对，如 -20,2.5 0,2.5 0,3.5 20,3.5，单位 mm</translation>
    </message>
    <message>
        <source>write refused programs</source>
        <translation>写出被拒绝的程序</translation>
    </message>
    <message>
        <source>write rows of 0 and 1, and - for the platform</source>
        <translation>写由 0 和 1 组成的行，平台用 -</translation>
    </message>
    <message>
        <source>write the program again; to keep this change, make it in the plan</source>
        <translation>重新写出程序；要保留此更改，请在规划中进行</translation>
    </message>
    <message>
        <source>write intermediate results</source>
        <translation>写出中间结果</translation>
    </message>
    <message>
        <source>write x,y,z in mm</source>
        <translation>写 x,y,z，单位 mm</translation>
    </message>
    <message>
        <source>write x,y,z in mm, such as 10,0,5</source>
        <translation>写 x,y,z，单位 mm，如 10,0,5</translation>
    </message>
    <message>
        <source>writing {format}</source>
        <translation>写出 {format}</translation>
    </message>
    <message>
        <source>write {form}</source>
        <translation>写 {form}</translation>
    </message>
    <message>
        <source>write {form}, in mm</source>
        <translation>写 {form}，单位 mm</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x decreases at point {i}</source>
        <translation>x 在点 {i} 处减小</translation>
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
        <translation>之字形</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle}</source>
        <translation>{area:.3g} 悬垂超过 {angle}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at x = {x:.4g}, radius {radius:.4g}</source>
        <translation>{area:.3g} 相对下层悬垂超过 {angle:.3g}，最严重处在 x = {x:.4g}，半径 {radius:.4g}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs lower layers by more than {angle:.3g}, most at {at:.4g}</source>
        <translation>{area:.3g} 相对下层悬垂超过 {angle:.3g}，最严重处在 {at:.4g}</translation>
    </message>
    <message numerus="yes">
        <source>{bad} of {facets} facets have NaN or out-of-range coordinates, first at facet {first}</source>
        <translation>
            <numerusform>{facets} 个面片中有 {bad} 个坐标为 NaN 或超出范围，第一个是面片 {first}</numerusform>
        </translation>
    </message>
    <message>
        <source>blocked pieces: {blocked} of {pieces}; earlier pieces are in the print head&apos;s way</source>
        <translation>受阻的分块：{pieces} 个中有 {blocked} 个；先打印的分块挡住了打印头</translation>
    </message>
    <message numerus="yes">
        <source>{columns} more support columns under voxels that would be missed</source>
        <translation>
            <numerusform>在会被遗漏的体素下另有 {columns} 根支撑柱</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} inside-out components, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} 个内外颠倒的组件，第一个在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} duplicate triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} 个重复三角形，第一个在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with inconsistently oriented triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} 条边的三角形朝向不一致，第一条在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} edges with more than two triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} 条边有两个以上三角形，第一条在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} open edges in {loops} loops, the first at {first:.2f}</source>
        <translation>
            <numerusform>{loops} 个环中有 {count} 条开放边，第一条在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} pairs of intersecting triangles, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} 对三角形相交，第一对在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} triangles without area, the first at {first:.2f}</source>
        <translation>
            <numerusform>{count} 个无面积三角形，第一个在 {first:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{count} voxels</source>
        <translation>
            <numerusform>{count} 个体素</numerusform>
        </translation>
    </message>
    <message>
        <source>{file}, byte {byte}</source>
        <translation>{file}，字节 {byte}</translation>
    </message>
    <message>
        <source>{file}, line {line}</source>
        <translation>{file}，第 {line} 行</translation>
    </message>
    <message>
        <source>{file}, line {line}, column {column}</source>
        <translation>{file}，第 {line} 行，第 {column} 列</translation>
    </message>
    <message>
        <source>{first} and {second} collide</source>
        <translation>{first} 与 {second} 碰撞</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the finished motion</source>
        <translation>在最终运动中 {first} 与 {second} 碰撞</translation>
    </message>
    <message>
        <source>{found} is none of 0, 1 and -</source>
        <translation>{found} 不是 0、1 或 -</translation>
    </message>
    <message>
        <source>{joint} at {angle:.1f}, beyond its limit of {limit:.1f#}</source>
        <translation>{joint} 为 {angle:.1f}，超出其极限 {limit:.1f#}</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}, above its limit of {limit:.1f#}</source>
        <translation>{joint} 为 {speed:.1f}，超过其极限 {limit:.1f#}</translation>
    </message>
    <message>
        <source>not covered by layers: {left:.3g#} of {whole:.4g} of the part</source>
        <translation>未被层覆盖：零件 {whole:.4g} 中的 {left:.3g#}</translation>
    </message>
    <message numerus="yes">
        <source>{motions} motions from here on are not in the plan</source>
        <translation>
            <numerusform>从此处起有 {motions} 个运动不在规划中</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing before this one</source>
        <translation>
            <numerusform>在此之前缺少 {motions} 个规划的运动</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{motions} planned motions are missing between {before} and this one</source>
        <translation>
            <numerusform>在 {before} 与此之间缺少 {motions} 个规划的运动</numerusform>
        </translation>
    </message>
    <message>
        <source>{option}: a value is not finite</source>
        <translation>{option}：某个值不是有限数</translation>
    </message>
    <message>
        <source>{option}: {wanted} numbers expected, {given} given</source>
        <translation>{option}：应有 {wanted} 个数字，给出 {given} 个</translation>
    </message>
    <message>
        <source>{outside:.2f} of the part&apos;s volume is deposited outside it, {noRoom:.2f} does not fit</source>
        <translation>零件体积的 {outside:.2f} 沉积在零件之外，{noRoom:.2f} 放不下</translation>
    </message>
    <message numerus="yes">
        <source>{patches} patches ({area:.1f}) begin in the air: neither the plate nor an earlier layer is below them</source>
        <translation>
            <numerusform>{patches} 个面块（{area:.1f}）从空中开始：其下方既没有打印板，也没有先前的层</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out: too small for a bead, or they would begin in the air ({volume:.1f} in all, the largest {largest:.1f})</source>
        <translation>
            <numerusform>省略了 {pieces} 块层：小于一条挤出线，或会从空中开始（共 {volume:.1f}，最大 {largest:.1f}）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers are left out, {volume:.3g} of {whole:.3g#}: too small for a bead, or they would begin in the air</source>
        <translation>
            <numerusform>省略了 {pieces} 块层，{whole:.3g#} 中的 {volume:.3g}：小于一条挤出线，或会从空中开始</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the rod nor an earlier layer</source>
        <translation>
            <numerusform>{pieces} 块层从空中开始，其下既没有芯棒也没有先前的层</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air, over neither the surface nor an earlier layer</source>
        <translation>
            <numerusform>{pieces} 块层从空中开始，其下既没有表面也没有先前的层</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{pieces} pieces of layers begin in the air</source>
        <translation>
            <numerusform>{pieces} 块层从空中开始</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} places where the program differs from the plan</source>
        <translation>
            <numerusform>{places} 处程序与规划不同</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places are thinner than a voxel of {voxel}; this is the largest, the thinnest is {thinnest:.2f} thick</source>
        <translation>
            <numerusform>另有 {places} 个较小的位置薄于一个体素 {voxel}；此处最大，最薄处厚 {thinnest:.2f}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{places} smaller places overhang too far, {area:.3g} in all; this is the largest</source>
        <translation>
            <numerusform>另有 {places} 个较小的位置悬垂过大，共 {area:.3g}；此处最大</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer to {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}：没有无碰撞的转移路线到达 {pieces} 段路径</numerusform>
        </translation>
    </message>
    <message>
        <source>{place}: too far from the rod: the cell prints up to {radius} from its axis and {along} from its middle</source>
        <translation>{place}：离芯棒太远：工作单元可打印到距其轴线 {radius}、距其中点 {along} 处</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into the platform</source>
        <translation>{place}：打印头会切入平台</translation>
    </message>
    <message>
        <source>{place}: the print head would cut into printed material</source>
        <translation>{place}：打印头会切入已打印材料</translation>
    </message>
    <message>
        <source>{place}: reachable, but the robot cannot move from or to a neighbouring point without lifting</source>
        <translation>{place}：可达，但机器人不抬升就无法在相邻点之间移动</translation>
    </message>
    <message>
        <source>{place}: out of the robot&apos;s reach, or beyond a joint limit, at every rotation tried about the nozzle</source>
        <translation>{place}：在尝试的所有绕喷嘴旋转角下，都超出机器人可达范围或关节极限</translation>
    </message>
    <message>
        <source>{place}: {first} would collide with {second} at every rotation tried about the nozzle</source>
        <translation>{place}：在尝试的所有绕喷嘴旋转角下，{first} 都会与 {second} 碰撞</translation>
    </message>
    <message>
        <source>{points} points do not define a circle: at least three are needed</source>
        <translation>{points} 个点无法确定圆：至少需要三个</translation>
    </message>
    <message>
        <source>{share:.0f} of the layers&apos; area is thinner than {least} or thicker than {most}</source>
        <translation>层面积的 {share:.0f} 薄于 {least} 或厚于 {most}</translation>
    </message>
    <message>
        <source>{share:.2f} of the part is not covered by beads, mostly around this point</source>
        <translation>零件的 {share:.2f} 未被挤出线覆盖，主要在此点周围</translation>
    </message>
    <message>
        <source>{sizes} mm</source>
        <translation>{sizes} mm</translation>
    </message>
    <message>
        <source>{there} of the {promised} facets stated in the header are present</source>
        <translation>文件头声明 {promised} 个面片，实有 {there} 个</translation>
    </message>
    <message>
        <source>{threshold} {value:.4g} (limit {limit:.4g})</source>
        <translation>{threshold} {value:.4g}（极限 {limit:.4g}）</translation>
    </message>
    <message>
        <source>{value} is outside the limits of process {process}</source>
        <translation>{value} 超出工艺 {process} 的限制</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} more voxels are missed in smaller groups ({groups}); this is the largest</source>
        <translation>
            <numerusform>另有 {voxels} 个体素在较小的组中被遗漏（{groups}）；此组最大</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front from step {step} on, under its facet between {a:.0f}, {b:.0f} and {c:.0f} mm</source>
        <translation>
            <numerusform>{voxels} 个体素被遮蔽：从第 {step} 步起被凸前沿覆盖，位于其 {a:.0f}、{b:.0f} 和 {c:.0f} mm 之间的面片之下</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are shadowed: covered by the convex front before growth reached them</source>
        <translation>
            <numerusform>{voxels} 个体素被遮蔽：在生长到达之前被凸前沿覆盖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are unreached: no path through the part from the platform</source>
        <translation>
            <numerusform>{voxels} 个体素未到达：从平台出发没有穿过零件的通路</numerusform>
        </translation>
    </message>
    <message>
        <source>{voxels} voxels in a grid of {cells} cells need about {needed} of memory; {available} are free</source>
        <translation>{cells} 单元网格中的 {voxels} 个体素约需 {needed} 内存；可用 {available}</translation>
    </message>
    <message numerus="yes">
        <source>{voxels} voxels are below the plate</source>
        <translation>
            <numerusform>{voxels} 个体素低于打印板</numerusform>
        </translation>
    </message>
    <message>
        <source>{where}, entry {number}</source>
        <translation>{where}，条目 {number}</translation>
    </message>
    <message>
        <source>Contact area, margin</source>
        <translation>接触面，余量</translation>
    </message>
    <message>
        <source>Rod of the cell</source>
        <translation>工作单元的芯棒</translation>
    </message>
    <message>
        <source>Disc, diameter</source>
        <translation>圆盘，直径</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Rod, diameter × length</source>
        <translation>芯棒，直径 × 长度</translation>
    </message>
    <message>
        <source>Body from a file</source>
        <translation>来自文件的实体</translation>
    </message>
    <message>
        <source>Margin around the contact area</source>
        <translation>接触面周围的余量</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>宽度 (X)</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>深度 (Y)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Curved layers</source>
        <translation>曲面层</translation>
    </message>
    <message>
        <source>Extended G-code (nozzle direction as nX nY nZ)</source>
        <translation>扩展 G-code（喷嘴方向为 nX nY nZ）</translation>
    </message>
    <message>
        <source>Joint table (CSV)</source>
        <translation>关节表 (CSV)</translation>
    </message>
    <message>
        <source>contact area</source>
        <translation>接触面</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Peels the part and keeps the best of several passes</source>
        <translation>剥离零件，保留多轮中最好的一轮</translation>
    </message>
    <message>
        <source>Reverse peeling</source>
        <translation>反向剥离</translation>
    </message>
    <message>
        <source>Removes voxels from outside while the rest stays supported; printed in the opposite order</source>
        <translation>只要其余部分仍有支承，就从外部移除体素；按相反顺序打印</translation>
    </message>
    <message>
        <source>Guided by peeling</source>
        <translation>剥离引导</translation>
    </message>
    <message>
        <source>Grows from the platform, held back by the peeling field</source>
        <translation>从平台生长，受剥离场约束</translation>
    </message>
    <message>
        <source>Halved layers</source>
        <translation>减半层</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer that would shadow voxels is halved until it does not</source>
        <translation>从平台生长；会遮蔽体素的层不断减半，直到不再遮蔽</translation>
    </message>
    <message>
        <source>Voxel by voxel</source>
        <translation>逐体素</translation>
    </message>
    <message>
        <source>Grows from the platform; a layer takes each voxel that shadows no other</source>
        <translation>从平台生长；一层纳入每个不遮蔽其他体素的体素</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>贪心</translation>
    </message>
    <message>
        <source>Grows from the platform by whole layers, whatever they shadow</source>
        <translation>从平台按整层生长，不管遮蔽什么</translation>
    </message>
    <message>
        <source>Drop to plate</source>
        <translation>落到打印板</translation>
    </message>
    <message>
        <source>Lowers the part onto the plate</source>
        <translation>将零件降到打印板上</translation>
    </message>
    <message>
        <source>Shrink platform</source>
        <translation>缩小平台</translation>
    </message>
    <message>
        <source>To the part&apos;s contact area, which narrows the front</source>
        <translation>缩到零件的接触面，使前沿变窄</translation>
    </message>
    <message>
        <source>Add supports</source>
        <translation>添加支撑</translation>
    </message>
    <message>
        <source>As few thin break-away columns as possible</source>
        <translation>尽可能少的可掰除细柱</translation>
    </message>
    <message>
        <source>Turn the part</source>
        <translation>转动零件</translation>
    </message>
    <message>
        <source>Searches the orientation with the fewest missed voxels</source>
        <translation>搜索遗漏体素最少的朝向</translation>
    </message>
    <message>
        <source>Narrow enough for this wall; narrower voxels take longer</source>
        <translation>对此壁足够窄；更窄的体素耗时更长</translation>
    </message>
    <message>
        <source>Planar pieces</source>
        <translation>平面分块</translation>
    </message>
    <message>
        <source>Flat layers</source>
        <translation>平面层</translation>
    </message>
    <message>
        <source>Widen the platform</source>
        <translation>加宽平台</translation>
    </message>
    <message>
        <source>By 20 mm on all sides, to give supports a base</source>
        <translation>四周各加 20 mm，为支撑提供底座</translation>
    </message>
    <message>
        <source>Adapt the layers</source>
        <translation>层自适应</translation>
    </message>
    <message>
        <source>Thinner layers on sloping surfaces, to reduce the gaps at steps</source>
        <translation>斜面上使用更薄的层，减小台阶处的间隙</translation>
    </message>
    <message>
        <source>Searches the orientation with the smallest area to support</source>
        <translation>搜索需要支撑的面积最小的朝向</translation>
    </message>
    <message>
        <source>Around a rod</source>
        <translation>围绕芯棒</translation>
    </message>
    <message>
        <source>On a given surface</source>
        <translation>在给定表面上</translation>
    </message>
    <message>
        <source>repair the mesh, or use curved mode, which takes any mesh</source>
        <translation>修复网格，或使用接受任何网格的曲面层</translation>
    </message>
    <message>
        <source>a planar section of the mesh crosses itself</source>
        <translation>网格的某个平面截面自相交</translation>
    </message>
    <message>
        <source>EGL cannot be initialized</source>
        <translation>无法初始化 EGL</translation>
    </message>
    <message>
        <source>EGL does not support platform displays</source>
        <translation>EGL 不支持平台显示 (platform display)</translation>
    </message>
    <message>
        <source>its functions were not found</source>
        <translation>未找到其函数</translation>
    </message>
    <message>
        <source>no context can be made</source>
        <translation>无法创建上下文</translation>
    </message>
    <message>
        <source>the context cannot be used</source>
        <translation>无法使用上下文</translation>
    </message>
    <message>
        <source>Plate of the cell</source>
        <translation>工作单元的打印板</translation>
    </message>
    <message>
        <source>cell {cell} has no plates</source>
        <translation>工作单元 {cell} 没有打印板</translation>
    </message>
    <message>
        <source>choose another platform, or another cell</source>
        <translation>选择另一个平台，或另一个工作单元</translation>
    </message>
    <message>
        <source>copy it to a file first</source>
        <translation>先将其复制到文件</translation>
    </message>
    <message>
        <source>give `--platform disc:DIAMETER`, or another platform</source>
        <translation>指定 `--platform disc:DIAMETER`，或另一个平台</translation>
    </message>
    <message>
        <source>is not a regular file, but a device or a pipe</source>
        <translation>不是普通文件，而是设备或管道</translation>
    </message>
    <message>
        <source>check these places in the view; turn the part if they matter</source>
        <translation>在视图中检查这些位置；如果重要，转动零件</translation>
    </message>
    <message>
        <source>no way of building supports platform {platform} in cell {cell}</source>
        <translation>没有构建方式支持工作单元 {cell} 中的平台 {platform}</translation>
    </message>
    <message>
        <source>plate of the cell</source>
        <translation>工作单元的打印板</translation>
    </message>
    <message>
        <source>transfers</source>
        <translation>转移</translation>
    </message>
    <message>
        <source>{place}: skipped, because of a collision on the way to it</source>
        <translation>{place}：因途中碰撞而跳过</translation>
    </message>
    <message numerus="yes">
        <source>{place}: no collision-free transfer away from the ends of {pieces} pieces of paths</source>
        <translation>
            <numerusform>{place}：没有无碰撞的转移路线离开 {pieces} 段路径的末端</numerusform>
        </translation>
    </message>
    <message>
        <source>a mesh with defects cannot be cut into pieces</source>
        <translation>有缺陷的网格无法切成分块</translation>
    </message>
    <message>
        <source>&apos;{units}&apos; is not a unit of length</source>
        <translation>“{units}”不是长度单位</translation>
    </message>
    <message>
        <source>Scales it by 25.4</source>
        <translation>放大 25.4 倍</translation>
    </message>
    <message>
        <source>Scales it by 1000</source>
        <translation>放大 1000 倍</translation>
    </message>
    <message>
        <source>Scales it by 0.001</source>
        <translation>缩放 0.001 倍</translation>
    </message>
    <message>
        <source>Large enough for the narrowest bead</source>
        <translation>大到足以容纳最窄的挤出线</translation>
    </message>
    <message>
        <source>The largest scale within the robot&apos;s reach</source>
        <translation>机器人可达范围内的最大比例</translation>
    </message>
    <message>
        <source>Centre the part</source>
        <translation>零件居中</translation>
    </message>
    <message>
        <source>The file is in inches</source>
        <translation>文件单位为英寸</translation>
    </message>
    <message>
        <source>The file is in metres</source>
        <translation>文件单位为米</translation>
    </message>
    <message>
        <source>The file is in micrometres</source>
        <translation>文件单位为微米</translation>
    </message>
    <message>
        <source>On the platform&apos;s position</source>
        <translation>置于平台的位置</translation>
    </message>
    <message>
        <source>Print at scale {scale}</source>
        <translation>以比例 {scale} 打印</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>缩放至合适</translation>
    </message>
    <message>
        <source>Use a finer process</source>
        <translation>使用更精细的工艺</translation>
    </message>
    <message>
        <source>With the widest bead that fits these walls</source>
        <translation>使用适合这些壁的最宽挤出线</translation>
    </message>
    <message>
        <source>give one of {known}</source>
        <translation>给出 {known} 之一</translation>
    </message>
    <message>
        <source>give the units it was drawn in (`--units`)</source>
        <translation>给出绘制时的单位（`--units`）</translation>
    </message>
    <message>
        <source>centre the part, or use a platform that reaches its support</source>
        <translation>将零件居中，或使用能到达其支承的平台</translation>
    </message>
    <message>
        <source>print it at scale {scale}, or use a process with narrower beads</source>
        <translation>以比例 {scale} 打印，或使用挤出线更窄的工艺</translation>
    </message>
    <message>
        <source>print it smaller (`--scale fit`), or give the units it was drawn in (`--units`)</source>
        <translation>打印得更小（`--scale fit`），或给出绘制时的单位（`--units`）</translation>
    </message>
    <message>
        <source>the part is very small: {size:.3g} long if its file is in millimetres</source>
        <translation>零件非常小：若文件单位为毫米，长 {size:.3g}</translation>
    </message>
    <message>
        <source>the part is very large: {size:.4g} long if its file is in millimetres</source>
        <translation>零件非常大：若文件单位为毫米，长 {size:.4g}</translation>
    </message>
    <message>
        <source>platform {distance:.0f} beside its support: it would float</source>
        <translation>平台在其支承旁 {distance:.0f} 处：会悬空</translation>
    </message>
    <message>
        <source>use a process with narrower beads; scaled up enough, the part is out of the robot&apos;s reach</source>
        <translation>使用挤出线更窄的工艺；放大到足够尺寸时，零件超出机器人可达范围</translation>
    </message>
    <message>
        <source>{share:.3g} of the part is thinner than the narrowest bead ({least}); most of it is {usual:.2f} thick</source>
        <translation>零件的 {share:.3g} 薄于最窄的挤出线（{least}）；大部分厚 {usual:.2f}</translation>
    </message>
    <message>
        <source>Use best orientation</source>
        <translation>使用最佳朝向</translation>
    </message>
    <message>
        <source>Most contact relative to the overhang, and fewest missed voxels</source>
        <translation>相对悬垂接触面最大，且遗漏体素最少</translation>
    </message>
    <message>
        <source>give degrees about x, y and z: 90,0,0</source>
        <translation>给出绕 x、y 和 z 的角度：90,0,0</translation>
    </message>
    <message>
        <source>use that orientation, turned by {x:.3g} about x, {y:.3g} about y and {z:.3g} about z, or choose another one</source>
        <translation>使用该朝向，即绕 x 转 {x:.3g}、绕 y 转 {y:.3g}、绕 z 转 {z:.3g}，或另选一个</translation>
    </message>
    <message>
        <source>poor orientation: contact {contact:.0f}, overhang {overhang:.0f}, {missed:.2g} of the voxels missed; another orientation has contact {bestContact:.0f}, overhang {bestOverhang:.0f}, {bestMissed:.2g} missed</source>
        <translation>朝向不佳：接触 {contact:.0f}，悬垂 {overhang:.0f}，遗漏体素 {missed:.2g}；另一朝向接触 {bestContact:.0f}，悬垂 {bestOverhang:.0f}，遗漏 {bestMissed:.2g}</translation>
    </message>
    <message>
        <source>turn &apos;{turn}&apos; is not three angles</source>
        <translation>旋转“{turn}”不是三个角度</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>{length:.1f} of a bead is unsupported; this material bridges {bridge:.1f}</source>
        <translation>挤出线有 {length:.1f} 无支承；此材料可桥接 {bridge:.1f}</translation>
    </message>
    <message>
        <source>use a pedestal made for the part: it leaves room for the print head; a drawing of it is written</source>
        <translation>使用为零件定制的底座：可为打印头留出空间；会写出其图纸</translation>
    </message>
    <message numerus="yes">
        <source>without columns, {here} voxels would be missed on this plate, {there} on a pedestal as wide as the part&apos;s footprint</source>
        <translation>
            <numerusform>不用立柱时，在此打印板上会遗漏 {here} 个体素，在与零件占地轮廓同宽的底座上会遗漏 {there} 个</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;unitfactor&apos; is not above 0</source>
        <translation>&apos;unitfactor&apos; 不大于 0</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is not above 0, or too large</source>
        <translation>“{attribute}”不大于 0，或太大</translation>
    </message>
    <message>
        <source>&apos;{element}&apos; outside tool-paths</source>
        <translation>“{element}”位于工具路径之外</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; calls itself</source>
        <translation>“{name}”调用自身</translation>
    </message>
    <message>
        <source>invalid call of &apos;{name}&apos;</source>
        <translation>对“{name}”的调用无效</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; needs a mass</source>
        <translation>“{name}”需要重量</translation>
    </message>
    <message>
        <source>&apos;{path}&apos; is not the name of a part in the package</source>
        <translation>“{path}”不是包中部件的名称</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not allowed here: it changes the machine during the print</source>
        <translation>此处不允许“{word}”：它会在打印中改变机器</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; slows the arm: the flow would not follow</source>
        <translation>“{word}”使机械臂减速：流量无法跟随</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; sets a different load</source>
        <translation>“{word}”设置了不同的负载</translation>
    </message>
    <message>
        <source>Prints a file along its own tool-paths (.build.3mf, .gcode). Off: plans new ones for its object.</source>
        <translation>沿文件自身的工具路径打印 (.build.3mf, .gcode)。关：为其对象规划新的工具路径。</translation>
    </message>
    <message>
        <source>Adds NAME.build.3mf: the plan&apos;s 6-axis tool-paths for other programs (3MF Toolpath Extension).</source>
        <translation>另外写出 NAME.build.3mf：供其他程序使用的规划 6 轴工具路径（3MF Toolpath Extension）。</translation>
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
        <translation>程序</translation>
    </message>
    <message>
        <source>RAPID modules</source>
        <translation>RAPID 模块</translation>
    </message>
    <message>
        <source>URScript for</source>
        <translation>URScript 用于</translation>
    </message>
    <message>
        <source>a TriggL before its TriggEquip</source>
        <translation>TriggL 出现在其 TriggEquip 之前</translation>
    </message>
    <message>
        <source>a bead is printed by a joint motion instead of a straight one</source>
        <translation>挤出线用关节运动而非直线运动打印</translation>
    </message>
    <message>
        <source>unexpected control character: is this a binary file?</source>
        <translation>意外的控制字符：这是二进制文件吗？</translation>
    </message>
    <message>
        <source>use a larger nozzle, or slower tool-paths</source>
        <translation>使用更大的喷嘴，或更慢的工具路径</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos; without a range above 0 or without a factor of e, f, g and h</source>
        <translation>“{attribute}”的修饰符没有大于 0 的范围，或没有 e、f、g、h 中的系数</translation>
    </message>
    <message>
        <source>an unsupported modifier of &apos;{attribute}&apos;</source>
        <translation>“{attribute}”的修饰符不受支持</translation>
    </message>
    <message>
        <source>a modifier of &apos;{attribute}&apos;, which its profile lacks</source>
        <translation>“{attribute}”的修饰符在其配置中不存在</translation>
    </message>
    <message>
        <source>a modifier of unknown type &apos;{type}&apos;</source>
        <translation>修饰符的类型“{type}”未知</translation>
    </message>
    <message>
        <source>a modifier outside a profile</source>
        <translation>修饰符位于配置之外</translation>
    </message>
    <message>
        <source>a point more than a kilometre away</source>
        <translation>有一点在一公里以外</translation>
    </message>
    <message>
        <source>a point&apos;s frame has no direction</source>
        <translation>某点的坐标系没有方向</translation>
    </message>
    <message>
        <source>a second call outside the functions</source>
        <translation>函数之外的第二次调用</translation>
    </message>
    <message>
        <source>a segment of fewer than two points</source>
        <translation>线段少于两个点</translation>
    </message>
    <message>
        <source>a segment of type &apos;{type}&apos; among tool-paths of {axes} axes</source>
        <translation>{axes} 轴工具路径中有类型为“{type}”的段</translation>
    </message>
    <message>
        <source>a modifier&apos;s support point outside a point</source>
        <translation>修饰符的支承点在点之外</translation>
    </message>
    <message>
        <source>threads are not supported</source>
        <translation>不支持线程</translation>
    </message>
    <message>
        <source>a tool-path is beyond the range of a build file</source>
        <translation>工具路径超出构建文件的范围</translation>
    </message>
    <message>
        <source>a work object moved by both robot and external axis is not supported</source>
        <translation>不支持由机器人和外部轴共同移动的工件坐标对象</translation>
    </message>
    <message>
        <source>an unexpected {point}</source>
        <translation>意外的 {point}</translation>
    </message>
    <message>
        <source>a tool other than the printing one</source>
        <translation>不是打印工具的工具</translation>
    </message>
    <message>
        <source>requires the unknown extension &apos;{name}&apos;</source>
        <translation>需要未知的扩展“{name}”</translation>
    </message>
    <message>
        <source>at the controller&apos;s speeds, {share:.2f} of the bead length gets over 5 % too much or too little material</source>
        <translation>按控制器的速度，挤出线长度的 {share:.2f} 材料过多或过少超过 5 %</translation>
    </message>
    <message>
        <source>bead {bead}</source>
        <translation>挤出线 {bead}</translation>
    </message>
    <message>
        <source>choose an earlier or a later bead</source>
        <translation>选择更早或更晚的挤出线</translation>
    </message>
    <message>
        <source>choose an earlier place</source>
        <translation>选择更早的位置</translation>
    </message>
    <message>
        <source>factors of &apos;{attribute}&apos; are finer than its modifier&apos;s type allows</source>
        <translation>“{attribute}”的系数比其修饰符类型所允许的更细</translation>
    </message>
    <message>
        <source>from the front (x to the right, z up)</source>
        <translation>从前方（x 向右，z 向上）</translation>
    </message>
    <message>
        <source>from the side (y to the right, z up)</source>
        <translation>从侧面（y 向右，z 向上）</translation>
    </message>
    <message>
        <source>give --program</source>
        <translation>指定 --program</translation>
    </message>
    <message>
        <source>give --program, a file from {first} to {last}</source>
        <translation>指定 --program，即从 {first} 到 {last} 的一个文件</translation>
    </message>
    <message>
        <source>choose the process that the tool-paths were made for</source>
        <translation>选择制作工具路径时所针对的工艺</translation>
    </message>
    <message>
        <source>gravity of an arm that is not upright</source>
        <translation>非直立机械臂的重力</translation>
    </message>
    <message>
        <source>has a document type, which is not accepted</source>
        <translation>含有文档类型声明，不予接受</translation>
    </message>
    <message>
        <source>contains neither an object nor beads with width and height</source>
        <translation>既不含对象，也不含带宽度和高度的挤出线</translation>
    </message>
    <message>
        <source>contains no tool-paths</source>
        <translation>不含工具路径</translation>
    </message>
    <message>
        <source>exceeds the limit of a joint of the robot</source>
        <translation>超出机器人某关节的极限</translation>
    </message>
    <message>
        <source>is not a layer of tool-paths</source>
        <translation>不是工具路径的层</translation>
    </message>
    <message>
        <source>leave scale and units as they are, or give `givenToolPaths=false`</source>
        <translation>保持比例和单位不变，或指定 `givenToolPaths=false`</translation>
    </message>
    <message>
        <source>line {line} is ambiguous: the program has {count} files</source>
        <translation>第 {line} 行不明确：程序有 {count} 个文件</translation>
    </message>
    <message>
        <source>mixed line ends: they differ from here on</source>
        <translation>换行符混用：从此处起不同</translation>
    </message>
    <message>
        <source>too much for a zip file</source>
        <translation>对 zip 文件来说过大</translation>
    </message>
    <message>
        <source>more tool-path points than can be planned</source>
        <translation>工具路径点过多，无法规划</translation>
    </message>
    <message>
        <source>motions per file</source>
        <translation>每个文件的运动数</translation>
    </message>
    <message>
        <source>near singular poses the arm would deviate from the planned orientation</source>
        <translation>在奇异位姿附近，机械臂会偏离规划的姿态</translation>
    </message>
    <message>
        <source>no motion at or after line {line}</source>
        <translation>第 {line} 行及之后没有运动</translation>
    </message>
    <message>
        <source>no object in the file: the part is made from its beads</source>
        <translation>文件中没有对象：零件由其挤出线构成</translation>
    </message>
    <message>
        <source>not a program of this job</source>
        <translation>不是此作业的程序</translation>
    </message>
    <message>
        <source>not the definition of a function without arguments</source>
        <translation>不是无参数函数的定义</translation>
    </message>
    <message>
        <source>nothing is printed after that place</source>
        <translation>该位置之后没有打印内容</translation>
    </message>
    <message>
        <source>the first of {count} sets of tool-paths was taken</source>
        <translation>取用了 {count} 组工具路径中的第一组</translation>
    </message>
    <message>
        <source>flow changes are only supported at the start of a motion</source>
        <translation>仅支持在运动开始时改变流量</translation>
    </message>
    <message>
        <source>use the program for the cell&apos;s own controller</source>
        <translation>使用工作单元自身控制器的程序</translation>
    </message>
    <message>
        <source>stated payload {mass:.2f} kg, planned about {planned:.2f} kg</source>
        <translation>声明的负载为 {mass:.2f} kg，规划约 {planned:.2f} kg</translation>
    </message>
    <message>
        <source>the beads are too thin to be filled with cells</source>
        <translation>挤出线太细，无法用单元格填充</translation>
    </message>
    <message>
        <source>the beads extend too far to be filled with cells</source>
        <translation>挤出线延伸过远，无法用单元格填充</translation>
    </message>
    <message>
        <source>the build&apos;s tool-paths {id} are missing</source>
        <translation>缺少构建的工具路径 {id}</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is given twice</source>
        <translation>系数“{factor}”给出两次</translation>
    </message>
    <message>
        <source>the factor &apos;{factor}&apos; is not within 0 and 1</source>
        <translation>系数“{factor}”不在 0 和 1 之间</translation>
    </message>
    <message>
        <source>the file begins with a byte-order mark: save it as plain text</source>
        <translation>文件以字节顺序标记开头：请另存为纯文本</translation>
    </message>
    <message numerus="yes">
        <source>the file gives no width, height or speed for {points} points of its tool-paths: taken from process {process}</source>
        <translation>
            <numerusform>文件未给出其工具路径中 {points} 个点的宽度、高度或速度：取自工艺 {process}</numerusform>
        </translation>
    </message>
    <message>
        <source>the first motion is too fast: it begins at an unknown pose of the arm</source>
        <translation>第一个运动太快：它从机械臂的未知位姿开始</translation>
    </message>
    <message>
        <source>the frames of tool-paths point into the part; they were reversed</source>
        <translation>工具路径的坐标系指向零件内部；已将其反向</translation>
    </message>
    <message>
        <source>the function &apos;{defined}&apos; is defined twice</source>
        <translation>函数“{defined}”定义了两次</translation>
    </message>
    <message>
        <source>the job has no program to take the line from</source>
        <translation>作业没有该行所属的程序</translation>
    </message>
    <message>
        <source>the job has no motion to resume</source>
        <translation>作业没有可继续的运动</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; is not related to the model</source>
        <translation>层“{path}”与模型无关联</translation>
    </message>
    <message>
        <source>duplicate layer &apos;{path}&apos;</source>
        <translation>层“{path}”重复</translation>
    </message>
    <message>
        <source>computing the part printed so far</source>
        <translation>计算目前已打印的零件</translation>
    </message>
    <message>
        <source>the part {id} of a segment is not in its layer</source>
        <translation>段的部件 {id} 不在其层中</translation>
    </message>
    <message>
        <source>the profile &apos;{uuid}&apos; is not in the model</source>
        <translation>配置“{uuid}”不在模型中</translation>
    </message>
    <message>
        <source>duplicate profile &apos;{uuid}&apos;</source>
        <translation>配置“{uuid}”重复</translation>
    </message>
    <message>
        <source>the profile {id} of a segment is not in its layer</source>
        <translation>段的配置 {id} 不在其层中</translation>
    </message>
    <message>
        <source>the robot must hold either the tool or the work object</source>
        <translation>机器人必须夹持工具或工件坐标对象之一</translation>
    </message>
    <message>
        <source>a modifier&apos;s support points do not increase between 0 and 1</source>
        <translation>修饰符的支承点在 0 到 1 之间未递增</translation>
    </message>
    <message>
        <source>the tool-paths of the part&apos;s file are damaged</source>
        <translation>零件文件的工具路径已损坏</translation>
    </message>
    <message>
        <source>unknown unit &apos;{unit}&apos;</source>
        <translation>未知单位“{unit}”</translation>
    </message>
    <message>
        <source>the {format} program, for another controller, is not released: {failed}</source>
        <translation>用于另一控制器的 {format} 程序不予放行：{failed}</translation>
    </message>
    <message>
        <source>no bead {bead}: the plan has {beads} beads</source>
        <translation>没有挤出线 {bead}：规划有 {beads} 条挤出线</translation>
    </message>
    <message>
        <source>commanded acceleration is {times:.1f} times the planned one</source>
        <translation>指令加速度是规划值的 {times:.1f} 倍</translation>
    </message>
    <message>
        <source>the tool-paths of a file cannot be scaled</source>
        <translation>文件的工具路径不能缩放</translation>
    </message>
    <message>
        <source>tool-paths of the file</source>
        <translation>文件的工具路径</translation>
    </message>
    <message>
        <source>two modifiers of &apos;{attribute}&apos; or with the same factor</source>
        <translation>“{attribute}”有两个修饰符，或系数相同</translation>
    </message>
    <message>
        <source>unpacks to an implausible size</source>
        <translation>解压后的大小不合理</translation>
    </message>
    <message>
        <source>unparsed text in a layer&apos;s data</source>
        <translation>层数据中有无法解析的文本</translation>
    </message>
    <message>
        <source>unparsed text in a tool-path&apos;s data</source>
        <translation>工具路径数据中有无法解析的文本</translation>
    </message>
    <message>
        <source>waits before and after tool-paths are left out</source>
        <translation>工具路径前后的等待被省略</translation>
    </message>
    <message>
        <source>write a build file</source>
        <translation>写出构建文件</translation>
    </message>
    <message>
        <source>write verification reports</source>
        <translation>写出验证报告</translation>
    </message>
    <message>
        <source>write the program again, with times instead of speeds where the format supports them</source>
        <translation>重新写出程序，在格式支持时用时间代替速度</translation>
    </message>
    <message>
        <source>{celsius} °C is outside the printing range of {material}</source>
        <translation>{celsius} °C 超出 {material} 的打印温度范围</translation>
    </message>
    <message>
        <source>{length:.0f} of filament retracted: out of the hot end</source>
        <translation>回抽了 {length:.0f} 耗材：已退出热端</translation>
    </message>
    <message>
        <source>{part}: verification report of the {format} program</source>
        <translation>{part}：{format} 程序的验证报告</translation>
    </message>
    <message>
        <source>{place}: no collision-free transfer from home to the place where the print resumes</source>
        <translation>{place}：从原位到打印继续处没有无碰撞的转移路线</translation>
    </message>
    <message numerus="yes">
        <source>{points} points of the file&apos;s tool-paths need more flow than the extruder&apos;s limit of {limit}: printed slower</source>
        <translation>
            <numerusform>文件工具路径的 {points} 个点所需流量超过挤出机极限 {limit}：放慢打印</numerusform>
        </translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded before the first bead instead of {planned:.3f}</source>
        <translation>第一条挤出线之前挤出 {volume:.3f}，应为 {planned:.3f}</translation>
    </message>
    <message>
        <source>{volume:.3f} is extruded here while the nozzle does not move for {time:.3f}</source>
        <translation>喷嘴静止 {time:.3f} 期间在此挤出 {volume:.3f}</translation>
    </message>
    <message>
        <source>$APO.CDIS is not set before this motion</source>
        <translation>此运动之前未设置 $APO.CDIS</translation>
    </message>
    <message>
        <source>$IPO_MODE must be #BASE or #TCP</source>
        <translation>$IPO_MODE 必须为 #BASE 或 #TCP</translation>
    </message>
    <message>
        <source>$VEL.CP is not set before this motion</source>
        <translation>此运动之前未设置 $VEL.CP</translation>
    </message>
    <message>
        <source>&apos;ChangeTCP&apos; between PVTEnter and PVTExit</source>
        <translation>PVTEnter 与 PVTExit 之间有 &apos;ChangeTCP&apos;</translation>
    </message>
    <message>
        <source>&apos;Cnt&apos; is 0, or 1 with two distances</source>
        <translation>&apos;Cnt&apos; 为 0，或为 1 并带两个距离</translation>
    </message>
    <message>
        <source>&apos;Dly&apos; without a time in seconds</source>
        <translation>&apos;Dly&apos; 缺少以秒为单位的时间</translation>
    </message>
    <message>
        <source>&apos;EMvs&apos; without work coordinates 1 to 8</source>
        <translation>&apos;EMvs&apos; 没有工作坐标 1 至 8</translation>
    </message>
    <message>
        <source>&apos;Mvs&apos; and &apos;EMvs&apos; in one program: only one of them can move the nozzle</source>
        <translation>一个程序中同时有 &apos;Mvs&apos; 和 &apos;EMvs&apos;：只有其中之一能移动喷嘴</translation>
    </message>
    <message>
        <source>&apos;PTP&apos; in millimetres per second</source>
        <translation>&apos;PTP&apos; 以毫米每秒为单位</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; needs 0 (joints) or 1 (poses)</source>
        <translation>&apos;PVTEnter&apos; 需要 0（关节）或 1（位姿）</translation>
    </message>
    <message>
        <source>&apos;PVTEnter&apos; without PVTExit before it</source>
        <translation>&apos;PVTEnter&apos; 之前没有 PVTExit</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; is missing before the end</source>
        <translation>末尾之前缺少 &apos;PVTExit&apos;</translation>
    </message>
    <message>
        <source>&apos;PVTExit&apos; without PVTEnter before it</source>
        <translation>&apos;PVTExit&apos; 之前没有 PVTEnter</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; needs six positions, six velocities and a time in seconds</source>
        <translation>&apos;PVTPoint&apos; 需要六个位置、六个速度和以秒为单位的时间</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; with an invalid time or velocity</source>
        <translation>&apos;PVTPoint&apos; 的时间或速度无效</translation>
    </message>
    <message>
        <source>&apos;PVTPoint&apos; without PVTEnter before it</source>
        <translation>&apos;PVTPoint&apos; 之前没有 PVTEnter</translation>
    </message>
    <message>
        <source>&apos;Wth&apos; without an output</source>
        <translation>&apos;Wth&apos; 没有输出</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; without a sensible value</source>
        <translation>“{name}”没有合理的值</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is a frame that only the controller knows</source>
        <translation>“{word}”是只有控制器知道的坐标系</translation>
    </message>
    <message>
        <source>Motions shorter than {time} ms are stretched to that time and their flow is reduced to match.</source>
        <translation>短于 {time} ms 的运动延长到该时间，其流量相应减小。</translation>
    </message>
    <message>
        <source>Corners are passed without a stop, as if rounded by an arc with a deviation of {distance:.3g}.</source>
        <translation>不停顿地通过拐角，如同以偏差 {distance:.3g} 的圆弧倒圆。</translation>
    </message>
    <message>
        <source>E1 is missing: an external axis moves the base</source>
        <translation>缺少 E1：有外部轴移动基座</translation>
    </message>
    <message>
        <source>ENDDAT is missing: the file was cut short</source>
        <translation>缺少 ENDDAT：文件被截断</translation>
    </message>
    <message>
        <source>G-code with B and C (a table that tilts and turns)</source>
        <translation>带 B 和 C 的 G-code（可倾斜和旋转的工作台）</translation>
    </message>
    <message>
        <source>G-code with B and C: X distance of the plate&apos;s centre from the tilt axis.</source>
        <translation>带 B 和 C 的 G-code：打印板中心到倾斜轴的 X 距离。</translation>
    </message>
    <message>
        <source>G-code with B and C: height of the plate&apos;s top above the tilt axis.</source>
        <translation>带 B 和 C 的 G-code：打印板顶面高出倾斜轴的高度。</translation>
    </message>
    <message>
        <source>G-code with B and C: whether B and C are the right-handed rotation of the part, or that of the tool around a fixed part.</source>
        <translation>带 B 和 C 的 G-code：B 和 C 是零件的右手旋转，还是工具绕固定零件的旋转。</translation>
    </message>
    <message>
        <source>Joint speeds are in percent: 100 % is assumed to be 180 degrees/s, so the times of these travels are estimates.</source>
        <translation>关节速度以百分比表示：假定 100 % 为 180 度/s，因此这些空移的时间为估计值。</translation>
    </message>
    <message>
        <source>Joints accelerate at {acceleration:.0f}/s2 unless the program states otherwise.</source>
        <translation>除非程序另有说明，关节以 {acceleration:.0f}/s2 加速。</translation>
    </message>
    <message>
        <source>KRL (KUKA)</source>
        <translation>KRL (KUKA)</translation>
    </message>
    <message>
        <source>KRL memory</source>
        <translation>KRL 存储器</translation>
    </message>
    <message>
        <source>MELFA-BASIC V (Mitsubishi)</source>
        <translation>MELFA-BASIC V (Mitsubishi)</translation>
    </message>
    <message>
        <source>Programmed accelerations are used; where none is given, motion starts instantly.</source>
        <translation>使用程序中的加速度；未给出时运动瞬间启动。</translation>
    </message>
    <message>
        <source>No motion is shorter than the controller&apos;s cycle of {cycle} ms.</source>
        <translation>没有短于控制器周期 {cycle} ms 的运动。</translation>
    </message>
    <message>
        <source>Not tested on a machine: start slowly, with a cold extruder.</source>
        <translation>未在机器上测试：以冷挤出机低速开始。</translation>
    </message>
    <message>
        <source>Plain G-code (three axes, flat jobs)</source>
        <translation>普通 G-code（三轴，平面层作业）</translation>
    </message>
    <message>
        <source>Points of a bead closer than {time} ms or {way} are merged if the bead stays the same.</source>
        <translation>如果挤出线保持不变，间距小于 {time} ms 或 {way} 的点会合并。</translation>
    </message>
    <message>
        <source>Power Low limits the speed: Power High is missing</source>
        <translation>Power Low 限制速度：缺少 Power High</translation>
    </message>
    <message>
        <source>ROT, but the tool does not turn</source>
        <translation>有 ROT，但工具不旋转</translation>
    </message>
    <message>
        <source>Program memory of the controller. Longer programs contain a note in their header.</source>
        <translation>控制器的程序存储器。较长的程序会在程序头中注明。</translation>
    </message>
    <message>
        <source>SPEL+ (Epson)</source>
        <translation>SPEL+ (Epson)</translation>
    </message>
    <message>
        <source>ScriptExit() is missing at the end</source>
        <translation>末尾缺少 ScriptExit()</translation>
    </message>
    <message>
        <source>Straight motions accelerate at {acceleration} mm/s2 unless the program states otherwise.</source>
        <translation>除非程序另有说明，直线运动以 {acceleration} mm/s2 加速。</translation>
    </message>
    <message>
        <source>TMscript (Techman)</source>
        <translation>TMscript (Techman)</translation>
    </message>
    <message>
        <source>The arm stops at points without a blend.</source>
        <translation>机械臂在没有过渡的点停止。</translation>
    </message>
    <message>
        <source>Unlimited look-ahead.</source>
        <translation>前瞻不受限制。</translation>
    </message>
    <message>
        <source>Look-ahead of {motions} motions.</source>
        <translation>前瞻 {motions} 个运动。</translation>
    </message>
    <message>
        <source>Output delays and following error are not modelled.</source>
        <translation>未对输出延迟和跟随误差建模。</translation>
    </message>
    <message>
        <source>Tool rotation may be limited separately (1 rad = {way:.0f} of path); the slower of the two sets the flow.</source>
        <translation>工具旋转可单独受限（1 rad = 路径 {way:.0f}）；两者中较慢者决定流量。</translation>
    </message>
    <message>
        <source>WAIT SEC needs a number of seconds</source>
        <translation>WAIT SEC 需要秒数</translation>
    </message>
    <message>
        <source>Wait needs a number of seconds</source>
        <translation>Wait 需要秒数</translation>
    </message>
    <message>
        <source>a G0 under G93 has no defined time</source>
        <translation>G93 下的 G0 没有确定的时间</translation>
    </message>
    <message>
        <source>unsupported base: positions must be in the robot&apos;s own base</source>
        <translation>不支持的基坐标系：位置必须在机器人自身的基坐标系中</translation>
    </message>
    <message>
        <source>a base known only to the robot: give its numbers</source>
        <translation>只有机器人知道的基坐标系：请给出其数值</translation>
    </message>
    <message>
        <source>a blend is no sensible number</source>
        <translation>过渡值不合理</translation>
    </message>
    <message>
        <source>unsupported call of another program</source>
        <translation>不支持调用其他程序</translation>
    </message>
    <message>
        <source>a coordinate is missing, and the arm&apos;s position is not known</source>
        <translation>缺少一个坐标，且机械臂位置未知</translation>
    </message>
    <message>
        <source>the flow is not an integer from 0 to {most}</source>
        <translation>流量不是 0 至 {most} 的整数</translation>
    </message>
    <message>
        <source>the frame&apos;s length differs from the stated one</source>
        <translation>帧的长度与声明的不同</translation>
    </message>
    <message>
        <source>the frame is not a script for a listen node</source>
        <translation>帧不是监听节点的脚本</translation>
    </message>
    <message>
        <source>wrong checksum: the frame was modified or truncated</source>
        <translation>校验和错误：帧被修改或截断</translation>
    </message>
    <message>
        <source>frame without a length</source>
        <translation>帧没有长度</translation>
    </message>
    <message>
        <source>frame without a name</source>
        <translation>帧没有名称</translation>
    </message>
    <message>
        <source>load without a mass</source>
        <translation>负载没有重量</translation>
    </message>
    <message>
        <source>a mass is no sensible number</source>
        <translation>重量值不合理</translation>
    </message>
    <message>
        <source>another motion between PVTEnter and PVTExit</source>
        <translation>PVTEnter 与 PVTExit 之间有其他运动</translation>
    </message>
    <message>
        <source>a pure rotation needs ROT</source>
        <translation>纯旋转需要 ROT</translation>
    </message>
    <message>
        <source>a motion without F: under G93 each motion needs its own</source>
        <translation>运动没有 F：G93 下每个运动都需要自己的 F</translation>
    </message>
    <message>
        <source>a motion without G93: its F is not a time</source>
        <translation>运动没有 G93：其 F 不是时间</translation>
    </message>
    <message>
        <source>the numbers of the motion do not match its letters</source>
        <translation>运动的数字与其字母不匹配</translation>
    </message>
    <message>
        <source>a pose before ChangeTCP: its TCP is unknown</source>
        <translation>位姿出现在 ChangeTCP 之前：其 TCP 未知</translation>
    </message>
    <message>
        <source>a position before Tool: its TCP is unknown</source>
        <translation>位置出现在 Tool 之前：其 TCP 未知</translation>
    </message>
    <message>
        <source>step longer than 127 characters</source>
        <translation>步骤长于 127 个字符</translation>
    </message>
    <message>
        <source>a straight motion before any Spd</source>
        <translation>直线运动出现在任何 Spd 之前</translation>
    </message>
    <message>
        <source>a straight motion in percent of an unknown speed</source>
        <translation>直线运动的速度是未知速度的百分比</translation>
    </message>
    <message>
        <source>a straight motion to joints</source>
        <translation>以关节为目标的直线运动</translation>
    </message>
    <message>
        <source>the target is not a position within a robot&apos;s reach</source>
        <translation>目标不是机器人可达范围内的位置</translation>
    </message>
    <message>
        <source>a text has {characters} characters; the controller accepts at most {most}</source>
        <translation>文本有 {characters} 个字符；控制器最多接受 {most} 个</translation>
    </message>
    <message>
        <source>a tool is a position</source>
        <translation>工具是位置</translation>
    </message>
    <message>
        <source>a tool known only to the robot: give its numbers</source>
        <translation>只有机器人知道的工具：请给出其数值</translation>
    </message>
    <message>
        <source>a tool, local or control point that only the controller knows</source>
        <translation>只有控制器知道的工具、局部坐标系或控制点</translation>
    </message>
    <message>
        <source>accelerations other than the arm&apos;s own</source>
        <translation>不是机械臂自身的加速度</translation>
    </message>
    <message>
        <source>an acceleration is no sensible number</source>
        <translation>加速度值不合理</translation>
    </message>
    <message>
        <source>an analogue output outside 0 to 10 V</source>
        <translation>模拟输出超出 0 至 10 V</translation>
    </message>
    <message>
        <source>an angle rotates the long way around</source>
        <translation>角度绕远路旋转</translation>
    </message>
    <message>
        <source>an immediate output, not synchronized with the motions</source>
        <translation>立即输出，与运动不同步</translation>
    </message>
    <message>
        <source>an output after CONTINUE runs ahead of the arm</source>
        <translation>CONTINUE 之后的输出先于机械臂执行</translation>
    </message>
    <message>
        <source>an output is 0 or 1</source>
        <translation>输出为 0 或 1</translation>
    </message>
    <message>
        <source>an output of the extruder is set together with other outputs</source>
        <translation>挤出机的输出与其他输出一起设置</translation>
    </message>
    <message>
        <source>axes cannot be the target of a straight motion</source>
        <translation>轴值不能作为直线运动的目标</translation>
    </message>
    <message>
        <source>format {format} cannot tilt the nozzle, but this job tilts it by {angle}</source>
        <translation>格式 {format} 不能倾斜喷嘴，但此作业倾斜 {angle}</translation>
    </message>
    <message>
        <source>how &apos;{word}&apos; rounds a corner is not known to the reader</source>
        <translation>读取器不知道“{word}”如何对拐角倒圆</translation>
    </message>
    <message>
        <source>joints of a straight motion may be reached in another posture</source>
        <translation>直线运动的关节可能以另一姿态到达</translation>
    </message>
    <message>
        <source>omit it, or give --format {format}</source>
        <translation>省略它，或指定 --format {format}</translation>
    </message>
    <message>
        <source>lines end with LF only: a listen node needs CR LF</source>
        <translation>行仅以 LF 结尾：监听节点需要 CR LF</translation>
    </message>
    <message>
        <source>material before X, Y and Z are all known</source>
        <translation>在 X、Y、Z 全部已知之前就有材料</translation>
    </message>
    <message>
        <source>material before X, Y, Z, B and C are all known</source>
        <translation>在 X、Y、Z、B、C 全部已知之前就有材料</translation>
    </message>
    <message>
        <source>must be 1 or -1</source>
        <translation>必须为 1 或 -1</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>必须为 true 或 false</translation>
    </message>
    <message>
        <source>no {format} motion found: line {line}: {what}</source>
        <translation>未找到 {format} 运动：第 {line} 行：{what}</translation>
    </message>
    <message>
        <source>no procedure is defined</source>
        <translation>未定义过程</translation>
    </message>
    <message>
        <source>no program calls this file</source>
        <translation>没有程序调用此文件</translation>
    </message>
    <message>
        <source>not all axes are given</source>
        <translation>未给出所有轴</translation>
    </message>
    <message>
        <source>invalid plate position relative to the tilt axis</source>
        <translation>打印板相对倾斜轴的位置无效</translation>
    </message>
    <message>
        <source>end without a matching beginning</source>
        <translation>结尾没有对应的开头</translation>
    </message>
    <message>
        <source>no procedure of this file is called</source>
        <translation>此文件的过程均未被调用</translation>
    </message>
    <message>
        <source>only triggers at the start of a motion are supported</source>
        <translation>仅支持运动开始时的触发</translation>
    </message>
    <message>
        <source>only the persistent forms of output commands are supported</source>
        <translation>仅支持输出指令的持久形式</translation>
    </message>
    <message>
        <source>the work coordinates change: only one nozzle is supported</source>
        <translation>工作坐标发生变化：仅支持一个喷嘴</translation>
    </message>
    <message>
        <source>part {part}, job {job}, cell {cell} with robot {robot}</source>
        <translation>零件 {part}，作业 {job}，工作单元 {cell}，机器人 {robot}</translation>
    </message>
    <message>
        <source>plate height above the tilt axis</source>
        <translation>打印板高出倾斜轴的高度</translation>
    </message>
    <message>
        <source>plate offset from the tilt axis</source>
        <translation>打印板相对倾斜轴的偏移</translation>
    </message>
    <message>
        <source>speed, acceleration time and blend must be integers</source>
        <translation>速度、加速时间和过渡必须为整数</translation>
    </message>
    <message>
        <source>step numbers must ascend, up to 32767</source>
        <translation>步骤编号必须递增，最大 32767</translation>
    </message>
    <message>
        <source>either the tool&apos;s path or that of the external control point is straight, not both</source>
        <translation>工具路径或外部控制点路径之一为直线，不能两者皆是</translation>
    </message>
    <message>
        <source>table angles describe</source>
        <translation>工作台角度描述</translation>
    </message>
    <message>
        <source>use {formats}, or a mode with flat layers</source>
        <translation>使用 {formats}，或采用平面层的模式</translation>
    </message>
    <message>
        <source>text after a frame</source>
        <translation>帧之后有文本</translation>
    </message>
    <message>
        <source>the velocity at the last PVT point is not 0</source>
        <translation>最后一个 PVT 点的速度不为 0</translation>
    </message>
    <message>
        <source>the line has {characters} characters; the controller accepts at most {most}</source>
        <translation>该行有 {characters} 个字符；控制器最多接受 {most} 个</translation>
    </message>
    <message>
        <source>&apos;Type&apos; other than 0,0: the long way around, or independent rotation of the angles</source>
        <translation>&apos;Type&apos; 不是 0,0：绕远路，或角度独立旋转</translation>
    </message>
    <message>
        <source>X or Y motion before B and C are known</source>
        <translation>在 B 和 C 已知之前就有 X 或 Y 运动</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>the procedure has no end</source>
        <translation>过程没有结尾</translation>
    </message>
    <message>
        <source>the program has no End</source>
        <translation>程序没有 End</translation>
    </message>
    <message>
        <source>the program is for another cell: {program}; this job is {job}</source>
        <translation>程序用于另一个工作单元：{program}；此作业为 {job}</translation>
    </message>
    <message>
        <source>the program is from another job: {program}; this job is {job}</source>
        <translation>程序来自另一个作业：{program}；此作业为 {job}</translation>
    </message>
    <message>
        <source>the called program {name} is missing</source>
        <translation>缺少被调用的程序 {name}</translation>
    </message>
    <message>
        <source>table motion before Z is known: the nozzle may be down</source>
        <translation>在 Z 已知之前工作台运动：喷嘴可能处于低位</translation>
    </message>
    <message>
        <source>the tool (ISO 841)</source>
        <translation>工具 (ISO 841)</translation>
    </message>
    <message>
        <source>the tool does not turn evenly along its way</source>
        <translation>工具沿途转动不均匀</translation>
    </message>
    <message>
        <source>the velocities lead off the path to this point</source>
        <translation>速度偏离通往此点的路径</translation>
    </message>
    <message>
        <source>work coordinates that P_WkCord does not set</source>
        <translation>P_WkCord 未设置的工作坐标</translation>
    </message>
    <message>
        <source>{frame} is not set before this motion</source>
        <translation>此运动之前未设置 {frame}</translation>
    </message>
    <message>
        <source>{option} applies to {having}, but the chosen formats are {formats}</source>
        <translation>{option} 适用于 {having}，但所选格式为 {formats}</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is missing</source>
        <translation>缺少“{attribute}”</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; must be three numbers: &apos;{text}&apos;</source>
        <translation>“{attribute}”必须是三个数字：“{text}”</translation>
    </message>
    <message>
        <source>expand it first: xacro FILE &gt; arm.urdf</source>
        <translation>先将其展开：xacro FILE &gt; arm.urdf</translation>
    </message>
    <message>
        <source>the chain from &apos;{base}&apos; to &apos;{tip}&apos; has {count} turning axes; six are needed</source>
        <translation>从“{base}”到“{tip}”的链有 {count} 个转动轴；需要六个</translation>
    </message>
    <message>
        <source>choose another home pose for the cell; if only the enclosing shapes of two links overlap, list the pair under neverMeet in the robot&apos;s file</source>
        <translation>为工作单元选择另一个原位；如果只是两个连杆的包络形状重叠，在机器人文件的 neverMeet 下列出这一对</translation>
    </message>
    <message>
        <source>has no links</source>
        <translation>没有连杆</translation>
    </message>
    <message>
        <source>has no tip: no joint moves</source>
        <translation>没有末端：没有可动关节</translation>
    </message>
    <message>
        <source>has several tips: {names}</source>
        <translation>有多个末端：{names}</translation>
    </message>
    <message>
        <source>has two bases, &apos;{first}&apos; and &apos;{second}&apos;: no joint leads from one to the other</source>
        <translation>有两个基座“{first}”和“{second}”：没有关节连接二者</translation>
    </message>
    <message>
        <source>is a xacro file</source>
        <translation>是 xacro 文件</translation>
    </message>
    <message>
        <source>is not a URDF: it begins with &lt;{element}&gt;</source>
        <translation>不是 URDF：以 &lt;{element}&gt; 开头</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; mimics &apos;{other}&apos;: mimic joints are not supported</source>
        <translation>关节“{joint}”模仿“{other}”：不支持 mimic 关节</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an axis of zero length</source>
        <translation>关节“{joint}”的轴长度为零</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the lower limit is not below the upper one</source>
        <translation>关节“{joint}”：下限不低于上限</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; has an unknown type: &apos;{type}&apos;</source>
        <translation>关节“{joint}”的类型未知：“{type}”</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; is {type}; only turning joints are supported</source>
        <translation>关节“{joint}”为 {type}；仅支持转动关节</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos; names an unknown link: &apos;{link}&apos;</source>
        <translation>关节“{joint}”指定了未知连杆：“{link}”</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; has two parent joints, &apos;{first}&apos; and &apos;{second}&apos;: loops are not supported</source>
        <translation>连杆“{link}”有两个父关节“{first}”和“{second}”：不支持闭环</translation>
    </message>
    <message>
        <source>link &apos;{link}&apos; is part of a loop: loops are not supported</source>
        <translation>连杆“{link}”是闭环的一部分：不支持闭环</translation>
    </message>
    <message>
        <source>name one: --tip</source>
        <translation>指定一个：--tip</translation>
    </message>
    <message>
        <source>name the first and last link of the chain: --base, --tip</source>
        <translation>指定链的首末连杆：--base, --tip</translation>
    </message>
    <message>
        <source>the base &apos;{base}&apos; is on a moving branch off the chain to &apos;{tip}&apos;</source>
        <translation>基座“{base}”位于通往“{tip}”的链之外的运动分支上</translation>
    </message>
    <message>
        <source>two links are named &apos;{link}&apos;</source>
        <translation>两个连杆都名为“{link}”</translation>
    </message>
    <message>
        <source>{first} collides with {second} in the home pose: no motion is possible</source>
        <translation>在原位时 {first} 与 {second} 碰撞：无法运动</translation>
    </message>
    <message>
        <source>{option}: no link is named &apos;{name}&apos;</source>
        <translation>{option}：没有名为“{name}”的连杆</translation>
    </message>
    <message>
        <source>In a PolyScope file node the function must be called after its end. Text sent to port 30001 or 30002 runs by itself and must not call it.</source>
        <translation>在 PolyScope 文件节点中，必须在函数结尾之后调用该函数。发送到端口 30001 或 30002 的文本自行运行，不得调用它。</translation>
    </message>
    <message>
        <source>a file node</source>
        <translation>文件节点</translation>
    </message>
    <message>
        <source>a port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an extruder command</source>
        <translation>“{text}”不是挤出机指令</translation>
    </message>
    <message>
        <source>Like an ordinary printer, with the nozzle upright</source>
        <translation>像普通打印机一样，喷嘴竖直</translation>
    </message>
    <message>
        <source>Filament retracted for each travel, if the extruder can; 0: none.</source>
        <translation>每次空移回抽的耗材长度（若挤出机支持）；0：不回抽。</translation>
    </message>
    <message>
        <source>Fills the nozzle before the part begins: on the plate, or in the air beside it if there is no room. The material is waste.</source>
        <translation>在零件开始前充满喷嘴：在打印板上，若没有空间则在旁边空中。这部分材料为废料。</translation>
    </message>
    <message>
        <source>Length of the line beside the part.</source>
        <translation>零件旁线条的长度。</translation>
    </message>
    <message>
        <source>Print in flat layers</source>
        <translation>以平面层打印</translation>
    </message>
    <message>
        <source>the filament diameter is out of range</source>
        <translation>耗材直径超出范围</translation>
    </message>
    <message>
        <source>a line beside the part</source>
        <translation>零件旁的一条线</translation>
    </message>
    <message>
        <source>a motion is missing or repeated in the filament stream</source>
        <translation>耗材流中缺少或重复了某个运动</translation>
    </message>
    <message>
        <source>a ring around the part</source>
        <translation>零件周围的一圈</translation>
    </message>
    <message>
        <source>a text to be sent is needed</source>
        <translation>需要要发送的文本</translation>
    </message>
    <message>
        <source>an external axis after an unused one is not supported</source>
        <translation>不支持未使用的轴之后的外部轴</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>挤出机</translation>
    </message>
    <message>
        <source>retraction</source>
        <translation>回抽</translation>
    </message>
    <message>
        <source>the filament position decreases</source>
        <translation>耗材位置减小</translation>
    </message>
    <message>
        <source>format {format} cannot control extruder {extruder} in step with the motion</source>
        <translation>格式 {format} 无法与运动同步控制挤出机 {extruder}</translation>
    </message>
    <message>
        <source>has a name that is already used: &apos;{name}&apos;</source>
        <translation>名称已被使用：“{name}”</translation>
    </message>
    <message>
        <source>must have minMm below maxMm</source>
        <translation>minMm 必须小于 maxMm</translation>
    </message>
    <message>
        <source>first-layer bead width</source>
        <translation>第一层挤出线宽</translation>
    </message>
    <message>
        <source>Nominal bead width of the first layer and the brim; limited by the process. 0: that of the process.</source>
        <translation>第一层和帽檐的名义挤出线宽；受工艺限制。0：工艺的值。</translation>
    </message>
    <message>
        <source>outer-wall speed</source>
        <translation>外壁速度</translation>
    </message>
    <message>
        <source>Speed of the outermost walls. 0: that of the process.</source>
        <translation>最外层壁的速度。0：工艺的值。</translation>
    </message>
    <message>
        <source>inner-wall speed</source>
        <translation>内壁速度</translation>
    </message>
    <message>
        <source>Speed of all other walls. 0: that of the process.</source>
        <translation>其他所有壁的速度。0：工艺的值。</translation>
    </message>
    <message>
        <source>infill speed</source>
        <translation>填充速度</translation>
    </message>
    <message>
        <source>Speed of solid infill and gap fill, limited by the extruder&apos;s flow. 0: that of the process.</source>
        <translation>实心填充和间隙填充的速度，受挤出机流量限制。0：工艺的值。</translation>
    </message>
    <message>
        <source>support speed</source>
        <translation>支撑速度</translation>
    </message>
    <message>
        <source>Speed of supports. 0: that of the process.</source>
        <translation>支撑的速度。0：工艺的值。</translation>
    </message>
    <message>
        <source>first-layer speed</source>
        <translation>第一层速度</translation>
    </message>
    <message>
        <source>Speed of all beads of the first layer and of the brim. 0: that of the process.</source>
        <translation>第一层和帽檐所有挤出线的速度。0：工艺的值。</translation>
    </message>
    <message>
        <source>brim width</source>
        <translation>帽檐宽度</translation>
    </message>
    <message>
        <source>Width of the loops on the plate around the first layer, which keep it from lifting; break them off after printing. 0: no brim.</source>
        <translation>打印板上第一层周围各圈的宽度，防止翘起；打印后掰除。0：无帽檐。</translation>
    </message>
    <message>
        <source>no room on the plate for the whole brim, {width} wide: {share:.0f} of its length is left out</source>
        <translation>打印板容不下宽 {width} 的完整帽檐：省略了其长度的 {share:.0f}</translation>
    </message>
    <message>
        <source>use a larger plate (`--platform`), move the part to the middle, or set a smaller `brimWidthMm`</source>
        <translation>使用更大的打印板（`--platform`），将零件移到中间，或设置更小的 `brimWidthMm`</translation>
    </message>
    <message>
        <source>must be between {least} and {most}</source>
        <translation>必须在 {least} 和 {most} 之间</translation>
    </message>
    <message>
        <source>where the travel is shortest</source>
        <translation>空移最短处</translation>
    </message>
    <message>
        <source>aligned from layer to layer</source>
        <translation>逐层对齐</translation>
    </message>
    <message>
        <source>in a corner</source>
        <translation>在拐角处</translation>
    </message>
    <message>
        <source>spread over the part</source>
        <translation>分散在零件上</translation>
    </message>
    <message>
        <source>unknown seam &apos;{id}&apos;</source>
        <translation>未知接缝“{id}”</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Where closed walls begin and end. A seam aligned or in a corner is less visible; spread seams weaken the part least.</source>
        <translation>闭合壁的起止位置。对齐或位于拐角的接缝不太显眼；分散的接缝对零件强度削弱最小。</translation>
    </message>
    <message>
        <source>shortest travel</source>
        <translation>最短空移</translation>
    </message>
    <message>
        <source>as sliced</source>
        <translation>按切片顺序</translation>
    </message>
    <message>
        <source>order of islands</source>
        <translation>岛屿顺序</translation>
    </message>
    <message>
        <source>Order in which separate islands of a flat layer are printed.</source>
        <translation>平面层中分离岛屿的打印顺序。</translation>
    </message>
    <message>
        <source>Prints the part as one continuous bead of rising height on its bottom layers: one wall, without infill, top layers and supports under low overhangs.</source>
        <translation>在底层之上将零件打印成一条高度连续上升的挤出线：单壁，无填充、顶层和低悬垂支撑。</translation>
    </message>
    <message>
        <source>spiral vase</source>
        <translation>螺旋花瓶</translation>
    </message>
    <message>
        <source>prime length</source>
        <translation>预挤出长度</translation>
    </message>
    <message>
        <source>must be empty: the plate is on the flange</source>
        <translation>必须为空：打印板在法兰上</translation>
    </message>
    <message>
        <source>too many: robot and external axes together may have {most} axes</source>
        <translation>过多：机器人与外部轴合计最多 {most} 轴</translation>
    </message>
    <message>
        <source>must be turning or sliding, is &apos;{kind}&apos;</source>
        <translation>必须是 turning 或 sliding，现为“{kind}”</translation>
    </message>
    <message>
        <source>must not be zero</source>
        <translation>不得为零</translation>
    </message>
    <message>
        <source>must turn the rod about its own axis, the work frame&apos;s x</source>
        <translation>必须使芯棒绕其自身轴线（工作坐标系的 x）转动</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>预挤出</translation>
    </message>
    <message>
        <source>use extruder {extruders}</source>
        <translation>使用挤出机 {extruders}</translation>
    </message>
    <message>
        <source>the extruder is switched on or off where that is not possible</source>
        <translation>在不可能的位置开启或关闭挤出机</translation>
    </message>
    <message>
        <source>the extruder reverses while the nozzle moves</source>
        <translation>喷嘴移动时挤出机反转</translation>
    </message>
    <message>
        <source>the extruder runs where the program does not pause</source>
        <translation>程序未暂停处挤出机在运行</translation>
    </message>
    <message>
        <source>the extruder runs where the program has switched it off</source>
        <translation>程序已关闭挤出机处挤出机在运行</translation>
    </message>
    <message>
        <source>the retracted filament is not returned before the bead</source>
        <translation>打印挤出线之前未送回回抽的耗材</translation>
    </message>
    <message>
        <source>the file {file} begins with {procedure}: a module must have the name of its first procedure</source>
        <translation>文件 {file} 以 {procedure} 开头：模块必须与其第一个过程同名</translation>
    </message>
    <message>
        <source>the filament stream has no end: the file is truncated</source>
        <translation>耗材流没有结尾：文件被截断</translation>
    </message>
    <message>
        <source>the filament stream has no entry for this motion</source>
        <translation>耗材流中没有此运动的条目</translation>
    </message>
    <message>
        <source>this arm keeps the nozzle upright, but the layers need it tilted, first at {place}</source>
        <translation>此机械臂保持喷嘴竖直，但层需要喷嘴倾斜，首处在 {place}</translation>
    </message>
    <message>
        <source>time decreases in the filament stream</source>
        <translation>耗材流中时间减小</translation>
    </message>
    <message>
        <source>unknown extruder &apos;{id}&apos;</source>
        <translation>未知挤出机“{id}”</translation>
    </message>
    <message>
        <source>use mode flat, or planar with upright layers</source>
        <translation>使用平面层，或层为竖直的平面分块</translation>
    </message>
    <message>
        <source>{joint} at {speed:.1f}/s, above its limit of {limit:.1f#}</source>
        <translation>{joint} 为 {speed:.1f}/s，超过其极限 {limit:.1f#}</translation>
    </message>
    <message>
        <source>Castelli serial</source>
        <translation>Castelli 串行</translation>
    </message>
    <message>
        <source>E stream</source>
        <translation>E 流</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>the cell&apos;s</source>
        <translation>工作单元的</translation>
    </message>
    <message>
        <source>&apos;{attribute}&apos; is NaN or out of range: &apos;{text}&apos;</source>
        <translation>“{attribute}”为 NaN 或超出范围：“{text}”</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is a built-in cell</source>
        <translation>“{id}”是内置工作单元</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is not a valid cell name</source>
        <translation>“{id}”不是有效的工作单元名称</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a number</source>
        <translation>“{word}”不是数字</translation>
    </message>
    <message>
        <source>How rotations about the nozzle are smoothed: quickly, or by a search for minimum joint jerk, which doubles the planning time of the motion.</source>
        <translation>绕喷嘴旋转的平滑方式：快速，或搜索最小关节加加速度，后者使运动规划时间加倍。</translation>
    </message>
    <message>
        <source>Reached poses</source>
        <translation>到达的位姿</translation>
    </message>
    <message>
        <source>a frame needs at least three points</source>
        <translation>坐标系至少需要三个点</translation>
    </message>
    <message>
        <source>a measured number is not finite</source>
        <translation>某个测量值不是有限数</translation>
    </message>
    <message>
        <source>a quaternion&apos;s length is {length:.4g}, not 1</source>
        <translation>四元数的长度为 {length:.4g}，而不是 1</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; is the name of a built-in robot</source>
        <translation>“{id}”是内置机器人的名称</translation>
    </message>
    <message>
        <source>a row contains the robot&apos;s joints</source>
        <translation>每行包含机器人的各关节</translation>
    </message>
    <message>
        <source>a row contains x,y,z,qw,qx,qy,qz; for joints name the robot</source>
        <translation>每行包含 x,y,z,qw,qx,qy,qz；要用关节，请指定机器人</translation>
    </message>
    <message>
        <source>a tool tip needs at least four poses</source>
        <translation>工具尖端至少需要四个位姿</translation>
    </message>
    <message>
        <source>in the home pose {first} collides with {second}</source>
        <translation>在原位时 {first} 与 {second} 碰撞</translation>
    </message>
    <message>
        <source>bring plate and nozzle nearer to the arm</source>
        <translation>使打印板和喷嘴更靠近机械臂</translation>
    </message>
    <message>
        <source>cannot be read: not a mesh, or damaged</source>
        <translation>无法读取：不是网格，或已损坏</translation>
    </message>
    <message>
        <source>cannot be read: voluta-mesh-reader is missing beside this program</source>
        <translation>无法读取：此程序旁缺少 voluta-mesh-reader</translation>
    </message>
    <message>
        <source>cell {cell} has no plate to map</source>
        <translation>工作单元 {cell} 没有可分析的打印板</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>快速平滑</translation>
    </message>
    <message>
        <source>give the arm another name: --id</source>
        <translation>给机械臂另取名称：--id</translation>
    </message>
    <message>
        <source>give three rows x,y,z (origin, point on x, point in the xy plane), or at least three rows of six: nominal point in the frame, touched point</source>
        <translation>给出三行 x,y,z（原点、x 上的点、xy 平面内的点），或至少三行、每行六个数：坐标系中的名义点、触碰点</translation>
    </message>
    <message>
        <source>is damaged: the reader failed</source>
        <translation>已损坏：读取失败</translation>
    </message>
    <message>
        <source>minimum jerk of whole paths</source>
        <translation>整条路径的最小加加速度</translation>
    </message>
    <message>
        <source>jerk of joint {joint} at its greatest here: {jerk:.3g} rad/s³, limit {limit:.3g} rad/s³</source>
        <translation>关节 {joint} 的加加速度在此处最大：{jerk:.3g} rad/s³，极限 {limit:.3g} rad/s³</translation>
    </message>
    <message>
        <source>smooth whole paths (`rotationSmoothing=wholePath`), print slower, or allow more jerk (`maxJerk`)</source>
        <translation>平滑整条路径（`rotationSmoothing=wholePath`），放慢打印，或允许更大的加加速度（`maxJerk`）</translation>
    </message>
    <message>
        <source>maximum jerk</source>
        <translation>最大加加速度</translation>
    </message>
    <message>
        <source>Maximum jerk of every joint; for a sliding joint 100 mm count as 1 rad. The robot moves more slowly where a joint would exceed it, and speeds up and slows down more gently. 0: no limit.</source>
        <translation>每个关节的最大加加速度；移动关节按 100 mm 相当于 1 rad 计算。若关节会超限，机器人就放慢，且加减速更平缓。0：无限制。</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>shapes, and a learned indicator</source>
        <translation>形状和学习得到的指示函数</translation>
    </message>
    <message>
        <source>collision model</source>
        <translation>碰撞模型</translation>
    </message>
    <message>
        <source>How a search for minimum joint jerk of whole paths avoids collisions: by checks of the shapes afterwards, or also by the gradient of an indicator that is learned for each layer (for research; slow). The shapes decide in both cases.</source>
        <translation>搜索整条路径的最小关节加加速度时避免碰撞的方式：事后检查形状，或另外使用为每层学习的指示函数的梯度（用于研究；较慢）。两种情况都由形状决定。</translation>
    </message>
    <message>
        <source>with the nozzle lifted</source>
        <translation>抬起喷嘴</translation>
    </message>
    <message>
        <source>while printing, if possible</source>
        <translation>打印时，如果可能</translation>
    </message>
    <message>
        <source>change of the arm&apos;s branch</source>
        <translation>机械臂构型切换</translation>
    </message>
    <message>
        <source>Where the arm cannot print a whole path in one branch: whether the path is interrupted there, or the wrist changes over several points while printing, with the nozzle tilted within the tilt tolerance.</source>
        <translation>机械臂无法以一种构型打印整条路径时：在该处中断路径，或在打印过程中跨若干点转换手腕，喷嘴在倾斜公差内倾斜。</translation>
    </message>
    <message>
        <source>remove the row, or measure it again</source>
        <translation>移除该行，或重新测量</translation>
    </message>
    <message>
        <source>lengths in a URDF are metres</source>
        <translation>URDF 中的长度以米为单位</translation>
    </message>
    <message>
        <source>check the limits and solids in the description, or name its links: --base, --tip</source>
        <translation>检查描述中的极限和实体，或指定其连杆：--base, --tip</translation>
    </message>
    <message>
        <source>reduce the payload, or use a stronger robot</source>
        <translation>减小负载，或使用更强的机器人</translation>
    </message>
    <message>
        <source>measure another point</source>
        <translation>再测一个点</translation>
    </message>
    <message>
        <source>measure another pose</source>
        <translation>再测一个位姿</translation>
    </message>
    <message>
        <source>measure three points</source>
        <translation>测量三个点</translation>
    </message>
    <message>
        <source>move one of them, or choose another home pose</source>
        <translation>移动其中之一，或选择另一个原位</translation>
    </message>
    <message>
        <source>move one of them, or make the stem or the nozzle longer</source>
        <translation>移动其中之一，或加长立柱或喷嘴</translation>
    </message>
    <message>
        <source>move the nozzle&apos;s frame</source>
        <translation>移动喷嘴的坐标系</translation>
    </message>
    <message>
        <source>no folder for user-defined cells</source>
        <translation>没有用于自定义工作单元的文件夹</translation>
    </message>
    <message>
        <source>not a table of points</source>
        <translation>不是点表</translation>
    </message>
    <message>
        <source>searching a place for the plate</source>
        <translation>搜索打印板的位置</translation>
    </message>
    <message>
        <source>poses {first} and {second} are identical</source>
        <translation>位姿 {first} 和 {second} 相同</translation>
    </message>
    <message>
        <source>set HOME, or VOLUTA_DATA to a folder</source>
        <translation>设置 HOME，或将 VOLUTA_DATA 设为某个文件夹</translation>
    </message>
    <message>
        <source>smoothing of rotations</source>
        <translation>旋转平滑</translation>
    </message>
    <message>
        <source>use a cell with a plate</source>
        <translation>使用带打印板的工作单元</translation>
    </message>
    <message>
        <source>measure a point well off the line through the others</source>
        <translation>测量一个明显偏离其他点连线的点</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>选择另一个名称</translation>
    </message>
    <message>
        <source>takes too long to read</source>
        <translation>读取耗时过长</translation>
    </message>
    <message>
        <source>no place found where the arm reaches above a plate without collision (reach {reach} mm)</source>
        <translation>未找到机械臂可无碰撞到达打印板上方的位置（可达距离 {reach} mm）</translation>
    </message>
    <message>
        <source>implausible reach of the arm: {reach} mm</source>
        <translation>机械臂的可达距离不合理：{reach} mm</translation>
    </message>
    <message>
        <source>the arm&apos;s description</source>
        <translation>机械臂的描述</translation>
    </message>
    <message>
        <source>payload {carried:.3g} kg exceeds the robot&apos;s rating of {most:.3g} kg</source>
        <translation>负载 {carried:.3g} kg 超过机器人的额定值 {most:.3g} kg</translation>
    </message>
    <message>
        <source>must be larger than that of the point before</source>
        <translation>必须大于前一点的值</translation>
    </message>
    <message>
        <source>must not be larger than that of the point before</source>
        <translation>不得大于前一点的值</translation>
    </message>
    <message>
        <source>must have at least one point</source>
        <translation>必须至少有一个点</translation>
    </message>
    <message>
        <source>fixed nozzle</source>
        <translation>固定喷嘴</translation>
    </message>
    <message>
        <source>tilting table</source>
        <translation>倾斜工作台</translation>
    </message>
    <message>
        <source>raised plate</source>
        <translation>抬高的打印板</translation>
    </message>
    <message>
        <source>table on the floor</source>
        <translation>地面工作台</translation>
    </message>
    <message>
        <source>it prints around a rod</source>
        <translation>它绕芯棒打印</translation>
    </message>
    <message>
        <source>its largest plate is too small for the foot, which fits at scale {scale}</source>
        <translation>其最大的打印板对零件底部来说太小，比例 {scale} 时可容纳</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg at {lever:.0f}, the robot carries {most:.3g} kg there</source>
        <translation>其法兰将在 {lever:.0f} 处承载 {kg:.3g} kg，机器人在该处可承载 {most:.3g} kg</translation>
    </message>
    <message>
        <source>its flange would carry {kg:.3g} kg, the robot&apos;s rating is {most:.3g} kg</source>
        <translation>其法兰将承载 {kg:.3g} kg，机器人额定值为 {most:.3g} kg</translation>
    </message>
    <message>
        <source>its nozzle cannot tilt</source>
        <translation>其喷嘴不能倾斜</translation>
    </message>
    <message>
        <source>its head is too bulky to lean</source>
        <translation>其打印头体积太大，无法倾斜</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the part upright</source>
        <translation>其喷嘴竖直时可到达零件的 {share:.0f}</translation>
    </message>
    <message>
        <source>its nozzle reaches {share:.0f} of the poses up to a tilt of {tilt:.0f}</source>
        <translation>倾斜不超过 {tilt:.0f} 时，其喷嘴可到达 {share:.0f} 的位姿</translation>
    </message>
    <message>
        <source>no cell with a fixed nozzle is among them</source>
        <translation>其中没有固定喷嘴的工作单元</translation>
    </message>
    <message>
        <source>{cell} is out: {reason}</source>
        <translation>{cell} 已排除：{reason}</translation>
    </message>
    <message>
        <source>{cell}: its fixed nozzle stays upright, so gravity helps; the platform may be small, and the arm carries plate and part ({kg:.3g} kg)</source>
        <translation>{cell}：固定喷嘴保持竖直，因此重力有利；平台可以较小，机械臂承载打印板和零件（{kg:.3g} kg）</translation>
    </message>
    <message>
        <source>{cell}: its table tilts the part, so gravity helps; {fixed}</source>
        <translation>{cell}：工作台使零件倾斜，因此重力有利；{fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves and takes large parts, and the raised plate stays small for a leaning head, but gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}：喷嘴移动，可容纳大零件，抬高的打印板对倾斜的打印头来说仍较小，但偏离竖直达 {lean:.0f} 时重力不利；{fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, and takes large parts; {fixed}</source>
        <translation>{cell}：喷嘴移动且始终竖直，可容纳大零件；{fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves over a table on the floor and takes large parts, but the platform is not small and gravity does not help at up to {lean:.0f} from vertical; {fixed}</source>
        <translation>{cell}：喷嘴在地面工作台上方移动，可容纳大零件，但平台不小，偏离竖直达 {lean:.0f} 时重力不利；{fixed}</translation>
    </message>
    <message>
        <source>{cell}: its nozzle moves, always upright, over a table on the floor and takes large parts; {fixed}</source>
        <translation>{cell}：喷嘴在地面工作台上方移动且始终竖直，可容纳大零件；{fixed}</translation>
    </message>
    <message>
        <source>none of these cells: {reasons}</source>
        <translation>这些工作单元都不合适：{reasons}</translation>
    </message>
    <message>
        <source>the nozzle is inside {body}</source>
        <translation>喷嘴位于 {body} 内部</translation>
    </message>
    <message>
        <source>the plate is out of the arm&apos;s reach</source>
        <translation>打印板超出机械臂的可达范围</translation>
    </message>
    <message>
        <source>the points are on a line: the frame&apos;s rotation about it is undefined</source>
        <translation>各点共线：坐标系绕该线的旋转不确定</translation>
    </message>
    <message>
        <source>the poses rotate the flange about one axis only, or hardly at all</source>
        <translation>各位姿仅绕一个轴转动法兰，或几乎没有转动</translation>
    </message>
    <message>
        <source>tilt it by at least 30 degrees about two axes</source>
        <translation>绕两个轴各倾斜至少 30 度</translation>
    </message>
    <message>
        <source>rotate the flange between poses</source>
        <translation>在各位姿之间转动法兰</translation>
    </message>
    <message>
        <source>two of the three points are identical</source>
        <translation>三个点中有两个相同</translation>
    </message>
    <message>
        <source>use letters, digits, dashes and dots</source>
        <translation>使用字母、数字、连字符和点</translation>
    </message>
    <message>
        <source>reach of the head</source>
        <translation>打印头的可达范围</translation>
    </message>
    <message>
        <source>wherever the nozzle reaches the plate, {first} collides with {second}</source>
        <translation>凡是喷嘴到达打印板之处，{first} 都与 {second} 碰撞</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted}</source>
        <translation>一行有 {found} 个数字，应为 {wanted} 个</translation>
    </message>
    <message>
        <source>{found} numbers in a row instead of {wanted} as in the first</source>
        <translation>一行有 {found} 个数字，应与第一行一样为 {wanted} 个</translation>
    </message>
    <message>
        <source>CR750 (7.11 ms)</source>
        <translation>CR750 (7.11 ms)</translation>
    </message>
    <message>
        <source>CR800 (3.5 ms)</source>
        <translation>CR800 (3.5 ms)</translation>
    </message>
    <message>
        <source>Events set the analogue output where a motion begins (TriggEquip); by TCP speed, it follows the TCP&apos;s actual speed, so that slow corners get no excess (TriggSpeed).</source>
        <translation>按事件：在运动开始处设置模拟输出 (TriggEquip)；按 TCP 速度：跟随 TCP 的实际速度，使慢速拐角不会过量 (TriggSpeed)。</translation>
    </message>
    <message>
        <source>How far the nozzle may tilt from its planned direction where that makes the joints&apos; motion smoother. Only with minimum jerk of whole paths.</source>
        <translation>为使关节运动更平稳，喷嘴可偏离规划方向倾斜的角度。仅用于整条路径的最小加加速度。</translation>
    </message>
    <message>
        <source>Rotation of the nozzle about its own axis: best for the arm, or by a rule if the nozzle&apos;s attachments have a front. With a rule, fewer points can be reached.</source>
        <translation>喷嘴绕自身轴线的旋转：对机械臂最有利，或在喷嘴附件有正面时按规则。按规则时可达的点较少。</translation>
    </message>
    <message>
        <source>Joint stream (MELFA Mxt, with packets and sender)</source>
        <translation>关节流（MELFA Mxt，含数据包和发送程序）</translation>
    </message>
    <message>
        <source>Joint stream (Universal Robots, with receiver and sender)</source>
        <translation>关节流（Universal Robots，含接收和发送程序）</translation>
    </message>
    <message>
        <source>MELFA stream: one packet is sent per controller cycle.</source>
        <translation>MELFA 流：每个控制器周期发送一个数据包。</translation>
    </message>
    <message>
        <source>RAPID: flow controlled by</source>
        <translation>RAPID：流量控制方式</translation>
    </message>
    <message>
        <source>an invalid flow per speed</source>
        <translation>流量与速度之比无效</translation>
    </message>
    <message>
        <source>a second stream</source>
        <translation>第二个流</translation>
    </message>
    <message>
        <source>a stream has exactly one motion to the start, as its first row</source>
        <translation>流必须恰有一个到起点的运动，作为第一行</translation>
    </message>
    <message>
        <source>a stream of {count} packets is too large for a file</source>
        <translation>{count} 个数据包的流对文件来说过大</translation>
    </message>
    <message>
        <source>along the path</source>
        <translation>沿路径</translation>
    </message>
    <message>
        <source>along the plate</source>
        <translation>沿打印板</translation>
    </message>
    <message>
        <source>best for the arm</source>
        <translation>对机械臂最有利</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>tilt tolerance</source>
        <translation>倾斜公差</translation>
    </message>
    <message>
        <source>events at points</source>
        <translation>各点事件</translation>
    </message>
    <message>
        <source>format {format} states joint values for another maker&apos;s arm, not for the {robot} of cell {cell}</source>
        <translation>格式 {format} 给出的是另一厂家机械臂的关节值，而不是工作单元 {cell} 的 {robot}</translation>
    </message>
    <message>
        <source>smallest rotation from upright</source>
        <translation>相对竖直的最小旋转</translation>
    </message>
    <message>
        <source>not the header of a joint stream</source>
        <translation>不是关节流的文件头</translation>
    </message>
    <message>
        <source>not the program that receives this stream: &apos;{code}&apos;</source>
        <translation>不是接收此流的程序：“{code}”</translation>
    </message>
    <message>
        <source>packet {number} does not match the rows</source>
        <translation>数据包 {number} 与各行不符</translation>
    </message>
    <message>
        <source>use melfa</source>
        <translation>使用 melfa</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP 速度</translation>
    </message>
    <message>
        <source>the arm waits at another target than the previous one</source>
        <translation>机械臂等待的目标与前一个不同</translation>
    </message>
    <message>
        <source>the extruder&apos;s outputs are not off at the end</source>
        <translation>结束时挤出机的输出未关闭</translation>
    </message>
    <message>
        <source>a flow proportional to the speed in a motion of unknown length</source>
        <translation>长度未知的运动中流量与速度成正比</translation>
    </message>
    <message>
        <source>the program that receives the stream is truncated</source>
        <translation>接收流的程序被截断</translation>
    </message>
    <message>
        <source>the row that ends the stream is missing: the file is truncated</source>
        <translation>缺少结束流的行：文件被截断</translation>
    </message>
    <message>
        <source>this is not the program that receives a stream</source>
        <translation>这不是接收流的程序</translation>
    </message>
    <message>
        <source>this line differs from the one Voluta writes; it is the same for every job</source>
        <translation>此行与 Voluta 写出的不同；每个作业的此行都相同</translation>
    </message>
    <message>
        <source>nozzle rotation</source>
        <translation>喷嘴旋转</translation>
    </message>
    <message>
        <source>Maximum filament length that the external axis feeds before it is reset to 0.</source>
        <translation>外部轴归 0 之前送进的最大耗材长度。</translation>
    </message>
    <message>
        <source>How far the nozzle moves back over its bead, or on along a closed one, with the extruder off before it lifts. 0: it lifts at the end of the bead.</source>
        <translation>抬升前挤出机关闭时，喷嘴沿挤出线退回（或沿闭合线继续前进）的距离。0：在挤出线末端抬升。</translation>
    </message>
    <message>
        <source>How the program controls the extruder. Outputs: one for on/off, one for the flow. Castelli serial: texts over a socket. E stream: a file of amounts over time. External axis: mm of filament in each motion.</source>
        <translation>程序控制挤出机的方式。输出：一个用于开/关，一个用于流量。Castelli 串行：通过套接字发送文本。E 流：挤出量随时间变化的文件。外部轴：每个运动中耗材的毫米数。</translation>
    </message>
    <message>
        <source>the whole mesh is a single point</source>
        <translation>整个网格是单个点</translation>
    </message>
    <message>
        <source>at {x:.3f#}, {y:.3f#}, {z:.3f}, rotated by {rx:.3f#}, {ry:.3f#}, {rz:.3f}</source>
        <translation>位于 {x:.3f#}, {y:.3f#}, {z:.3f}，旋转 {rx:.3f#}, {ry:.3f#}, {rz:.3f}</translation>
    </message>
    <message>
        <source>more than {length:.0f} of filament is needed between two lifts: beyond the extruder axis&apos; range</source>
        <translation>两次抬升之间需要超过 {length:.0f} 的耗材：超出挤出机轴的行程</translation>
    </message>
    <message>
        <source>external axes that move alone are only supported for the extruder, with a time</source>
        <translation>单独运动的外部轴仅支持用于挤出机，且须带时间</translation>
    </message>
    <message>
        <source>external axis</source>
        <translation>外部轴</translation>
    </message>
    <message>
        <source>extruder axis: range</source>
        <translation>挤出机轴：行程</translation>
    </message>
    <message>
        <source>no redundant measurements: the error cannot be estimated</source>
        <translation>没有冗余测量：无法估计误差</translation>
    </message>
    <message>
        <source>increase {option}</source>
        <translation>增大 {option}</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is missing</source>
        <translation>缺少挤出机轴</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is not set to 0 before this motion</source>
        <translation>此运动之前挤出机轴未归 0</translation>
    </message>
    <message>
        <source>the extruder&apos;s axis is slowed: the arm would wait for it</source>
        <translation>挤出机轴减速：机械臂将等待它</translation>
    </message>
    <message>
        <source>wipe</source>
        <translation>擦拭</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f}</source>
        <translation>{rows} 行，残差平均 {rms:.3f}、最大 {worst:.3f}：精度 {place:.3f}</translation>
    </message>
    <message>
        <source>{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f} and {turn:.3f}</source>
        <translation>{rows} 行，残差平均 {rms:.3f}、最大 {worst:.3f}：精度 {place:.3f} 和 {turn:.3f}</translation>
    </message>
    <message>
        <source>Extended G-code: also writes a RAPID module that reads the file on an ABB controller and runs arm and extruder.</source>
        <translation>扩展 G-code：另外写出 RAPID 模块，在 ABB 控制器上读取该文件并运行机械臂和挤出机。</translation>
    </message>
    <message>
        <source>Lines by data link (MELFA-BASIC V, with receiver and sender)</source>
        <translation>数据链路程序行（MELFA-BASIC V，含接收和发送程序）</translation>
    </message>
    <message>
        <source>a RAPID module (ABB)</source>
        <translation>RAPID 模块 (ABB)</translation>
    </message>
    <message>
        <source>a module that reads G-code cannot move the {axis} of cell {cell}: G-code does not state its position</source>
        <translation>读取 G-code 的模块无法移动工作单元 {cell} 的 {axis}：G-code 未给出其位置</translation>
    </message>
    <message>
        <source>a position before the tool is defined</source>
        <translation>位置出现在工具定义之前</translation>
    </message>
    <message>
        <source>the full flow is not the process&apos;s</source>
        <translation>满流量不是工艺的值</translation>
    </message>
    <message>
        <source>companion reader for extended G-code</source>
        <translation>扩展 G-code 的配套读取程序</translation>
    </message>
    <message>
        <source>its count (G92 C)</source>
        <translation>其计数 (G92 C)</translation>
    </message>
    <message>
        <source>joint motions with joint targets and with pose targets in one stream</source>
        <translation>一个流中同时有以关节为目标和以位姿为目标的关节运动</translation>
    </message>
    <message>
        <source>not the header of lines for a data link</source>
        <translation>不是数据链路程序行的文件头</translation>
    </message>
    <message>
        <source>unexpected in the program that receives these lines: &apos;{code}&apos;</source>
        <translation>接收这些行的程序中出现意外内容：“{code}”</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>set `tableTurns` to {turns} or more</source>
        <translation>将 `tableTurns` 设为 {turns} 或以上</translation>
    </message>
    <message>
        <source>choose rapid</source>
        <translation>选择 rapid</translation>
    </message>
    <message>
        <source>the arm does not stop before this line</source>
        <translation>机械臂在此行之前未停止</translation>
    </message>
    <message>
        <source>the extruder is on in a joint motion</source>
        <translation>关节运动时挤出机开启</translation>
    </message>
    <message>
        <source>the job&apos;s file, start or full flow is missing or given twice</source>
        <translation>作业的文件、起点或满流量缺失或给出两次</translation>
    </message>
    <message>
        <source>the first line is not a joint motion to the start</source>
        <translation>第一行不是到起点的关节运动</translation>
    </message>
    <message>
        <source>layer &apos;{path}&apos; has no height above the previous one</source>
        <translation>层“{path}”没有高出前一层</translation>
    </message>
    <message>
        <source>the line that ends the stream is missing: the file is truncated</source>
        <translation>缺少结束流的行：文件被截断</translation>
    </message>
    <message>
        <source>the program that receives the lines is truncated</source>
        <translation>接收各行的程序被截断</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>工作台</translation>
    </message>
    <message>
        <source>within a bead the table would turn by more than {turns} turns to one side</source>
        <translation>在一条挤出线内，工作台会向一侧转动超过 {turns} 圈</translation>
    </message>
    <message>
        <source>this is not the module that reads G-code</source>
        <translation>这不是读取 G-code 的模块</translation>
    </message>
    <message>
        <source>tool-paths of type &apos;{type}&apos; without beads; only beads from a nozzle are supported</source>
        <translation>类型“{type}”的工具路径没有挤出线；仅支持喷嘴的挤出线</translation>
    </message>
    <message>
        <source>turns until C is reset</source>
        <translation>C 复位前的圈数</translation>
    </message>
    <message>
        <source>reset of C</source>
        <translation>C 复位</translation>
    </message>
    <message>
        <source>Adds break-away beads under low overhangs; thickens the overhanging bead instead where that is enough.</source>
        <translation>在低悬垂下添加可掰除的挤出线；若足够，则改为加厚悬垂的挤出线。</translation>
    </message>
    <message>
        <source>Lines by EthernetKRL (KUKA, with receiver and sender)</source>
        <translation>EthernetKRL 程序行（KUKA，含接收和发送程序）</translation>
    </message>
    <message>
        <source>an axis that carries the robot is missing</source>
        <translation>缺少承载机器人的轴</translation>
    </message>
    <message numerus="yes">
        <source>support beads ({volume:.3g}) under {paths} beads that would overhang just above the plate or the printed part</source>
        <translation>
            <numerusform>在 {paths} 条会在打印板或已打印零件上方不远处悬垂的挤出线下方添加支撑线（{volume:.3g}）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{paths} unsupported beads are printed after their inner neighbours, with the nozzle tilted by up to {lean:.0f} more</source>
        <translation>
            <numerusform>{paths} 条无支承的挤出线在其内侧相邻线之后打印，喷嘴额外倾斜不超过 {lean:.0f}</numerusform>
        </translation>
    </message>
    <message>
        <source>if you do not want this, turn the part or print it in flat layers with supports</source>
        <translation>如不需要，转动零件或以带支撑的平面层打印</translation>
    </message>
    <message>
        <source>format {format} does not support external axes: it cannot move the {axis} of cell {cell}</source>
        <translation>格式 {format} 不支持外部轴：无法移动工作单元 {cell} 的 {axis}</translation>
    </message>
    <message>
        <source>must be platform after an axis that carries the platform</source>
        <translation>在承载平台的轴之后必须是 platform</translation>
    </message>
    <message>
        <source>must be platform or robot, is &apos;{carries}&apos;</source>
        <translation>必须是 platform 或 robot，现为“{carries}”</translation>
    </message>
    <message>
        <source>either a base or a fixed nozzle has to be defined</source>
        <translation>必须定义基坐标系或固定喷嘴</translation>
    </message>
    <message>
        <source>support low overhangs</source>
        <translation>支撑低悬垂</translation>
    </message>
    <message>
        <source>the program&apos;s nozzle is {distance:.2f} and {angle:.2f} off the cell&apos;s nozzle</source>
        <translation>程序的喷嘴与工作单元的喷嘴相差 {distance:.2f} 和 {angle:.2f}</translation>
    </message>
    <message numerus="yes">
        <source>{waypoints} waypoints ({share:.2g} of the material) are skipped; see the findings above</source>
        <translation>
            <numerusform>跳过了 {waypoints} 个路径点（材料的 {share:.2g}）；参见上面的问题</numerusform>
        </translation>
    </message>
    <message>
        <source>The largest scale that the robot reaches entirely</source>
        <translation>机器人可完全到达的最大比例</translation>
    </message>
    <message>
        <source>print it at scale {scale:.3g}, turn it, or use a larger robot</source>
        <translation>以比例 {scale:.3g} 打印，转动零件，或使用更大的机器人</translation>
    </message>
    <message>
        <source>use flat layers, which need no tilt of the nozzle, turn the part, or use a larger robot</source>
        <translation>使用无需倾斜喷嘴的平面层，转动零件，或使用更大的机器人</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach</source>
        <translation>{share:.2g} 的工具路径点超出机器人可达范围</translation>
    </message>
    <message>
        <source>{share:.2g} of the tool-path points are out of the robot&apos;s reach; at {size:.2g} of this size all would be reachable</source>
        <translation>{share:.2g} 的工具路径点超出机器人可达范围；缩到此尺寸的 {size:.2g} 时全部可达</translation>
    </message>
    <message>
        <source>Let Voluta choose</source>
        <translation>由 Voluta 选择</translation>
    </message>
    <message>
        <source>Tries the ways of building in turn until nothing is unsupported or missed</source>
        <translation>依次尝试各种构建方式，直到没有无支承或遗漏</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; is a reserved word and cannot name a function</source>
        <translation>“{name}”是保留字，不能用作函数名</translation>
    </message>
    <message>
        <source>ambiguous number &apos;{number}&apos;: decimal comma or thousands separator</source>
        <translation>数字“{number}”有歧义：小数逗号还是千位分隔符</translation>
    </message>
    <message>
        <source>20 % smaller</source>
        <translation>缩小 20 %</translation>
    </message>
    <message>
        <source>Adds a verification report to each program, NAME.proof.html and NAME.proof.pdf: the verdict, the checks and the margins to the limits; its figures as NAME.proof.json; and NAME.printed.stl, the part as printed, as a solid.</source>
        <translation>为每个程序添加验证报告 NAME.proof.html 和 NAME.proof.pdf：结论、各项检查和距极限的余量；其数据存为 NAME.proof.json；另有 NAME.printed.stl，即打印后零件的实体。</translation>
    </message>
    <message>
        <source>Allow less clearance</source>
        <translation>允许更小的安全间距</translation>
    </message>
    <message>
        <source>Amount: {share:.1f} of the part&apos;s volume is deposited; {least:.4g#} to {most:.4g} allowed.</source>
        <translation>用量：沉积了零件体积的 {share:.1f}；允许 {least:.4g#} 至 {most:.4g}。</translation>
    </message>
    <message>
        <source>Arm, joints and their limits: not checked, as the program contains nozzle positions but no joint values.</source>
        <translation>机械臂、关节及其极限：未检查，因为程序只含喷嘴位置而没有关节值。</translation>
    </message>
    <message>
        <source>The largest scale that the cell&apos;s plates carry</source>
        <translation>工作单元的打印板能承载的最大比例</translation>
    </message>
    <message>
        <source>The part&apos;s footprint plus 20 mm, on its own stem</source>
        <translation>零件的占地轮廓加 20 mm，置于自身立柱上</translation>
    </message>
    <message>
        <source>Bead section: off by more than 5 % over {share:.2f} of the printed length; at most {limit:.0f} allowed.</source>
        <translation>挤出线截面：打印长度的 {share:.2f} 偏差超过 5 %；最多允许 {limit:.0f}。</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>构建方式</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Chosen: {way} ({values})</source>
        <translation>已选：{way}（{values}）</translation>
    </message>
    <message>
        <source>Close the openings</source>
        <translation>封闭开口</translation>
    </message>
    <message>
        <source>Minimum clearance between arm, plate and part: {way:.1f}.</source>
        <translation>机械臂、打印板与零件之间的最小间距：{way:.1f}。</translation>
    </message>
    <message>
        <source>Collisions of head, plate and part: {collisions}; none allowed.</source>
        <translation>打印头、打印板与零件的碰撞：{collisions}；不允许有碰撞。</translation>
    </message>
    <message>
        <source>Collisions: {collisions}; none allowed.</source>
        <translation>碰撞：{collisions}；不允许有碰撞。</translation>
    </message>
    <message>
        <source>Fill: {share:.1f} of the part is filled; at least {limit:.4g} required.</source>
        <translation>填充：零件已填满 {share:.1f}；至少需要 {limit:.4g}。</translation>
    </message>
    <message>
        <source>Flat patches over the openings: the part becomes solid</source>
        <translation>用平面补片封住开口：零件变为实体</translation>
    </message>
    <message>
        <source>G-code with B and C: beyond this number of turns to one side C is reset by whole turns during a travel. 0: the minimum the beads allow if the table is wound back, one turn if only its count is reset.</source>
        <translation>带 B 和 C 的 G-code：向一侧超过此圈数后，在空移时将 C 按整圈复位。0：若工作台反转回绕，取挤出线允许的最小值；若仅复位计数，取一圈。</translation>
    </message>
    <message>
        <source>G-code with B and C: winds the table back during a travel, with the nozzle raised clear of it. For a table that turns endlessly only the count can be reset, without a motion.</source>
        <translation>带 B 和 C 的 G-code：空移时抬起喷嘴避开工作台，将工作台反转回绕。对可无限旋转的工作台，可只复位计数而不运动。</translation>
    </message>
    <message>
        <source>G94 is missing after the last motion: the next program would read F as times</source>
        <translation>最后一个运动之后缺少 G94：下一个程序会将 F 读作时间</translation>
    </message>
    <message>
        <source>Half the layer height, within the process&apos;s range</source>
        <translation>层高减半，在工艺范围内</translation>
    </message>
    <message>
        <source>50 % larger</source>
        <translation>放大 50 %</translation>
    </message>
    <message>
        <source>Half the distance of the arm from itself and from the part</source>
        <translation>机械臂与自身及零件的间距减半</translation>
    </message>
    <message>
        <source>Partly supported: {share:.1f} of the bead length is supported over less than half its width.</source>
        <translation>部分支承：挤出线长度的 {share:.1f} 支承宽度不足一半。</translation>
    </message>
    <message>
        <source>In a usual cell; Voluta chooses the way of building</source>
        <translation>在常用工作单元中；由 Voluta 选择构建方式</translation>
    </message>
    <message>
        <source>It is for another controller than the cell&apos;s.</source>
        <translation>它用于另一种控制器，而非工作单元的控制器。</translation>
    </message>
    <message>
        <source>It prints the rest of a stopped print.</source>
        <translation>它打印已停止打印的剩余部分。</translation>
    </message>
    <message>
        <source>Joint range: joint {name} has the smallest margin to its limit, {angle:.1f}.</source>
        <translation>关节范围：关节 {name} 距极限的余量最小，为 {angle:.1f}。</translation>
    </message>
    <message>
        <source>Joint speed: joint {name} is closest to its limit, at {share:.0f} of it.</source>
        <translation>关节速度：关节 {name} 最接近极限，达到其 {share:.0f}。</translation>
    </message>
    <message>
        <source>Keep more clearance</source>
        <translation>保持更大的安全间距</translation>
    </message>
    <message>
        <source>Limits of flow and blends: {violations} violations; none allowed.</source>
        <translation>流量和过渡的极限：{violations} 处违规；不允许违规。</translation>
    </message>
    <message>
        <source>Limits of joints, speeds and flow: {violations} violations; none allowed.</source>
        <translation>关节、速度和流量的极限：{violations} 处违规；不允许违规。</translation>
    </message>
    <message>
        <source>Longer programs are split into files to run one after the other. 0: the format&apos;s default (URScript and RAPID 5000, KRL 2500, MELFA 6500, SPEL+ one file).</source>
        <translation>较长的程序拆分为依次运行的文件。0：格式的默认值（URScript 和 RAPID 5000，KRL 2500，MELFA 6500，SPEL+ 一个文件）。</translation>
    </message>
    <message>
        <source>Longest unsupported run: {length:.1f}; this material bridges {bridge:.1f}.</source>
        <translation>最长的无支承段：{length:.1f}；此材料可桥接 {bridge:.1f}。</translation>
    </message>
    <message>
        <source>Make a platform for the part</source>
        <translation>为零件制作平台</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>重量</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>No way of building passes; the best one is shown: {way} ({values})</source>
        <translation>没有构建方式通过；显示最好的一种：{way}（{values}）</translation>
    </message>
    <message>
        <source>The default nozzle, head and material of this way of building</source>
        <translation>此构建方式的默认喷嘴、打印头和材料</translation>
    </message>
    <message>
        <source>G{number} is not understood</source>
        <translation>不支持 G{number}</translation>
    </message>
    <message>
        <source>Height after which the layers turn in the other direction, again and again; 0: never.</source>
        <translation>每隔此高度，层的旋转方向反转一次，反复进行；0：从不。</translation>
    </message>
    <message>
        <source>Material of the file&apos;s tool-paths, in percent of its amounts. For a file that was read with another filament diameter: 100 times the square of their ratio (2.85 mm instead of 1.75 mm: 265).</source>
        <translation>文件工具路径的材料，占其用量的百分比。若文件按另一耗材直径读取：100 乘以两者之比的平方（2.85 mm 代替 1.75 mm：265）。</translation>
    </message>
    <message>
        <source>Moves the file&apos;s tool-paths to x,y,z,a,b,c: mm, and degrees about the fixed axes x, y and z in this order; e.g. onto a side of the platform&apos;s body. Empty: no motion.</source>
        <translation>将文件的工具路径移到 x,y,z,a,b,c：单位 mm，以及依次绕固定轴 x、y、z 的角度；例如移到平台实体的一侧。空：不移动。</translation>
    </message>
    <message>
        <source>On a cylinder or sphere: each layer keeps the lengths of the file, or the angle of the layer below, so that it grows with the radius and its beads with it.</source>
        <translation>在圆柱或球面上：每层保持文件的长度，或保持下层的角度，使其与挤出线随半径增大。</translation>
    </message>
    <message>
        <source>Paths of the file</source>
        <translation>文件的路径</translation>
    </message>
    <message>
        <source>Radius of that cylinder or sphere; negative: its inside.</source>
        <translation>该圆柱或球面的半径；负值：其内侧。</translation>
    </message>
    <message>
        <source>Turns each layer of the file&apos;s tool-paths about z against the one below; positive: counterclockwise.</source>
        <translation>使文件工具路径的每一层绕 z 相对下层旋转；正值：逆时针。</translation>
    </message>
    <message>
        <source>Where the file&apos;s tool-paths are printed: on the plate; on a block with a plane top, which is turned together with them; or bent onto a cylinder along x or a sphere. The block is made for the part, unless the platform is a body.</source>
        <translation>文件工具路径的打印位置：打印板上；平顶块上，块与路径一起转动；或弯到沿 x 的圆柱或球面上。除非平台是实体，否则会为零件制作该块。</translation>
    </message>
    <message>
        <source>a bead from an unknown position</source>
        <translation>挤出线的起始位置未知</translation>
    </message>
    <message>
        <source>a direction of length 0</source>
        <translation>方向的长度为 0</translation>
    </message>
    <message>
        <source>a length of filament of more than a kilometre</source>
        <translation>耗材长度超过一公里</translation>
    </message>
    <message>
        <source>a motion with a word A, U, V or W is not understood</source>
        <translation>不支持带字 A、U、V 或 W 的运动</translation>
    </message>
    <message>
        <source>a position more than a kilometre away</source>
        <translation>位置在一公里以外</translation>
    </message>
    <message>
        <source>a position without G0 or G1</source>
        <translation>位置没有 G0 或 G1</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>用量</translation>
    </message>
    <message>
        <source>an arc that does not pass through its ends</source>
        <translation>圆弧未通过其端点</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>bent layers keep</source>
        <translation>弯曲层保持</translation>
    </message>
    <message>
        <source>contains no beads of a part</source>
        <translation>不含零件的挤出线</translation>
    </message>
    <message>
        <source>contains no beads: no motion extrudes</source>
        <translation>不含挤出线：没有挤出的运动</translation>
    </message>
    <message>
        <source>export G-code as text from the slicer</source>
        <translation>从切片软件以文本形式导出 G-code</translation>
    </message>
    <message>
        <source>export straight lines, or arcs in the plane of X and Y (G2, G3)</source>
        <translation>导出直线，或 X 和 Y 平面内的圆弧 (G2, G3)</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E)</source>
        <translation>导出带挤出 (E) 的 G-code</translation>
    </message>
    <message>
        <source>export the G-code with extrusion (E) from a slicer</source>
        <translation>从切片软件导出带挤出 (E) 的 G-code</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>give F in mm per minute</source>
        <translation>以 mm/分钟给出 F</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`</source>
        <translation>给出更大的 `pathsRadiusMm`</translation>
    </message>
    <message>
        <source>give a larger `pathsRadiusMm`, or turn the part by 90 degrees</source>
        <translation>给出更大的 `pathsRadiusMm`，或将零件转动 90 度</translation>
    </message>
    <message>
        <source>give at least 1 mm, or at most -1 mm for the inside</source>
        <translation>给出至少 1 mm，内侧则至多 -1 mm</translation>
    </message>
    <message>
        <source>give its centre (I, J) or its radius (R)</source>
        <translation>给出其圆心 (I, J) 或半径 (R)</translation>
    </message>
    <message>
        <source>give nX nY nZ as a unit vector</source>
        <translation>以单位向量给出 nX nY nZ</translation>
    </message>
    <message>
        <source>give the nozzle&apos;s direction as nX nY nZ, or the table&apos;s angles as B and C</source>
        <translation>以 nX nY nZ 给出喷嘴方向，或以 B 和 C 给出工作台角度</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>基面</translation>
    </message>
    <message>
        <source>home the axes (G28) or travel to its start first</source>
        <translation>先使各轴回零 (G28) 或空移到其起点</translation>
    </message>
    <message>
        <source>is binary G-code</source>
        <translation>是二进制 G-code</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>`pathsFrame` &apos;{text}&apos; is not a frame</source>
        <translation>`pathsFrame` “{text}”不是坐标系</translation>
    </message>
    <message>
        <source>`pathsRadiusMm={radius}` is no radius of a ground</source>
        <translation>`pathsRadiusMm={radius}` 不是基面的半径</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平顶块</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>打印板</translation>
    </message>
    <message>
        <source>slice with comments, or with layers of one height</source>
        <translation>切片时带注释，或使用单一层高</translation>
    </message>
    <message>
        <source>the file may be damaged; export it again</source>
        <translation>文件可能已损坏；请重新导出</translation>
    </message>
    <message>
        <source>the file states no filament diameter: {diameter} assumed; for another one set `pathsFlow`</source>
        <translation>文件未说明耗材直径：假定为 {diameter}；若为其他值，设置 `pathsFlow`</translation>
    </message>
    <message>
        <source>a bead at X{x:.1f} Y{y:.1f} Z{z:.1f} is {width:.0f} wide</source>
        <translation>X{x:.1f} Y{y:.1f} Z{z:.1f} 处的挤出线宽 {width:.0f}</translation>
    </message>
    <message>
        <source>correct the amount (E) of that line, or the filament&apos;s diameter</source>
        <translation>更正该行的用量 (E)，或耗材直径</translation>
    </message>
    <message>
        <source>the height of the beads is not known</source>
        <translation>挤出线的高度未知</translation>
    </message>
    <message>
        <source>the part is {height:.1f} high, too high for the inside of a radius of {radius:.1f}</source>
        <translation>零件高 {height:.1f}，对半径 {radius:.1f} 的内侧来说太高</translation>
    </message>
    <message>
        <source>the part reaches {angle:.0f} round the ground, more than 90</source>
        <translation>零件绕基面延伸 {angle:.0f}，超过 90</translation>
    </message>
    <message>
        <source>turn back after</source>
        <translation>反转间隔</translation>
    </message>
    <message>
        <source>turn per layer</source>
        <translation>每层旋转</translation>
    </message>
    <message>
        <source>write the command in each line</source>
        <translation>在每行写出指令</translation>
    </message>
    <message>
        <source>write x,y,z,a,b,c in mm and degrees</source>
        <translation>写 x,y,z,a,b,c，单位 mm 和度</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded before the first layer are left out</source>
        <translation>第一层之前挤出的 {volume:.0f} 被省略</translation>
    </message>
    <message>
        <source>Open surfaces</source>
        <translation>开放表面</translation>
    </message>
    <message>
        <source>Overfill: {share:.1f} of the part&apos;s volume lies outside it or in places already full; at most {limit:.4g} allowed.</source>
        <translation>过填充：零件体积的 {share:.1f} 位于零件之外或已填满之处；最多允许 {limit:.4g}。</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Passed: this program prints the part as planned.</source>
        <translation>通过：此程序按规划打印零件。</translation>
    </message>
    <message>
        <source>Path: the nozzle deviates from the planned path by up to {way:.3f}; at most {limit:.2f} allowed.</source>
        <translation>路径：喷嘴偏离规划路径最大 {way:.3f}；最多允许 {limit:.2f}。</translation>
    </message>
    <message>
        <source>Planned
time</source>
        <translation>规划
时间</translation>
    </message>
    <message>
        <source>Positions are in mm in the work frame: origin at the centre of the platform&apos;s top, z pointing out of it. The printed part as a solid: {file}</source>
        <translation>位置以 mm 为单位，在工作坐标系中：原点在平台顶面中心，z 指向外。打印后零件的实体：{file}</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>预挤出</translation>
    </message>
    <message>
        <source>Print it larger</source>
        <translation>打印得更大</translation>
    </message>
    <message>
        <source>Print it smaller</source>
        <translation>打印得更小</translation>
    </message>
    <message>
        <source>Print thinner layers</source>
        <translation>打印更薄的层</translation>
    </message>
    <message>
        <source>Print on a plate</source>
        <translation>在打印板上打印</translation>
    </message>
    <message>
        <source>Print time</source>
        <translation>打印时间</translation>
    </message>
    <message>
        <source>Program files with their SHA-256</source>
        <translation>程序文件及其 SHA-256</translation>
    </message>
    <message>
        <source>Refused: do not run this program.</source>
        <translation>拒绝：不要运行此程序。</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>The default robot and plate of this way of building</source>
        <translation>此构建方式的默认机器人和打印板</translation>
    </message>
    <message>
        <source>Singularities: isotropy is at least {ratio:.3f} (0 is singular, 1 is isotropic).</source>
        <translation>奇异性：各向同性度至少为 {ratio:.3f}（0 为奇异，1 为各向同性）。</translation>
    </message>
    <message>
        <source>The next cell with a larger plate</source>
        <translation>打印板更大的下一个工作单元</translation>
    </message>
    <message>
        <source>The cell&apos;s smallest plate that carries the part</source>
        <translation>工作单元中能承载零件的最小打印板</translation>
    </message>
    <message>
        <source>Thicken to a wall</source>
        <translation>加厚成壁</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Try more rotations</source>
        <translation>尝试更多旋转角</translation>
    </message>
    <message>
        <source>Trying {way} ({number} of {count})</source>
        <translation>正在尝试 {way}（{count} 中的第 {number} 个）</translation>
    </message>
    <message>
        <source>Twice as many rotations about the nozzle per point; planning takes longer</source>
        <translation>每点绕喷嘴的旋转数加倍；规划耗时更长</translation>
    </message>
    <message>
        <source>Twice the distance of the arm from itself and from the part</source>
        <translation>机械臂与自身及零件的间距加倍</translation>
    </message>
    <message>
        <source>Two beads wide, centred on the surface</source>
        <translation>两条挤出线宽，以表面为中心</translation>
    </message>
    <message>
        <source>Unsupported: {share:.2f} of the bead length; at most {limit:.4g} allowed.</source>
        <translation>无支承：挤出线长度的 {share:.2f}；最多允许 {limit:.4g}。</translation>
    </message>
    <message>
        <source>Use a larger cell</source>
        <translation>使用更大的工作单元</translation>
    </message>
    <message>
        <source>Use longer motions</source>
        <translation>使用更长的运动</translation>
    </message>
    <message>
        <source>Use shorter motions</source>
        <translation>使用更短的运动</translation>
    </message>
    <message>
        <source>Use the cell&apos;s plate</source>
        <translation>使用工作单元的打印板</translation>
    </message>
    <message>
        <source>Use the usual cell</source>
        <translation>使用常用工作单元</translation>
    </message>
    <message>
        <source>Use the usual process</source>
        <translation>使用常用工艺</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, moved the nozzle along it without an arm, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta 读回了程序，在没有机械臂的情况下沿程序移动喷嘴，发现 {checks} 项检查未通过。</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, moved the nozzle along it without an arm, and measured what it prints.</source>
        <translation>Voluta 读回了程序，在没有机械臂的情况下沿程序移动喷嘴，并测量了打印结果。</translation>
    </message>
    <message numerus="yes">
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and found {checks} checks failed.</source>
        <translation>
            <numerusform>Voluta 读回了程序，在机器人及其控制器的模型上运行，发现 {checks} 项检查未通过。</numerusform>
        </translation>
    </message>
    <message>
        <source>Voluta read the program back, ran it on a model of the robot and its controller, and measured what it prints.</source>
        <translation>Voluta 读回了程序，在机器人及其控制器的模型上运行，并测量了打印结果。</translation>
    </message>
    <message>
        <source>Voluta {version}, {date}</source>
        <translation>Voluta {version}, {date}</translation>
    </message>
    <message>
        <source>Half the waypoint spacing; the program gets longer</source>
        <translation>路径点间距减半；程序变长</translation>
    </message>
    <message>
        <source>Twice the waypoint spacing</source>
        <translation>路径点间距加倍</translation>
    </message>
    <message>
        <source>Checks, with the closest approach to each limit</source>
        <translation>各项检查，以及最接近各极限之处</translation>
    </message>
    <message>
        <source>Modules and signal list for this controller: IRC5 (RobotWare 6) or OmniCore (RobotWare 7).</source>
        <translation>此控制器的模块和信号列表：IRC5 (RobotWare 6) 或 OmniCore (RobotWare 7)。</translation>
    </message>
    <message>
        <source>a ball refers to the missing vertex {vertex}</source>
        <translation>球引用了不存在的顶点 {vertex}</translation>
    </message>
    <message>
        <source>a beam refers to the missing vertex {vertex}</source>
        <translation>梁引用了不存在的顶点 {vertex}</translation>
    </message>
    <message>
        <source>a beam without a radius</source>
        <translation>梁没有半径</translation>
    </message>
    <message>
        <source>a picture of the sheet is not a PNG</source>
        <translation>报告页的图片不是 PNG</translation>
    </message>
    <message>
        <source>a stop until the operator continues</source>
        <translation>停止，直到操作员继续</translation>
    </message>
    <message>
        <source>a trigger for the output</source>
        <translation>输出的触发</translation>
    </message>
    <message>
        <source>a wait until the nozzle is hot</source>
        <translation>等待喷嘴加热到位</translation>
    </message>
    <message>
        <source>a wall of {wall:.2f} is too thin for a surface of this size: it would need {facets:.2g} triangles</source>
        <translation>{wall:.2f} 的壁对此尺寸的表面来说太薄：需要 {facets:.2g} 个三角形</translation>
    </message>
    <message>
        <source>absolute positions</source>
        <translation>绝对位置</translation>
    </message>
    <message>
        <source>after {time}</source>
        <translation>在 {time} 之后</translation>
    </message>
    <message>
        <source>an object of the unknown type &apos;{type}&apos;</source>
        <translation>未知类型“{type}”的对象</translation>
    </message>
    <message>
        <source>an extruder output is set while the arm is moving: it switches at the wrong place, or stops the arm on the bead</source>
        <translation>机械臂运动时设置挤出机输出：会在错误位置切换，或使机械臂停在挤出线上</translation>
    </message>
    <message>
        <source>according to the robot&apos;s controller</source>
        <translation>按机器人的控制器</translation>
    </message>
    <message>
        <source>at {place:.1f}</source>
        <translation>在 {place:.1f}</translation>
    </message>
    <message>
        <source>clear this place, or use a larger plate (`--platform`)</source>
        <translation>清空此处，或使用更大的打印板（`--platform`）</translation>
    </message>
    <message>
        <source>close</source>
        <translation>封闭</translation>
    </message>
    <message>
        <source>open edges were closed: {share:.3g} of the surface is patches</source>
        <translation>开放边已封闭：表面的 {share:.3g} 为补片</translation>
    </message>
    <message>
        <source>curved layers</source>
        <translation>曲面层</translation>
    </message>
    <message>
        <source>curved layers on a pedestal</source>
        <translation>底座上的曲面层</translation>
    </message>
    <message>
        <source>curved layers with supports</source>
        <translation>带支撑的曲面层</translation>
    </message>
    <message>
        <source>decimal commas read as decimal points</source>
        <translation>小数逗号按小数点读取</translation>
    </message>
    <message>
        <source>export it as a triangle mesh</source>
        <translation>将其导出为三角网格</translation>
    </message>
    <message>
        <source>export it with decimal points</source>
        <translation>用小数点导出</translation>
    </message>
    <message>
        <source>flat layers</source>
        <translation>平面层</translation>
    </message>
    <message>
        <source>flat layers with supports</source>
        <translation>带支撑的平面层</translation>
    </message>
    <message>
        <source>footprint of the part: {length:.0f} by {width:.0f}, larger than the cell&apos;s largest plate ({plate})</source>
        <translation>零件占地轮廓：{length:.0f} 乘 {width:.0f}，大于工作单元最大的打印板（{plate}）</translation>
    </message>
    <message>
        <source>has a disc inside another</source>
        <translation>圆盘之内有另一圆盘</translation>
    </message>
    <message>
        <source>contains nothing to print: {what}</source>
        <translation>没有可打印的内容：{what}</translation>
    </message>
    <message>
        <source>contains sliced G-code (&apos;{member}&apos;) and no model</source>
        <translation>含有切片后的 G-code（“{member}”）而没有模型</translation>
    </message>
    <message>
        <source>the counting mode of the filament</source>
        <translation>耗材的计数方式</translation>
    </message>
    <message>
        <source>parameter {key} no longer exists: its value has no effect</source>
        <translation>参数 {key} 已不存在：其值不起作用</translation>
    </message>
    <message>
        <source>parameter {oldKey} was renamed to {key}</source>
        <translation>参数 {oldKey} 已更名为 {key}</translation>
    </message>
    <message>
        <source>is damaged or truncated UTF-16</source>
        <translation>是损坏或截断的 UTF-16</translation>
    </message>
    <message>
        <source>is UTF-32, which cannot be read</source>
        <translation>是 UTF-32，无法读取</translation>
    </message>
    <message>
        <source>is not one of the colours: &apos;{name}&apos;</source>
        <translation>不是颜色之一：“{name}”</translation>
    </message>
    <message>
        <source>stored as text in an older project: plan again to see remedies</source>
        <translation>在旧项目中存为文本：重新规划以查看解决办法</translation>
    </message>
    <message>
        <source>layer height {height}, platform: {platform}</source>
        <translation>层高 {height}，平台：{platform}</translation>
    </message>
    <message>
        <source>layer height {height}, supports: {supports}, platform: {platform}</source>
        <translation>层高 {height}，支撑：{supports}，平台：{platform}</translation>
    </message>
    <message>
        <source>layer {layer}</source>
        <translation>层 {layer}</translation>
    </message>
    <message>
        <source>sheets without thickness were left out: {share:.3g} of the surface, {triangles} triangles</source>
        <translation>省略了没有厚度的薄片：表面的 {share:.3g}，{triangles} 个三角形</translation>
    </message>
    <message>
        <source>less than {share:.0f}</source>
        <translation>小于 {share:.0f}</translation>
    </message>
    <message>
        <source>line {line} of {file}</source>
        <translation>{file} 的第 {line} 行</translation>
    </message>
    <message>
        <source>millimetres as the unit of length</source>
        <translation>以毫米为长度单位</translation>
    </message>
    <message>
        <source>missing before this line: {statement}</source>
        <translation>此行之前缺少：{statement}</translation>
    </message>
    <message>
        <source>must be a colour like &quot;#d0d4d8&quot;</source>
        <translation>必须是 &quot;#d0d4d8&quot; 这样的颜色</translation>
    </message>
    <message>
        <source>must be in 1..{most}</source>
        <translation>必须在 1..{most} 之内</translation>
    </message>
    <message>
        <source>must hold as many discs as the first, at least one</source>
        <translation>必须含有与第一个同样多的圆盘，至少一个</translation>
    </message>
    <message>
        <source>must hold at least one solid</source>
        <translation>必须含有至少一个实体</translation>
    </message>
    <message>
        <source>must hold {wanted} values, holds {found}</source>
        <translation>必须含有 {wanted} 个值，现有 {found} 个</translation>
    </message>
    <message>
        <source>must not be along the axis</source>
        <translation>不得沿轴线方向</translation>
    </message>
    <message>
        <source>must not be before the previous one</source>
        <translation>不得在前一个之前</translation>
    </message>
    <message>
        <source>no available process has narrower beads</source>
        <translation>没有挤出线更窄的可用工艺</translation>
    </message>
    <message>
        <source>nothing is left: no triangle has area or encloses a volume</source>
        <translation>没有剩余内容：没有三角形有面积或围成体积</translation>
    </message>
    <message>
        <source>nozzle {nozzle}, bead {width#} x {height}</source>
        <translation>喷嘴 {nozzle}，挤出线 {width#} x {height}</translation>
    </message>
    <message>
        <source>numbers with decimal commas, such as &apos;{number}&apos;, mixed with numbers with decimal points</source>
        <translation>带小数逗号的数字（如“{number}”）与带小数点的数字混用</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; has a beam lattice clipped by a mesh, which cannot be read</source>
        <translation>对象“{id}”含有被网格裁剪的梁点阵，无法读取</translation>
    </message>
    <message>
        <source>object &apos;{id}&apos; is stored as slices (slicestack), which cannot be read</source>
        <translation>对象“{id}”以切片 (slicestack) 存储，无法读取</translation>
    </message>
    <message>
        <source>change the cell&apos;s file: Edit, Edit cell</source>
        <translation>更改工作单元的文件：编辑 &gt; 编辑工作单元</translation>
    </message>
    <message numerus="yes">
        <source>open surface: {rims} open edge loops, the widest {width:.3g} wide</source>
        <translation>
            <numerusform>开放表面：{rims} 个开放边环，最宽 {width:.3g}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>open surface: it ends at {rims} rims, the widest {width:.3g} wide at {at:.1f}</source>
        <translation>
            <numerusform>开放表面：止于 {rims} 个边缘，最宽 {width:.3g}，位于 {at:.1f}</numerusform>
        </translation>
    </message>
    <message>
        <source>open the model that it was sliced from</source>
        <translation>打开切片所用的原模型</translation>
    </message>
    <message>
        <source>to get a solid instead, use `openSurfaces=close`</source>
        <translation>要得到实体，使用 `openSurfaces=close`</translation>
    </message>
    <message>
        <source>to get a wall instead, use `openSurfaces=thicken`</source>
        <translation>要得到壁，使用 `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>to get walls instead, use `openSurfaces=thicken`</source>
        <translation>要得到壁，使用 `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>pieces with supports</source>
        <translation>带支撑的分块</translation>
    </message>
    <message>
        <source>planned time</source>
        <translation>规划时间</translation>
    </message>
    <message>
        <source>print the part at scale {scale}, or use a cell with a larger plate or a platform made for the part</source>
        <translation>以比例 {scale} 打印零件，或使用打印板更大的工作单元，或为零件制作的平台</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>拒绝</translation>
    </message>
    <message numerus="yes">
        <source>removed the self-intersections of {count} components</source>
        <translation>
            <numerusform>消除了 {count} 个组件的自相交</numerusform>
        </translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>另存为 UTF-8</translation>
    </message>
    <message>
        <source>set it by a trigger of the next motion, or write the program again</source>
        <translation>由下一个运动的触发来设置，或重新写出程序</translation>
    </message>
    <message>
        <source>sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles</source>
        <translation>薄片模型：表面的 {share:.3g} 没有厚度，{triangles} 个三角形</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} items marked as not printable</source>
        <translation>
            <numerusform>已跳过：{count} 个标记为不可打印的项目</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;other&apos;, which are not printed</source>
        <translation>
            <numerusform>已跳过：{count} 个 &apos;other&apos; 类型的对象，不予打印</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects of type &apos;surface&apos;, which are not solids</source>
        <translation>
            <numerusform>已跳过：{count} 个 &apos;surface&apos; 类型的对象，不是实体</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} objects without a mesh</source>
        <translation>
            <numerusform>已跳过：{count} 个没有网格的对象</numerusform>
        </translation>
    </message>
    <message>
        <source>contains {parts} parts, of which {limit} can be printed</source>
        <translation>含有 {parts} 个零件，最多可打印 {limit} 个</translation>
    </message>
    <message>
        <source>open it as one part</source>
        <translation>作为一个零件打开</translation>
    </message>
    <message numerus="yes">
        <source>skipped: {count} support objects</source>
        <translation>
            <numerusform>已跳过：{count} 个支撑对象</numerusform>
        </translation>
    </message>
    <message>
        <source>the PDF could not be created: {why}</source>
        <translation>无法创建 PDF：{why}</translation>
    </message>
    <message>
        <source>the arm passes this point at {stated:.1f} mm/s with unchanged flow; the path requires {suits:.1f} mm/s</source>
        <translation>机械臂以 {stated:.1f} mm/s 通过此点而流量不变；路径要求 {suits:.1f} mm/s</translation>
    </message>
    <message>
        <source>the robot dwells here for {time:.2f} with the hot nozzle touching the part</source>
        <translation>机器人在此停留 {time:.2f}，热喷嘴接触零件</translation>
    </message>
    <message>
        <source>the arm&apos;s posture at this target: {found} in the program, {planned} planned</source>
        <translation>机械臂在此目标的姿态：程序中为 {found}，规划为 {planned}</translation>
    </message>
    <message>
        <source>choose the bead to resume from on the Simulate page</source>
        <translation>在“仿真”页选择从哪条挤出线继续</translation>
    </message>
    <message>
        <source>the rounding distances of corners</source>
        <translation>拐角的倒圆距离</translation>
    </message>
    <message>
        <source>the reference run</source>
        <translation>回参考点运行</translation>
    </message>
    <message>
        <source>see the remedies of the findings before this one</source>
        <translation>参见此前各问题的解决办法</translation>
    </message>
    <message>
        <source>the frame of the targets</source>
        <translation>目标的坐标系</translation>
    </message>
    <message>
        <source>the full flow</source>
        <translation>满流量</translation>
    </message>
    <message>
        <source>the mechanical unit</source>
        <translation>机械单元</translation>
    </message>
    <message>
        <source>the message says how to fix it</source>
        <translation>消息中说明了如何修正</translation>
    </message>
    <message>
        <source>the part as printed, every bead laid</source>
        <translation>打印后的零件，所有挤出线均已铺放</translation>
    </message>
    <message>
        <source>no room on the plate for the prime: a bead {length:.0f} long is printed in the air beside the plate and falls down here</source>
        <translation>打印板上没有预挤出的空间：一条长 {length:.0f} 的挤出线在打印板旁空中打印并落在此处</translation>
    </message>
    <message>
        <source>the program does not match this plan: changing the plan does not help</source>
        <translation>程序与此规划不符：更改规划没有用</translation>
    </message>
    <message>
        <source>the range of the flow output</source>
        <translation>流量输出的范围</translation>
    </message>
    <message>
        <source>self-intersecting surface: {share:.3g} of the enclosed volume is inside out and counts as outside</source>
        <translation>表面自相交：所围体积的 {share:.3g} 内外颠倒，按外部处理</translation>
    </message>
    <message>
        <source>the nozzle temperature, °C</source>
        <translation>喷嘴温度，°C</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>加厚</translation>
    </message>
    <message>
        <source>one wall</source>
        <translation>单壁</translation>
    </message>
    <message>
        <source>Print as one wall</source>
        <translation>打印为单壁</translation>
    </message>
    <message>
        <source>One bead wide, centred on the surface; its rims stay open</source>
        <translation>一条挤出线宽，以表面为中心；其边缘保持开放</translation>
    </message>
    <message>
        <source>print it as one wall (`openSurfaces=wall`), thicken it to a wall of two beads (`openSurfaces=thicken`), close its rims to make it solid (`openSurfaces=close`), or close it in a modelling program</source>
        <translation>打印为单壁（`openSurfaces=wall`），加厚成两条挤出线的壁（`openSurfaces=thicken`），封闭边缘成为实体（`openSurfaces=close`），或在建模软件中封闭</translation>
    </message>
    <message>
        <source>print the sheets as walls of one bead (`openSurfaces=wall`) or two (`openSurfaces=thicken`), or give them a thickness in a modelling program</source>
        <translation>将薄片打印成一条（`openSurfaces=wall`）或两条（`openSurfaces=thicken`）挤出线的壁，或在建模软件中赋予厚度</translation>
    </message>
    <message>
        <source>thicken the surface in a modelling program</source>
        <translation>在建模软件中加厚表面</translation>
    </message>
    <message>
        <source>the open surface was thickened to a wall of {wall:.2f}, half on each side</source>
        <translation>开放表面已加厚成 {wall:.2f} 的壁，两侧各一半</translation>
    </message>
    <message>
        <source>thicken it to a wall of two beads (`openSurfaces=thicken`), or repair it in a modelling program</source>
        <translation>加厚成两条挤出线的壁（`openSurfaces=thicken`），或在建模软件中修复</translation>
    </message>
    <message>
        <source>the open surface crosses itself at {places} pairs of triangles, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>开放表面在 {places} 对三角形处自相交，第一对在 ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface has only one side: it is twisted along {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>开放表面只有一个面：它沿 {edges} 条边扭转，第一条在 ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>the open surface branches at {edges} edges, the first at ({x:.4g}, {y:.4g}, {z:.4g})</source>
        <translation>开放表面在 {edges} 条边处分叉，第一条在 ({x:.4g}, {y:.4g}, {z:.4g})</translation>
    </message>
    <message>
        <source>to get a wall of two beads instead, use `openSurfaces=thicken`</source>
        <translation>要得到两条挤出线的壁，使用 `openSurfaces=thicken`</translation>
    </message>
    <message>
        <source>the open surface is printed as one wall, one bead ({width:.2f}) wide</source>
        <translation>开放表面打印为单壁，宽一条挤出线（{width:.2f}）</translation>
    </message>
    <message numerus="yes">
        <source>converted {count} lattice beams into round bars</source>
        <translation>
            <numerusform>将 {count} 根点阵梁转换为圆杆</numerusform>
        </translation>
    </message>
    <message>
        <source>{bytes} bytes</source>
        <translation>{bytes} 字节</translation>
    </message>
    <message>
        <source>{hours} h {minutes} min</source>
        <translation>{hours} h {minutes} min</translation>
    </message>
    <message numerus="yes">
        <source>{layers} layers, {way}</source>
        <translation>
            <numerusform>{layers} 层，{way}</numerusform>
        </translation>
    </message>
    <message>
        <source>{least:.0f#} to {most:.0f}</source>
        <translation>{least:.0f#} 至 {most:.0f}</translation>
    </message>
    <message>
        <source>{mass:.1f} g, supports and waste included</source>
        <translation>{mass:.1f} g，含支撑和废料</translation>
    </message>
    <message>
        <source>{material}, {volume:.1f} cm3 at {density:.2f} g/cm3</source>
        <translation>{material}，{volume:.1f} cm3，密度 {density:.2f} g/cm3</translation>
    </message>
    <message>
        <source>{minutes} min {seconds} s</source>
        <translation>{minutes} min {seconds} s</translation>
    </message>
    <message>
        <source>{part}, {x:.1f#} x {y:.1f#} x {z:.1f}</source>
        <translation>{part}，{x:.1f#} x {y:.1f#} x {z:.1f}</translation>
    </message>
    <message>
        <source>{seconds} s</source>
        <translation>{seconds} s</translation>
    </message>
    <message>
        <source>at least {share:.0f} filled</source>
        <translation>至少填满 {share:.0f}</translation>
    </message>
    <message>
        <source>{statement}: {found} in the program, {planned} planned</source>
        <translation>{statement}：程序中为 {found}，规划为 {planned}</translation>
    </message>
    <message>
        <source>{time} on its controller</source>
        <translation>在其控制器上 {time}</translation>
    </message>
    <message>
        <source>{way}, {height} each</source>
        <translation>{way}，每层 {height}</translation>
    </message>
    <message>
        <source>a cut of the tape</source>
        <translation>切断纤维带</translation>
    </message>
    <message>
        <source>a pause for the operator</source>
        <translation>供操作员使用的暂停</translation>
    </message>
    <message>
        <source>a tool change</source>
        <translation>换工具</translation>
    </message>
    <message>
        <source>feeding in place</source>
        <translation>原地送料</translation>
    </message>
    <message>
        <source>is above 1</source>
        <translation>大于 1</translation>
    </message>
    <message>
        <source>mode {mode} needs a rod, but cell {cell} has none</source>
        <translation>{mode} 模式需要芯棒，但工作单元 {cell} 没有</translation>
    </message>
    <message>
        <source>must be #RRGGBB</source>
        <translation>必须是 #RRGGBB</translation>
    </message>
    <message>
        <source>nothing in this file is executed</source>
        <translation>此文件中没有内容被执行</translation>
    </message>
    <message>
        <source>one</source>
        <translation>一个</translation>
    </message>
    <message>
        <source>the report has no item</source>
        <translation>报告没有项目</translation>
    </message>
    <message>
        <source>unknown material &apos;{id}&apos;</source>
        <translation>未知材料“{id}”</translation>
    </message>
    <message>
        <source>events of unequal number</source>
        <translation>事件数量不一致</translation>
    </message>
    <message>
        <source>Share of the interior that is filled: the whole is solid, none is hollow. Walls and skins are always solid.</source>
        <translation>内部填充的比例：全部即实心，零即空心。壁和表皮始终实心。</translation>
    </message>
    <message>
        <source>sparse pattern</source>
        <translation>稀疏图案</translation>
    </message>
    <message>
        <source>Pattern of the interior if it is not solid.</source>
        <translation>内部非实心时的图案。</translation>
    </message>
    <message>
        <source>top layers</source>
        <translation>顶层数</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface above it.</source>
        <translation>稀疏内部与其上方表面之间的实心层。</translation>
    </message>
    <message>
        <source>bottom layers</source>
        <translation>底层数</translation>
    </message>
    <message>
        <source>Solid layers between the sparse interior and the surface below it.</source>
        <translation>稀疏内部与其下方表面之间的实心层。</translation>
    </message>
    <message>
        <source>skin thickness</source>
        <translation>表皮厚度</translation>
    </message>
    <message>
        <source>Minimum thickness of the top and bottom layers together with their number.</source>
        <translation>除层数外，还限定顶层和底层的最小厚度。</translation>
    </message>
    <message>
        <source>gyroid</source>
        <translation>螺旋二十四面体 (gyroid)</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>立方体</translation>
    </message>
    <message>
        <source>honeycomb</source>
        <translation>蜂窝</translation>
    </message>
    <message>
        <source>unknown sparse infill &apos;{id}&apos;</source>
        <translation>未知稀疏填充“{id}”</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>稀疏填充</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>桥接</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>纤维带</translation>
    </message>
    <message>
        <source>tapes after every n-th layer</source>
        <translation>每 n 层铺纤维带</translation>
    </message>
    <message>
        <source>Irons tapes of continuous fibre onto every n-th layer but the last; needs a tool for tape. 0: no tapes.</source>
        <translation>在除最后一层外的每 n 层上熨压连续纤维带；需要铺带工具。0：不铺带。</translation>
    </message>
    <message>
        <source>first layer with tapes</source>
        <translation>首个铺带层</translation>
    </message>
    <message>
        <source>Layers are counted from 1, on the platform.</source>
        <translation>层从平台起由 1 开始计数。</translation>
    </message>
    <message>
        <source>tapes on a layer</source>
        <translation>每层纤维带数</translation>
    </message>
    <message>
        <source>Only the longest tapes of each layer are laid. 0: as many as fit.</source>
        <translation>每层只铺最长的纤维带。0：能铺多少铺多少。</translation>
    </message>
    <message>
        <source>paths of tapes</source>
        <translation>纤维带路径</translation>
    </message>
    <message>
        <source>Tapes lie beside each other, one width apart.</source>
        <translation>纤维带并排铺放，间距为一个带宽。</translation>
    </message>
    <message>
        <source>direction of tapes</source>
        <translation>纤维带方向</translation>
    </message>
    <message>
        <source>Direction of tapes on the first layer with tapes, measured from x to y.</source>
        <translation>首个铺带层上纤维带的方向，从 x 向 y 测量。</translation>
    </message>
    <message>
        <source>rotation of tapes per layer</source>
        <translation>纤维带逐层旋转角</translation>
    </message>
    <message>
        <source>Rotation from one layer with tapes to the next.</source>
        <translation>从一个铺带层到下一个铺带层的旋转。</translation>
    </message>
    <message>
        <source>distance of tape ends</source>
        <translation>纤维带端部距离</translation>
    </message>
    <message>
        <source>Least distance of the ends of tapes from the outline, so that plastic encloses them. The sides are inside the outline.</source>
        <translation>纤维带端部到轮廓的最小距离，使塑料将其包裹。侧边位于轮廓之内。</translation>
    </message>
    <message>
        <source>curves for tapes</source>
        <translation>纤维带曲线</translation>
    </message>
    <message>
        <source>For tapes along given curves: points x,y or x,y,z in mm on the plate, separated by spaces, and semicolons between curves; or a file of them.</source>
        <translation>用于沿给定曲线的纤维带：打印板上的点 x,y 或 x,y,z，单位 mm，以空格分隔，曲线之间用分号；或包含它们的文件。</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>纤维</translation>
    </message>
    <message>
        <source>along a field of directions</source>
        <translation>沿方向场</translation>
    </message>
    <message>
        <source>there is no field of directions for tapes</source>
        <translation>没有用于纤维带的方向场</translation>
    </message>
    <message>
        <source>give place and direction as x,y,z,dx,dy,dz, separated by spaces or lines</source>
        <translation>以 x,y,z,dx,dy,dz 给出位置和方向，用空格或换行分隔</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no direction at a place</source>
        <translation>“{part}”不是某位置的方向</translation>
    </message>
    <message>
        <source>field of tape directions</source>
        <translation>纤维带方向场</translation>
    </message>
    <message>
        <source>For tapes along a field: x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them.</source>
        <translation>用于沿场的纤维带：打印板上的 x,y,z,dx,dy,dz，单位 mm，用空格或换行分隔，或包含它们的文件。</translation>
    </message>
    <message>
        <source>in one direction</source>
        <translation>沿一个方向</translation>
    </message>
    <message>
        <source>along the outline</source>
        <translation>沿轮廓</translation>
    </message>
    <message>
        <source>along given curves</source>
        <translation>沿给定曲线</translation>
    </message>
    <message>
        <source>unknown paths of tapes &apos;{id}&apos;</source>
        <translation>未知纤维带路径“{id}”</translation>
    </message>
    <message>
        <source>give points in mm: x,y or x,y,z, separated by spaces, at least two for each curve, and semicolons between curves</source>
        <translation>以 mm 给出点：x,y 或 x,y,z，以空格分隔，每条曲线至少两个，曲线之间用分号</translation>
    </message>
    <message>
        <source>no tool of the job lays tape</source>
        <translation>作业中没有铺纤维带的工具</translation>
    </message>
    <message>
        <source>add a tool with a process for tape, such as tape-5, or set `fibreLayers=0`</source>
        <translation>添加采用铺带工艺（如 tape-5）的工具，或设置 `fibreLayers=0`</translation>
    </message>
    <message>
        <source>process {process} lays tape and prints no beads</source>
        <translation>工艺 {process} 铺纤维带，不打印挤出线</translation>
    </message>
    <message>
        <source>choose it for a further tool, and another one for the part</source>
        <translation>将其用于另一个工具，零件另选工艺</translation>
    </message>
    <message>
        <source>no tape fits into the layers chosen for tapes: {width} wide and at least {length:.0f} long</source>
        <translation>纤维带无法放入所选的铺带层：宽 {width}，长至少 {length:.0f}</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`), other paths (`fibrePaths`), or a narrower tape</source>
        <translation>选择其他方向（`fibreAngle`）、其他路径（`fibrePaths`）或更窄的纤维带</translation>
    </message>
    <message>
        <source>{bent:.0f} of tape is left out because it bends more than a radius of {radius:.0f} allows, {short:.0f} because its pieces are shorter than {length:.0f}</source>
        <translation>省略了纤维带：{bent:.0f} 因弯曲超出半径 {radius:.0f} 的允许，{short:.0f} 因其各段短于 {length:.0f}</translation>
    </message>
    <message>
        <source>choose another direction (`fibreAngle`) or other paths (`fibrePaths`)</source>
        <translation>选择其他方向（`fibreAngle`）或其他路径（`fibrePaths`）</translation>
    </message>
    <message>
        <source>plastic does not cover the tape: {length:.0f} on layer {layer}, from this place on</source>
        <translation>塑料未覆盖纤维带：层 {layer} 上 {length:.0f}，从此处起</translation>
    </message>
    <message>
        <source>increase `fibreEndMm`, or choose layers that others cover (`fibreLayers`, `fibreFirstLayer`)</source>
        <translation>增大 `fibreEndMm`，或选择会被其他层覆盖的层（`fibreLayers`、`fibreFirstLayer`）</translation>
    </message>
    <message>
        <source>is not less than &apos;widthMm&apos;</source>
        <translation>不小于 &apos;widthMm&apos;</translation>
    </message>
    <message>
        <source>is less than half of &apos;widthMm&apos;</source>
        <translation>小于 &apos;widthMm&apos; 的一半</translation>
    </message>
    <message>
        <source>is not less than &apos;leastLengthMm&apos;</source>
        <translation>不小于 &apos;leastLengthMm&apos;</translation>
    </message>
    <message numerus="yes">
        <source>the skins above a hollow interior have nothing to rest on: {paths} beads, from this place on</source>
        <translation>
            <numerusform>空心内部之上的表皮没有支承：{paths} 条挤出线，从此处起</numerusform>
        </translation>
    </message>
    <message>
        <source>set `infillDensity` to 0.1 or more; for a part that is open at the top, set `topLayers` to 0</source>
        <translation>将 `infillDensity` 设为 0.1 或以上；对于顶部开放的零件，将 `topLayers` 设为 0</translation>
    </message>
    <message>
        <source>thin walls</source>
        <translation>薄壁</translation>
    </message>
    <message>
        <source>as the narrowest bead</source>
        <translation>按最窄挤出线</translation>
    </message>
    <message>
        <source>leave out</source>
        <translation>省略</translation>
    </message>
    <message>
        <source>Walls narrower than the narrowest bead: printed as that bead, and so too wide, or left out. Below half its width they are always left out.</source>
        <translation>窄于最窄挤出线的壁：按该挤出线打印（因而过宽），或省略。窄于其宽度一半的总是省略。</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is printed too wide: with the narrowest bead, {bead:.3g}</source>
        <translation>{length:.0f} 的壁（薄至 {width:.2f}）打印得过宽：采用最窄挤出线 {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or leave them out (`thinWalls=omit`)</source>
        <translation>使用更细的喷嘴，或省略它们（`thinWalls=omit`）</translation>
    </message>
    <message>
        <source>{length:.0f} of walls, down to {width:.2f} thin, is left out: the narrowest bead is {bead:.3g}</source>
        <translation>{length:.0f} 的壁（薄至 {width:.2f}）被省略：最窄挤出线为 {bead:.3g}</translation>
    </message>
    <message>
        <source>use a finer nozzle, or print them with that bead (`thinWalls=bead`)</source>
        <translation>使用更细的喷嘴，或用该挤出线打印它们（`thinWalls=bead`）</translation>
    </message>
    <message>
        <source>use thinner layers, or a part with steeper walls; another spiral may begin there</source>
        <translation>使用更薄的层，或壁更陡的零件；该处可能有另一条螺旋开始</translation>
    </message>
    <message>
        <source>the spiral ends below layer {layer} of {layers}, which does not continue the layer before</source>
        <translation>螺旋在层 {layer}（共 {layers} 层）之下结束，该层与前一层不连续</translation>
    </message>
    <message>
        <source>print towers as separate items, or cut off the part there; layers of several beads are printed as usual</source>
        <translation>将各塔作为单独的项目打印，或在该处切断零件；含多条挤出线的层照常打印</translation>
    </message>
    <message numerus="yes">
        <source>the spiral ends below layer {layer} of {layers}: it has {beads} beads, not one closed loop</source>
        <translation>
            <numerusform>螺旋在层 {layer}（共 {layers} 层）之下结束：该层有 {beads} 条挤出线，而非一个闭合环</numerusform>
        </translation>
    </message>
    <message>
        <source>{first} and {second} overlap</source>
        <translation>{first} 与 {second} 重叠</translation>
    </message>
    <message>
        <source>arrange the parts</source>
        <translation>排列零件</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or arrange them</source>
        <translation>在“准备”页移动其中一个零件，或排列零件</translation>
    </message>
    <message>
        <source>the head may touch {first} or {second} beside the other one: they are {gap:.1f} apart, the head needs {needed:.1f}</source>
        <translation>打印头可能在一个零件旁碰到另一个（{first} 或 {second}）：二者相距 {gap:.1f}，打印头需要 {needed:.1f}</translation>
    </message>
    <message>
        <source>{share:.2g} of {first} cannot be printed layer by layer: its layers tilt the head into {second}</source>
        <translation>{first} 的 {share:.2g} 无法逐层打印：其层使打印头倾斜进入 {second}</translation>
    </message>
    <message>
        <source>move one of the parts on the Prepare page, or print one after another</source>
        <translation>在“准备”页移动其中一个零件，或逐个打印</translation>
    </message>
    <message>
        <source>print one after another, or move {second} by {move:.0f}</source>
        <translation>逐个打印，或将 {second} 移动 {move:.0f}</translation>
    </message>
    <message>
        <source>print one after another</source>
        <translation>逐个打印</translation>
    </message>
    <message>
        <source>move {second} by {move:.0f}</source>
        <translation>将 {second} 移动 {move:.0f}</translation>
    </message>
    <message>
        <source>print them as separate jobs</source>
        <translation>作为单独的作业打印</translation>
    </message>
    <message>
        <source>the flange carries {carried:.3g} kg, {material:.3g} kg of it printed material; the robot is rated for {most:.3g} kg</source>
        <translation>法兰承载 {carried:.3g} kg，其中打印材料 {material:.3g} kg；机器人额定值为 {most:.3g} kg</translation>
    </message>
    <message>
        <source>print a smaller part, or with less infill, or use a stronger robot</source>
        <translation>打印更小的零件，或减少填充，或使用更强的机器人</translation>
    </message>
    <message>
        <source>choose a cell with a stronger robot on the Prepare page</source>
        <translation>在“准备”页选择机器人更强的工作单元</translation>
    </message>
    <message>
        <source>is above {limit:.0f}</source>
        <translation>大于 {limit:.0f}</translation>
    </message>
    <message>
        <source>is longer than maxLayerTimeS</source>
        <translation>比 maxLayerTimeS 长</translation>
    </message>
    <message>
        <source>`maxLayerTimeS={greatest:.0f}` is shorter than the {least:.0f} that {material} has to cool</source>
        <translation>`maxLayerTimeS={greatest:.0f}` 短于 {material} 冷却所需的 {least:.0f}</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than the {greatest:.0f} in which {material} bonds</source>
        <translation>`minLayerTimeS={least:.0f}` 长于 {material} 可粘合的 {greatest:.0f}</translation>
    </message>
    <message>
        <source>give a longer maximum, or another material</source>
        <translation>给出更长的最大值，或另选材料</translation>
    </message>
    <message>
        <source>give a shorter minimum, or another material</source>
        <translation>给出更短的最小值，或另选材料</translation>
    </message>
    <message>
        <source>arrange the parts, or print them layer by layer</source>
        <translation>排列零件，或逐层打印</translation>
    </message>
    <message>
        <source>Print layer by layer</source>
        <translation>逐层打印</translation>
    </message>
    <message>
        <source>All parts grow together, so that no finished part is in the way</source>
        <translation>所有零件一起生长，不会有已完成的零件挡路</translation>
    </message>
    <message>
        <source>the plate has no room for {parts} parts</source>
        <translation>打印板容不下 {parts} 个零件</translation>
    </message>
    <message>
        <source>print fewer or smaller parts, or use a cell with a larger plate</source>
        <translation>打印更少或更小的零件，或使用打印板更大的工作单元</translation>
    </message>
    <message>
        <source>a spiral is printed alone</source>
        <translation>螺旋须单独打印</translation>
    </message>
    <message>
        <source>remove the other parts, or set spiral to false</source>
        <translation>移除其他零件，或将 spiral 设为 false</translation>
    </message>
    <message>
        <source>a part around a rod or on a body is printed alone</source>
        <translation>围绕芯棒或在实体上的零件须单独打印</translation>
    </message>
    <message>
        <source>remove the other parts, or choose a way of building on a plate</source>
        <translation>移除其他零件，或选择在打印板上的构建方式</translation>
    </message>
    <message>
        <source>{parts} parts are too many for a job</source>
        <translation>{parts} 个零件对一个作业来说过多</translation>
    </message>
    <message>
        <source>print up to {most} parts</source>
        <translation>最多打印 {most} 个零件</translation>
    </message>
    <message>
        <source>a part on a ground of its own is printed alone</source>
        <translation>有自身基面的零件须单独打印</translation>
    </message>
    <message>
        <source>remove the other parts, or give `pathsOn=plate`</source>
        <translation>移除其他零件，或指定 `pathsOn=plate`</translation>
    </message>
    <message>
        <source>different for each part</source>
        <translation>各零件不同</translation>
    </message>
    <message>
        <source>the bed temperature, °C</source>
        <translation>热床温度，°C</translation>
    </message>
    <message>
        <source>a wait until the bed is hot</source>
        <translation>等待热床加热到位</translation>
    </message>
    <message>
        <source>must be at most {most}</source>
        <translation>最多为 {most}</translation>
    </message>
    <message>
        <source>must be one line that is not empty</source>
        <translation>必须是非空的一行</translation>
    </message>
    <message>
        <source>has no statements</source>
        <translation>没有语句</translation>
    </message>
    <message>
        <source>has its statements already</source>
        <translation>已有语句</translation>
    </message>
    <message>
        <source>must be between {least} and 1</source>
        <translation>必须在 {least} 和 1 之间</translation>
    </message>
    <message>
        <source>a wait for the extruder&apos;s start lag</source>
        <translation>等待挤出机启动滞后</translation>
    </message>
    <message>
        <source>stopping the extruder ahead of a bead&apos;s end</source>
        <translation>在挤出线末端之前停止挤出机</translation>
    </message>
    <message>
        <source>extruder {extruder} cannot keep the start and stop lag of process {process}</source>
        <translation>挤出机 {extruder} 无法实现工艺 {process} 的启停滞后</translation>
    </message>
    <message>
        <source>turning off the nozzle&apos;s heating</source>
        <translation>关闭喷嘴加热</translation>
    </message>
    <message>
        <source>turning off the bed&apos;s heating</source>
        <translation>关闭热床加热</translation>
    </message>
    <message>
        <source>part cooling {found} % from this line on, {planned} % planned</source>
        <translation>从此行起零件冷却为 {found} %，规划为 {planned} %</translation>
    </message>
    <message>
        <source>is above 250</source>
        <translation>大于 250</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a material&apos;s id</source>
        <translation>“{id}”不能作为材料的 id</translation>
    </message>
    <message>
        <source>use small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>使用小写字母、数字、&apos;-&apos;、&apos;_&apos; 和 &apos;.&apos;</translation>
    </message>
    <message>
        <source>a material &apos;{id}&apos; comes with the program</source>
        <translation>程序自带材料“{id}”</translation>
    </message>
    <message>
        <source>choose another id</source>
        <translation>选择另一个 id</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>冷却</translation>
    </message>
    <message>
        <source>minimum layer time</source>
        <translation>最小层时间</translation>
    </message>
    <message>
        <source>Minimum time before a bead is covered by the next layer, at every place. The robot waits above the part where the order of the beads does not give them this time. 0: no limit.</source>
        <translation>每一处的挤出线被下一层覆盖前的最短时间。若挤出线的顺序不足以提供此时间，机器人在零件上方等待。0：无限制。</translation>
    </message>
    <message>
        <source>maximum layer time</source>
        <translation>最大层时间</translation>
    </message>
    <message>
        <source>Age up to which a bead still bonds with the one above it. Older places are reported. 0: no limit.</source>
        <translation>挤出线仍能与其上方挤出线粘合的最大存放时间。超过的位置会报告。0：无限制。</translation>
    </message>
    <message>
        <source>a wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>lower the minimum layer time, print slower, or print without a spiral</source>
        <translation>减小最小层时间，放慢打印，或不用螺旋打印</translation>
    </message>
    <message>
        <source>only you know how long a bead has to cool: change the minimum layer time</source>
        <translation>只有用户知道挤出线需冷却多久：更改最小层时间</translation>
    </message>
    <message>
        <source>the bead below is {time:.1f} old when it is covered, beyond the maximum layer time of {limit:.1f}; so are {length:.0f} of beads</source>
        <translation>下方挤出线被覆盖时已有 {time:.1f}，超过最大层时间 {limit:.1f}；共有 {length:.0f} 挤出线如此</translation>
    </message>
    <message>
        <source>print faster, or fewer parts at a time</source>
        <translation>加快打印，或一次打印更少的零件</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average; at least {limit:.0f} required.</source>
        <translation>层间时间：在其控制器上 {shortest:.1f} 至 {longest:.1f}，平均 {mean:.1f}；至少需要 {limit:.0f}。</translation>
    </message>
    <message>
        <source>Layer time</source>
        <translation>层时间</translation>
    </message>
    <message>
        <source>slowest speed for cooling</source>
        <translation>冷却最低速度</translation>
    </message>
    <message>
        <source>Down to this speed beads are printed slower to keep the minimum layer time, before the robot waits. 0: it only waits.</source>
        <translation>为保持最小层时间，挤出线最多放慢到此速度，之后机器人才等待。0：只等待。</translation>
    </message>
    <message>
        <source>Time between layers: {shortest:.1f} to {longest:.1f} on its controller, {mean:.1f} on average.</source>
        <translation>层间时间：在其控制器上 {shortest:.1f} 至 {longest:.1f}，平均 {mean:.1f}。</translation>
    </message>
    <message>
        <source>`minLayerTimeS={least:.0f}` is longer than `maxLayerTimeS={greatest:.0f}`</source>
        <translation>`minLayerTimeS={least:.0f}` 长于 `maxLayerTimeS={greatest:.0f}`</translation>
    </message>
    <message>
        <source>give a shorter minimum, or a longer maximum</source>
        <translation>给出更短的最小值，或更长的最大值</translation>
    </message>
    <message>
        <source>#RRGGBB, for the view.</source>
        <translation>#RRGGBB，用于视图。</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a process&apos;s id</source>
        <translation>“{id}”不能作为工艺的 id</translation>
    </message>
    <message>
        <source>0: as in the process.</source>
        <translation>0：与工艺相同。</translation>
    </message>
    <message>
        <source>Beads are nowhere narrower.</source>
        <translation>挤出线不会比此更窄。</translation>
    </message>
    <message>
        <source>Beads are nowhere wider.</source>
        <translation>挤出线不会比此更宽。</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>桥接</translation>
    </message>
    <message>
        <source>Colder nozzles do not print it.</source>
        <translation>喷嘴温度更低时无法打印此材料。</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thicker.</source>
        <translation>曲面层不会比此更厚。</translation>
    </message>
    <message>
        <source>Curved layers are nowhere thinner.</source>
        <translation>曲面层不会比此更薄。</translation>
    </message>
    <message>
        <source>Density of the printed material.</source>
        <translation>打印材料的密度。</translation>
    </message>
    <message>
        <source>Diameter of the nozzle&apos;s opening.</source>
        <translation>喷嘴开口的直径。</translation>
    </message>
    <message>
        <source>Distance of waypoints along a tool-path.</source>
        <translation>沿工具路径的路径点间距。</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>挤出机</translation>
    </message>
    <message>
        <source>Factor of the bead&apos;s section.</source>
        <translation>挤出线截面的系数。</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>特征</translation>
    </message>
    <message>
        <source>Flow at full scale of the analogue output.</source>
        <translation>模拟输出满量程时的流量。</translation>
    </message>
    <message>
        <source>For people, for example how to dry it.</source>
        <translation>供人阅读，例如如何干燥。</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>打印头</translation>
    </message>
    <message>
        <source>Height and radius of its sections, in mm.</source>
        <translation>各截面的高度和半径，单位 mm。</translation>
    </message>
    <message>
        <source>Hotter nozzles damage it.</source>
        <translation>喷嘴温度更高会损坏此材料。</translation>
    </message>
    <message>
        <source>How deep the head may enter soft beads before it is a collision.</source>
        <translation>打印头可进入软挤出线的深度，超过即为碰撞。</translation>
    </message>
    <message>
        <source>In your currency. 0: unknown.</source>
        <translation>以本地货币计。0：未知。</translation>
    </message>
    <message>
        <source>Length of filament that is retracted for a travel. 0: none.</source>
        <translation>空移时回抽的耗材长度。0：不回抽。</translation>
    </message>
    <message>
        <source>Length that a bead bridges, unless the process states it.</source>
        <translation>挤出线可桥接的长度，除非工艺另有规定。</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>Material that the process prints.</source>
        <translation>此工艺打印的材料。</translation>
    </message>
    <message>
        <source>Maximum acceleration of the nozzle.</source>
        <translation>喷嘴的最大加速度。</translation>
    </message>
    <message>
        <source>Maximum length of an unsupported bridge.</source>
        <translation>无支承桥接的最大长度。</translation>
    </message>
    <message>
        <source>Maximum speed on a bridge.</source>
        <translation>桥接时的最大速度。</translation>
    </message>
    <message>
        <source>Melted at most, whatever the process allows.</source>
        <translation>最大熔融量，不管工艺允许多少。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Part cooling from the second layer on, 0 to 1.</source>
        <translation>从第二层起的零件冷却，0 至 1。</translation>
    </message>
    <message>
        <source>Part cooling of bridges, 0 to 1.</source>
        <translation>桥接时的零件冷却，0 至 1。</translation>
    </message>
    <message>
        <source>Shown in lists and reports.</source>
        <translation>显示在列表和报告中。</translation>
    </message>
    <message>
        <source>Speed of the nozzle between tool-paths.</source>
        <translation>喷嘴在工具路径之间的速度。</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>The extruder runs this long before a tool-path begins.</source>
        <translation>挤出机在工具路径开始前运行的时间。</translation>
    </message>
    <message>
        <source>Usual height of a layer, and of a bead.</source>
        <translation>层和挤出线的常用高度。</translation>
    </message>
    <message>
        <source>Usual speed of the nozzle while it prints.</source>
        <translation>喷嘴打印时的常用速度。</translation>
    </message>
    <message>
        <source>Usual temperature of the nozzle.</source>
        <translation>喷嘴的常用温度。</translation>
    </message>
    <message>
        <source>Usual temperature of the plate.</source>
        <translation>打印板的常用温度。</translation>
    </message>
    <message>
        <source>Usual width of a bead.</source>
        <translation>挤出线的常用宽度。</translation>
    </message>
    <message>
        <source>Whatever the process allows.</source>
        <translation>工艺允许的任意值。</translation>
    </message>
    <message>
        <source>a process &apos;{id}&apos; comes with the program</source>
        <translation>程序自带工艺“{id}”</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>as elsewhere</source>
        <translation>与其他处相同</translation>
    </message>
    <message>
        <source>as in the process</source>
        <translation>与工艺相同</translation>
    </message>
    <message>
        <source>block height</source>
        <translation>块体高度</translation>
    </message>
    <message>
        <source>block width</source>
        <translation>块体宽度</translation>
    </message>
    <message>
        <source>bridge flow</source>
        <translation>桥接流量</translation>
    </message>
    <message>
        <source>bridge length in bead widths</source>
        <translation>桥接长度（以线宽计）</translation>
    </message>
    <message>
        <source>bridge speed</source>
        <translation>桥接速度</translation>
    </message>
    <message>
        <source>cannot be deleted</source>
        <translation>无法删除</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>cone angle</source>
        <translation>锥角</translation>
    </message>
    <message>
        <source>cone angle must be below 180°</source>
        <translation>锥角必须小于 180°</translation>
    </message>
    <message>
        <source>cone height</source>
        <translation>锥体高度</translation>
    </message>
    <message>
        <source>contact tolerance</source>
        <translation>接触公差</translation>
    </message>
    <message>
        <source>density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>export the head with its nozzle pointing down</source>
        <translation>导出喷嘴朝下的打印头</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>风扇</translation>
    </message>
    <message>
        <source>fan on bridges</source>
        <translation>桥接风扇</translation>
    </message>
    <message>
        <source>first-layer flow</source>
        <translation>第一层流量</translation>
    </message>
    <message>
        <source>first-layer width</source>
        <translation>第一层线宽</translation>
    </message>
    <message>
        <source>infill flow</source>
        <translation>填充流量</translation>
    </message>
    <message>
        <source>inner-wall flow</source>
        <translation>内壁流量</translation>
    </message>
    <message>
        <source>is above 1000</source>
        <translation>大于 1000</translation>
    </message>
    <message>
        <source>is above 30 g/cm3: check the unit</source>
        <translation>大于 30 g/cm3：检查单位</translation>
    </message>
    <message>
        <source>is above {most} {unit}: check the unit</source>
        <translation>大于 {most} {unit}：检查单位</translation>
    </message>
    <message>
        <source>is below 1</source>
        <translation>小于 1</translation>
    </message>
    <message>
        <source>is {usual}, above &apos;max&apos;, which is {most}</source>
        <translation>为 {usual}，大于 &apos;max&apos; 的 {most}</translation>
    </message>
    <message>
        <source>is {usual}, below &apos;min&apos;, which is {least}</source>
        <translation>为 {usual}，小于 &apos;min&apos; 的 {least}</translation>
    </message>
    <message>
        <source>label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>longest bridge</source>
        <translation>最长桥接</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>maximum bead width</source>
        <translation>最大挤出线宽</translation>
    </message>
    <message>
        <source>maximum flow</source>
        <translation>最大流量</translation>
    </message>
    <message>
        <source>maximum layer height</source>
        <translation>最大层高</translation>
    </message>
    <message>
        <source>maximum nozzle temperature</source>
        <translation>最高喷嘴温度</translation>
    </message>
    <message>
        <source>minimum bead width</source>
        <translation>最小挤出线宽</translation>
    </message>
    <message>
        <source>minimum layer height</source>
        <translation>最小层高</translation>
    </message>
    <message>
        <source>minimum nozzle temperature</source>
        <translation>最低喷嘴温度</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>不得为空</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>nozzle diameter</source>
        <translation>喷嘴直径</translation>
    </message>
    <message>
        <source>nozzle temperature</source>
        <translation>喷嘴温度</translation>
    </message>
    <message>
        <source>nozzle tip radius</source>
        <translation>喷嘴尖端半径</translation>
    </message>
    <message>
        <source>outer-wall flow</source>
        <translation>外壁流量</translation>
    </message>
    <message>
        <source>outer-wall width</source>
        <translation>外壁线宽</translation>
    </message>
    <message>
        <source>plate temperature</source>
        <translation>打印板温度</translation>
    </message>
    <message>
        <source>price per kg</source>
        <translation>每 kg 价格</translation>
    </message>
    <message>
        <source>prime time</source>
        <translation>预挤出时间</translation>
    </message>
    <message>
        <source>print speed</source>
        <translation>打印速度</translation>
    </message>
    <message>
        <source>reduce angle or height of the cone</source>
        <translation>减小锥体的角度或高度</translation>
    </message>
    <message>
        <source>retraction length</source>
        <translation>回抽长度</translation>
    </message>
    <message>
        <source>sparse-infill flow</source>
        <translation>稀疏填充流量</translation>
    </message>
    <message>
        <source>sparse-infill speed</source>
        <translation>稀疏填充速度</translation>
    </message>
    <message>
        <source>support flow</source>
        <translation>支撑流量</translation>
    </message>
    <message>
        <source>support width</source>
        <translation>支撑线宽</translation>
    </message>
    <message>
        <source>the cone is {cone} wide at its top, more than the block&apos;s corners, {block}</source>
        <translation>锥体顶部宽 {cone}，大于块体对角宽 {block}</translation>
    </message>
    <message>
        <source>the mesh is flat: it has no height along z</source>
        <translation>网格是平的：沿 z 没有高度</translation>
    </message>
    <message>
        <source>travel speed</source>
        <translation>空移速度</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>waypoint distance</source>
        <translation>路径点间距</translation>
    </message>
    <message>
        <source>{name} must be greater than 0</source>
        <translation>{name} 必须大于 0</translation>
    </message>
    <message>
        <source>&apos;Pause&apos; does not wait for the motions before it (QueueTag)</source>
        <translation>&apos;Pause&apos; 未等待其前面的运动 (QueueTag)</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of tools</source>
        <translation>“{text}”不是工具列表</translation>
    </message>
    <message>
        <source>Material that flows out at the place of the tool change after each change of the tool.</source>
        <translation>每次换工具后在换工具位置挤出的材料。</translation>
    </message>
    <message>
        <source>Mode planar: numbers of the tools that print the pieces, separated by commas. The list starts over if there are more pieces. Empty: the tool of the part.</source>
        <translation>平面分块（planar 模式）：打印各分块的工具编号，以逗号分隔。分块更多时从头循环。空：零件的工具。</translation>
    </message>
    <message>
        <source>Number of the tool that fills the interior within walls and skins; 0: that of the part.</source>
        <translation>填充壁和表皮内部的工具编号；0：零件的工具。</translation>
    </message>
    <message>
        <source>Number of the tool that prints supports; 0: that of the part.</source>
        <translation>打印支撑的工具编号；0：零件的工具。</translation>
    </message>
    <message>
        <source>Number of the tool that prints the part. The tips of all tools are in one place, that of the cell&apos;s nozzle.</source>
        <translation>打印零件的工具编号。所有工具的尖端位于同一位置，即工作单元喷嘴的位置。</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>换工具</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>a purge of the nozzle</source>
        <translation>喷嘴清料</translation>
    </message>
    <message>
        <source>a tool is selected together with a command</source>
        <translation>工具与指令一起选择</translation>
    </message>
    <message>
        <source>add a tool, or give the number of one</source>
        <translation>添加工具，或给出已有工具的编号</translation>
    </message>
    <message>
        <source>are those of a changer</source>
        <translation>仅用于换刀装置</translation>
    </message>
    <message>
        <source>cannot be changer: the nozzle does not move</source>
        <translation>不能为 changer：喷嘴不移动</translation>
    </message>
    <message>
        <source>cell {cell} has no dock for tool {tool}</source>
        <translation>工作单元 {cell} 没有工具 {tool} 的停放位</translation>
    </message>
    <message>
        <source>give numbers, such as 1,2</source>
        <translation>给出数字，如 1,2</translation>
    </message>
    <message>
        <source>give up to {most}</source>
        <translation>最多给出 {most} 个</translation>
    </message>
    <message>
        <source>locking the tool</source>
        <translation>锁紧工具</translation>
    </message>
    <message>
        <source>the selection of the first tool</source>
        <translation>选择第一个工具</translation>
    </message>
    <message>
        <source>the tool that the program begins with</source>
        <translation>程序开始时的工具</translation>
    </message>
    <message>
        <source>before {event}</source>
        <translation>在{event}之前</translation>
    </message>
    <message>
        <source>behind {event}</source>
        <translation>在{event}之后</translation>
    </message>
    <message>
        <source>the time for {event}</source>
        <translation>{event}的时间</translation>
    </message>
    <message>
        <source>the text of the stop</source>
        <translation>停止的文本</translation>
    </message>
    <message>
        <source>a motion that begins with no tool</source>
        <translation>未装工具就开始的运动</translation>
    </message>
    <message>
        <source>the output of a tool is not set: an earlier run may have left it on</source>
        <translation>工具的输出未设置：先前的运行可能使其保持开启</translation>
    </message>
    <message>
        <source>the arm does not get to the place for purges without a collision</source>
        <translation>机械臂无法无碰撞地到达清料处</translation>
    </message>
    <message>
        <source>move the place or the part</source>
        <translation>移动清料处或零件</translation>
    </message>
    <message>
        <source>the nozzle does not move</source>
        <translation>喷嘴不移动</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the {body}</source>
        <translation>{volume:.0f} 的预挤出或清料落在 {body} 上</translation>
    </message>
    <message>
        <source>a prime or a purge of {volume:.0f} falls on the plate, beside the print</source>
        <translation>{volume:.0f} 的预挤出或清料落在打印板上、打印件旁</translation>
    </message>
    <message>
        <source>state a place for purges in the cell (purgeMm), or move the part</source>
        <translation>在工作单元中指定清料处 (purgeMm)，或移动零件</translation>
    </message>
    <message>
        <source>remove the strand before it is dragged along, or state a place for purges in the cell (purgeMm)</source>
        <translation>在料条被拖走之前将其移除，或在工作单元中指定清料处 (purgeMm)</translation>
    </message>
    <message>
        <source>print</source>
        <translation>打印件</translation>
    </message>
    <message>
        <source>workpiece</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>the arm does not reach the place for purges</source>
        <translation>机械臂到不了清料处</translation>
    </message>
    <message>
        <source>the arm collides at the place for purges</source>
        <translation>机械臂在清料处碰撞</translation>
    </message>
    <message>
        <source>move the place for purges</source>
        <translation>移动清料处</translation>
    </message>
    <message>
        <source>move the dock or the part</source>
        <translation>移动停放位或零件</translation>
    </message>
    <message>
        <source>must be hand, feeder or changer</source>
        <translation>必须是 hand、feeder 或 changer</translation>
    </message>
    <message>
        <source>purge</source>
        <translation>清料</translation>
    </message>
    <message>
        <source>releasing the tool</source>
        <translation>释放工具</translation>
    </message>
    <message>
        <source>remove a tool, or choose another cell</source>
        <translation>移除一个工具，或选择另一个工作单元</translation>
    </message>
    <message>
        <source>the arm does not get to the dock of tool {number} without a collision</source>
        <translation>机械臂无法无碰撞地到达工具 {number} 的停放位</translation>
    </message>
    <message>
        <source>the extruder {extruder} prints with one tool</source>
        <translation>挤出机 {extruder} 只用一个工具打印</translation>
    </message>
    <message>
        <source>the job has no tool {number}, it has {tools}</source>
        <translation>作业没有工具 {number}，共有 {tools} 个</translation>
    </message>
    <message>
        <source>the outputs of several tools are on</source>
        <translation>多个工具的输出同时开启</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>tool {number} cannot print layers of {height}</source>
        <translation>工具 {number} 无法打印 {height} 的层</translation>
    </message>
    <message>
        <source>tool {number}: {material}, {process}, {mass:.1f} g</source>
        <translation>工具 {number}：{material}，{process}，{mass:.1f} g</translation>
    </message>
    <message>
        <source>tools of the pieces</source>
        <translation>分块工具</translation>
    </message>
    <message>
        <source>{changes}, {mass:.1f} g purged</source>
        <translation>{changes}，清料 {mass:.1f} g</translation>
    </message>
    <message>
        <source>{tools} tools are too many for a job</source>
        <translation>{tools} 个工具对一个作业来说过多</translation>
    </message>
    <message>
        <source>export it in millimetres</source>
        <translation>以毫米为单位导出</translation>
    </message>
    <message>
        <source>the mesh is only {height} high</source>
        <translation>网格高度仅为 {height}</translation>
    </message>
    <message>
        <source>Layer times</source>
        <translation>层时间</translation>
    </message>
    <message>
        <source>Time that a bead needs before the next layer covers it, unless the job states it.</source>
        <translation>挤出线被下一层覆盖前所需的时间，除非作业另有规定。</translation>
    </message>
    <message>
        <source>Age up to which a bead bonds with the next layer, unless the job states it.</source>
        <translation>挤出线仍能与下一层粘合的最大存放时间，除非作业另有规定。</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>注入</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>缝合点</translation>
    </message>
    <message>
        <source>spacing of stitches</source>
        <translation>缝合点间距</translation>
    </message>
    <message>
        <source>Mode flat: distance of pockets that are filled from above in one shot and lock the layers together. 0: none.</source>
        <translation>平面层（flat 模式）：腔穴的间距，腔穴从上方一次注入填满，将各层锁在一起。0：无。</translation>
    </message>
    <message>
        <source>diameter of stitches</source>
        <translation>缝合点直径</translation>
    </message>
    <message>
        <source>stitches after every n-th layer</source>
        <translation>每 n 层设缝合点</translation>
    </message>
    <message>
        <source>Pockets end at the top of these layers.</source>
        <translation>腔穴止于这些层的顶面。</translation>
    </message>
    <message>
        <source>stitches need horizontal layers</source>
        <translation>缝合点需要水平层</translation>
    </message>
    <message>
        <source>set `stitchSpacing=0`, or give no `layerPlanes`</source>
        <translation>设置 `stitchSpacing=0`，或不指定 `layerPlanes`</translation>
    </message>
    <message>
        <source>excess of a shot</source>
        <translation>注入余量</translation>
    </message>
    <message>
        <source>Material of a shot beyond the volume of its pocket, as a share of that volume.</source>
        <translation>注入材料超出腔穴体积的部分，占该体积的比例。</translation>
    </message>
    <message>
        <source>nozzle depth of a shot</source>
        <translation>注入时喷嘴深度</translation>
    </message>
    <message>
        <source>Depth of the nozzle in the pocket; 0: it seals the opening.</source>
        <translation>喷嘴在腔穴中的深度；0：喷嘴封住开口。</translation>
    </message>
    <message>
        <source>flow of a shot</source>
        <translation>注入流量</translation>
    </message>
    <message>
        <source>Flow into a pocket, at most that of the process. 0: as much.</source>
        <translation>注入腔穴的流量，不超过工艺的流量。0：等于工艺流量。</translation>
    </message>
    <message>
        <source>wait after a shot</source>
        <translation>注入后等待</translation>
    </message>
    <message>
        <source>Time that the nozzle stays in the pocket after the shot, so that the material does not come out again.</source>
        <translation>注入后喷嘴停留在腔穴中的时间，防止材料回溢。</translation>
    </message>
    <message>
        <source>a shot into a pocket</source>
        <translation>向腔穴注入</translation>
    </message>
    <message>
        <source>Trace on a surface</source>
        <translation>在表面上描线</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>描线</translation>
    </message>
    <message>
        <source>find the seam</source>
        <translation>查找缝线</translation>
    </message>
    <message>
        <source>the part has no surface within {angle} of the vertical that is wide enough for a seam</source>
        <translation>零件没有与竖直方向夹角在 {angle} 以内且宽度足以容纳缝线的表面</translation>
    </message>
    <message>
        <source>turn the part, or increase `traceAngle`</source>
        <translation>转动零件，或增大 `traceAngle`</translation>
    </message>
    <message>
        <source>greatest angle of the traced surface</source>
        <translation>描线表面的最大角度</translation>
    </message>
    <message>
        <source>Mode trace: the seam is the outline of the part&apos;s surface whose normal is within this angle of the vertical.</source>
        <translation>描线（trace 模式）：缝线是零件上法线与竖直方向夹角不超过此值的表面的轮廓。</translation>
    </message>
    <message>
        <source>inset of the seam</source>
        <translation>缝线内缩</translation>
    </message>
    <message>
        <source>Distance of the first bead from the outline, inwards, seen from above.</source>
        <translation>从上方看，第一条挤出线向内到轮廓的距离。</translation>
    </message>
    <message>
        <source>seams</source>
        <translation>缝线</translation>
    </message>
    <message>
        <source>Number of beads from the outline inwards.</source>
        <translation>从轮廓向内的挤出线数量。</translation>
    </message>
    <message>
        <source>side passes</source>
        <translation>侧面道数</translation>
    </message>
    <message>
        <source>Number of beads on the side of the part, below the outline.</source>
        <translation>零件侧面、轮廓之下的挤出线数量。</translation>
    </message>
    <message>
        <source>depth of side passes</source>
        <translation>侧面道深度</translation>
    </message>
    <message>
        <source>Height of the outline above the first side pass.</source>
        <translation>轮廓高出第一条侧面道的高度。</translation>
    </message>
    <message>
        <source>lines at heel and toe</source>
        <translation>跟部和趾部线条</translation>
    </message>
    <message>
        <source>Number of parallel beads that fill each of the two ends inside the innermost seam.</source>
        <translation>填充最内侧缝线以内两端各自的平行挤出线数量。</translation>
    </message>
    <message>
        <source>angle of lines</source>
        <translation>线条角度</translation>
    </message>
    <message>
        <source>Angle of the lines at heel and toe to the x axis, seen from above.</source>
        <translation>从上方看，跟部和趾部线条与 x 轴的夹角。</translation>
    </message>
    <message>
        <source>dovetail</source>
        <translation>燕尾</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>锥形</translation>
    </message>
    <message>
        <source>shape of stitches</source>
        <translation>缝合点形状</translation>
    </message>
    <message>
        <source>Dovetail: chamber, cone and opening, three quarters of the diameter high. Cone: half of the diameter high.</source>
        <translation>燕尾：腔室、锥体和开口，高为直径的四分之三。锥形：高为直径的一半。</translation>
    </message>
    <message>
        <source>Diameter of a pocket where it is widest. Its opening is half of it wide.</source>
        <translation>腔穴最宽处的直径。其开口宽为此值的一半。</translation>
    </message>
    <message>
        <source>process {process} has no statements (beadWords) for format {format}, which its beads need</source>
        <translation>工艺 {process} 没有格式 {format} 的语句 (beadWords)，而其挤出线需要这些语句</translation>
    </message>
    <message>
        <source>use {formats}, or add the statements to the process</source>
        <translation>使用 {formats}，或为工艺添加语句</translation>
    </message>
    <message>
        <source>beadWords: &apos;{word}&apos; is not a word for a force</source>
        <translation>beadWords：“{word}”不是表示力的词</translation>
    </message>
    <message>
        <source>write {pressFrame}, {pressSpace}, {press 5} or {pressAxis 20}</source>
        <translation>写 {pressFrame}、{pressSpace}、{press 5} 或 {pressAxis 20}</translation>
    </message>
    <message>
        <source>the nozzle of cell {cell} is along no axis of the arm&apos;s base, so that MELFA cannot press along it</source>
        <translation>工作单元 {cell} 的喷嘴不沿机械臂基座的任何轴，因此 MELFA 无法沿其施压</translation>
    </message>
    <message>
        <source>use a cell whose nozzle is upright, or another format</source>
        <translation>使用喷嘴竖直的工作单元，或另一种格式</translation>
    </message>
    <message>
        <source>find the skeleton</source>
        <translation>查找骨架</translation>
    </message>
    <message>
        <source>pith</source>
        <translation>髓心</translation>
    </message>
    <message>
        <source>the part is not closed</source>
        <translation>零件未封闭</translation>
    </message>
    <message>
        <source>the part has no limbs</source>
        <translation>零件没有分枝</translation>
    </message>
    <message>
        <source>use infill that is dense along the part&apos;s middle (`sparsePattern=pith`)</source>
        <translation>使用沿零件中部较密的填充（`sparsePattern=pith`）</translation>
    </message>
    <message>
        <source>the limbs of the pith cannot be joined</source>
        <translation>髓心的各分枝无法连接</translation>
    </message>
    <message>
        <source>change the pith&apos;s share</source>
        <translation>更改髓心的比例</translation>
    </message>
    <message>
        <source>the pith cannot be cut at the part&apos;s surface</source>
        <translation>无法在零件表面处切断髓心</translation>
    </message>
    <message>
        <source>distance of seams</source>
        <translation>缝线间距</translation>
    </message>
    <message>
        <source>Distance between beads, seen from above. 0: the bead&apos;s width.</source>
        <translation>从上方看挤出线之间的距离。0：挤出线宽。</translation>
    </message>
    <message>
        <source>radius of the outline&apos;s hull</source>
        <translation>轮廓包络半径</translation>
    </message>
    <message>
        <source>Gaps of the outline through which no disc of this radius passes are closed.</source>
        <translation>此半径的圆盘无法通过的轮廓缺口会被封闭。</translation>
    </message>
    <message>
        <source>Hard plastic</source>
        <translation>硬塑料</translation>
    </message>
    <message>
        <source>Soft plastic</source>
        <translation>软塑料</translation>
    </message>
    <message>
        <source>the cutter has no diameter or no teeth</source>
        <translation>铣刀没有直径或没有刀齿</translation>
    </message>
    <message>
        <source>give --cutter and --teeth above 0</source>
        <translation>给出大于 0 的 --cutter 和 --teeth</translation>
    </message>
    <message>
        <source>a distance of passes is not positive</source>
        <translation>走刀间距不是正数</translation>
    </message>
    <message>
        <source>give distances above 0</source>
        <translation>给出大于 0 的间距</translation>
    </message>
    <message>
        <source>the block is less than the cutter&apos;s {diameter} wider than the part</source>
        <translation>毛坯比零件宽出的量小于铣刀直径 {diameter}</translation>
    </message>
    <message>
        <source>increase --gap</source>
        <translation>增大 --gap</translation>
    </message>
    <message>
        <source>unknown word {word}</source>
        <translation>未知的字 {word}</translation>
    </message>
    <message>
        <source>a motion before {word}</source>
        <translation>{word} 之前有运动</translation>
    </message>
    <message>
        <source>G53 with another position than Z0 is not understood</source>
        <translation>不支持位置不是 Z0 的 G53</translation>
    </message>
    <message>
        <source>the block turns while the cutter is not home</source>
        <translation>铣刀不在原位时毛坯转动</translation>
    </message>
    <message>
        <source>the block is turned by neither 0 nor 180 degrees</source>
        <translation>毛坯转动的角度不是 0 或 180 度</translation>
    </message>
    <message>
        <source>coordinates of another side</source>
        <translation>另一面的坐标</translation>
    </message>
    <message>
        <source>a rapid move through the block</source>
        <translation>快速移动穿过毛坯</translation>
    </message>
    <message>
        <source>the spindle has another speed than planned</source>
        <translation>主轴转速与规划不同</translation>
    </message>
    <message>
        <source>another feed than planned</source>
        <translation>进给与规划不同</translation>
    </message>
    <message>
        <source>{volume:.0f} of the block stay in slots, undercuts or holes that should be free, up to {height:.1f} high</source>
        <translation>毛坯中有 {volume:.0f} 残留在应清空的槽、倒扣或孔中，最高 {height:.1f}</translation>
    </message>
    <message>
        <source>only you know which cutter and block you have: change the values of the passes</source>
        <translation>只有用户知道所用的铣刀和毛坯：更改走刀的数值</translation>
    </message>
    <message>
        <source>the cutter takes up to {depth:.3f} from the part</source>
        <translation>铣刀从零件上切去最多 {depth:.3f}</translation>
    </message>
    <message>
        <source>the way home</source>
        <translation>返回原位的路线</translation>
    </message>
    <message>
        <source>&apos;{place}&apos; is no place</source>
        <translation>“{place}”不是位置</translation>
    </message>
    <message>
        <source>give X,Y,Z in mm and a rotation about z in degrees, as in 900,0,0,180</source>
        <translation>给出以 mm 为单位的 X,Y,Z 和绕 z 的旋转角度，如 900,0,0,180</translation>
    </message>
    <message>
        <source>the job has no motion</source>
        <translation>作业没有运动</translation>
    </message>
    <message>
        <source>looking for an order of work</source>
        <translation>查找工作顺序</translation>
    </message>
    <message>
        <source>{count} jobs: two to {most} machines can work together</source>
        <translation>{count} 个作业：两台至 {most} 台机器可以一起工作</translation>
    </message>
    <message>
        <source>machine {machine} waits in line {line} for a mark that the other does not reach</source>
        <translation>机器 {machine} 在第 {line} 行等待另一台到不了的标记</translation>
    </message>
    <message>
        <source>machine {machine} passes the mark in line {line} before machine {other} has reached it, if signals are still on or the programs are not started at once</source>
        <translation>如果信号仍为开启或程序未同时启动，机器 {machine} 会在机器 {other} 到达标记之前越过第 {line} 行的标记</translation>
    </message>
    <message>
        <source>machine {machine}: {reason}</source>
        <translation>机器 {machine}：{reason}</translation>
    </message>
    <message>
        <source>name a folder that &apos;together&apos; wrote</source>
        <translation>指定由 &apos;together&apos; 写出的文件夹</translation>
    </message>
    <message>
        <source>comparing the motions of the machines</source>
        <translation>比较各机器的运动</translation>
    </message>
    <message>
        <source>running all programs in one time</source>
        <translation>在同一时间轴上运行所有程序</translation>
    </message>
    <message>
        <source>a mark for the other machine</source>
        <translation>给另一台机器的标记</translation>
    </message>
    <message>
        <source>an input is read while motions are queued</source>
        <translation>在运动排队时读取输入</translation>
    </message>
    <message>
        <source>dense at the pith</source>
        <translation>髓心处较密</translation>
    </message>
    <message>
        <source>mean step height</source>
        <translation>平均台阶高度</translation>
    </message>
    <message>
        <source>Mean step
mm</source>
        <translation>平均
台阶 mm</translation>
    </message>
    <message>
        <source>greatest step height</source>
        <translation>最大台阶高度</translation>
    </message>
    <message>
        <source>Greatest
step mm</source>
        <translation>最大
台阶 mm</translation>
    </message>
    <message>
        <source>angle between beads and load</source>
        <translation>挤出线与载荷的夹角</translation>
    </message>
    <message>
        <source>Bead
angle °</source>
        <translation>挤出线
角度 °</translation>
    </message>
    <message>
        <source>interfaces across the load</source>
        <translation>横截载荷的界面</translation>
    </message>
    <message>
        <source>Inter-
faces %</source>
        <translation>界
面 %</translation>
    </message>
    <message>
        <source>interfaces in the weakest section</source>
        <translation>最弱截面的界面</translation>
    </message>
    <message>
        <source>Weakest
% interf.</source>
        <translation>最弱
界面 %</translation>
    </message>
    <message>
        <source>is below {least}</source>
        <translation>小于 {least}</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>size factor along x</source>
        <translation>沿 x 的尺寸系数</translation>
    </message>
    <message>
        <source>Flat layers are made larger by it, so that printed lengths are right. 1: none.</source>
        <translation>平面层按此放大，使打印长度正确。1：不变。</translation>
    </message>
    <message>
        <source>size factor along y</source>
        <translation>沿 y 的尺寸系数</translation>
    </message>
    <message>
        <source>As along x.</source>
        <translation>与沿 x 相同。</translation>
    </message>
    <message>
        <source>outline offset</source>
        <translation>轮廓偏移</translation>
    </message>
    <message>
        <source>Outlines of flat layers move outwards by it.</source>
        <translation>平面层的轮廓按此向外移动。</translation>
    </message>
    <message>
        <source>hole offset</source>
        <translation>孔偏移</translation>
    </message>
    <message>
        <source>Contours of holes in flat layers move into the material by it.</source>
        <translation>平面层中孔的轮廓按此向材料内移动。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>direction of the load</source>
        <translation>载荷方向</translation>
    </message>
    <message>
        <source>the job has no motion to compare with</source>
        <translation>作业没有可比较的运动</translation>
    </message>
    <message>
        <source>give rows such as: length x 50 49.8; slot y 5 4.8; hole 10 9.6</source>
        <translation>按此形式给出各行：length x 50 49.8; slot y 5 4.8; hole 10 9.6</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a size</source>
        <translation>“{word}”不是尺寸</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not a kind of size</source>
        <translation>“{word}”不是尺寸类型</translation>
    </message>
    <message>
        <source>not a kind, an axis and two sizes</source>
        <translation>不是“类型、轴和两个尺寸”</translation>
    </message>
    <message>
        <source>{measured} is too far from {nominal}</source>
        <translation>{measured} 与 {nominal} 相差太远</translation>
    </message>
    <message>
        <source>{key} would be {value}, beyond {least} to {most}</source>
        <translation>{key} 会是 {value}，超出 {least} 至 {most}</translation>
    </message>
    <message>
        <source>check the measured sizes</source>
        <translation>检查测得的尺寸</translation>
    </message>
    <message>
        <source>no measured sizes</source>
        <translation>没有测得的尺寸</translation>
    </message>
    <message>
        <source>aligning</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>流量</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>the record does not come near the planned path</source>
        <translation>记录与规划路径不接近</translation>
    </message>
    <message>
        <source>choose the project and the cell that it was recorded with</source>
        <translation>选择记录时所用的项目和工作单元</translation>
    </message>
    <message>
        <source>{found} joints are recorded, the cell has {wanted} axes</source>
        <translation>记录了 {found} 个关节，工作单元有 {wanted} 个轴</translation>
    </message>
    <message>
        <source>record all axes, external ones included</source>
        <translation>记录所有轴，包括外部轴</translation>
    </message>
    <message>
        <source>poses of the TCP do not contain the external axes</source>
        <translation>TCP 位姿不含外部轴</translation>
    </message>
    <message>
        <source>record the joints of all axes</source>
        <translation>记录所有轴的关节值</translation>
    </message>
    <message>
        <source>the pose of the TCP is incomplete</source>
        <translation>TCP 位姿不完整</translation>
    </message>
    <message>
        <source>record actual_q or all of actual_TCP_pose</source>
        <translation>记录 actual_q 或完整的 actual_TCP_pose</translation>
    </message>
    <message>
        <source>column &apos;{name}&apos; is missing</source>
        <translation>缺少列“{name}”</translation>
    </message>
    <message>
        <source>record X, Y, Z, A, B and C, or all joints</source>
        <translation>记录 X、Y、Z、A、B 和 C，或所有关节</translation>
    </message>
    <message>
        <source>RTDE of Universal Robots</source>
        <translation>Universal Robots 的 RTDE</translation>
    </message>
    <message>
        <source>monitor of MELFA</source>
        <translation>MELFA 的监视器</translation>
    </message>
    <message>
        <source>table of joints</source>
        <translation>关节表</translation>
    </message>
    <message>
        <source>no joints and no pose of the TCP among the columns</source>
        <translation>各列中没有关节，也没有 TCP 位姿</translation>
    </message>
    <message>
        <source>record actual_q (RTDE), X to C (MELFA) or j1_deg, j2_deg ...</source>
        <translation>记录 actual_q (RTDE)、X 至 C (MELFA) 或 j1_deg、j2_deg ...</translation>
    </message>
    <message>
        <source>no column of times</source>
        <translation>没有时间列</translation>
    </message>
    <message>
        <source>name it timestamp, time_s or time_ms</source>
        <translation>将其命名为 timestamp、time_s 或 time_ms</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>样本少于两个</translation>
    </message>
    <message>
        <source>record the whole run</source>
        <translation>记录整个运行</translation>
    </message>
    <message>
        <source>no number in column &apos;{column}&apos;</source>
        <translation>列“{column}”中没有数字</translation>
    </message>
    <message>
        <source>{found} values in a row instead of {wanted}, as there are names</source>
        <translation>一行有 {found} 个值，而名称有 {wanted} 个</translation>
    </message>
    <message>
        <source>no rows of numbers below a row of names</source>
        <translation>名称行之下没有数字行</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a direction</source>
        <translation>“{text}”不是方向</translation>
    </message>
    <message>
        <source>give x,y,z, for example 1,0,0</source>
        <translation>给出 x,y,z，例如 1,0,0</translation>
    </message>
    <message>
        <source>the job waits for another machine at marks</source>
        <translation>作业在标记处等待另一台机器</translation>
    </message>
    <message>
        <source>resume the job from which it was made, and print its rest alone</source>
        <translation>从制作它的原作业继续，并单独打印其剩余部分</translation>
    </message>
    <message>
        <source>milling passes</source>
        <translation>铣削走刀</translation>
    </message>
    <message>
        <source>milling the block</source>
        <translation>铣削毛坯</translation>
    </message>
    <message>
        <source>another motion than planned</source>
        <translation>运动与规划不同</translation>
    </message>
    <message>
        <source>laying the part down</source>
        <translation>放平零件</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>negative volume</source>
        <translation>负体积</translation>
    </message>
    <message>
        <source>modifier volume</source>
        <translation>修改体积</translation>
    </message>
    <message>
        <source>support enforcer</source>
        <translation>支撑强制区</translation>
    </message>
    <message>
        <source>support blocker</source>
        <translation>支撑屏蔽区</translation>
    </message>
    <message>
        <source>not used: extruder {number} of &apos;{object}&apos; ({where}): choose the tool of the part</source>
        <translation>未使用：“{object}”的挤出机 {number}（{where}）：选择零件的工具</translation>
    </message>
    <message>
        <source>not used: settings of &apos;{object}&apos; ({where}): {keys}</source>
        <translation>未使用：“{object}”的设置（{where}）：{keys}</translation>
    </message>
    <message>
        <source>not used: the slice stack of object &apos;{id}&apos; ({where}): its mesh is printed</source>
        <translation>未使用：对象“{id}”的切片堆（{where}）：打印其网格</translation>
    </message>
    <message>
        <source>cut away: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>已切除：“{object}”的{kind}“{name}”，其中心在文件中的 {place}</translation>
    </message>
    <message>
        <source>not used: {kind} &apos;{name}&apos; of &apos;{object}&apos;, its middle at {place} in the file</source>
        <translation>未使用：“{object}”的{kind}“{name}”，其中心在文件中的 {place}</translation>
    </message>
    <message>
        <source>read although its namespace is &apos;{space}&apos; and not that of 3MF ({where})</source>
        <translation>已读取，尽管其命名空间是“{space}”而非 3MF 的（{where}）</translation>
    </message>
    <message>
        <source>not used: materials and colours of objects and triangles, more than one from line {line} of {where}</source>
        <translation>未使用：对象和三角形的材料与颜色，从 {where} 的第 {line} 行起不止一种</translation>
    </message>
    <message>
        <source>M200 changes the meaning of E between beads</source>
        <translation>M200 在挤出线之间改变了 E 的含义</translation>
    </message>
    <message>
        <source>export the whole file with lengths of filament, or with volumes</source>
        <translation>整个文件以耗材长度导出，或以体积导出</translation>
    </message>
    <message>
        <source>purge lines beside the part are left out: {volume:.0f} from line {line} on</source>
        <translation>省略了零件旁的清料线：{volume:.0f}，从第 {line} 行起</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as the setting use_volumetric_e of the file says</source>
        <translation>按文件的 use_volumetric_e 设置，用量按体积读取</translation>
    </message>
    <message>
        <source>the negative volume &apos;{negative}&apos; cannot be cut out of &apos;{part}&apos;: their meshes are not closed or intersect themselves</source>
        <translation>无法从“{part}”中切出负体积“{negative}”：其网格未封闭或自相交</translation>
    </message>
    <message>
        <source>repair them in the slicer, or export the part as STL</source>
        <translation>在切片软件中修复它们，或将零件导出为 STL</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} elements {name}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>未使用：{count} 个 {name} 元素，第一个在 {where} 的第 {line} 行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: attribute {name} of {count} elements {element}, the first in line {line} of {where}</source>
        <translation>
            <numerusform>未使用：{count} 个 {element} 元素的属性 {name}，第一个在 {where} 的第 {line} 行</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: metadata &apos;{name}&apos; ({where})</source>
        <translation>未使用：元数据“{name}”（{where}）</translation>
    </message>
    <message>
        <source>not used: the division into {plates} plates ({where}): the parts of all are read</source>
        <translation>未使用：分为 {plates} 个打印板（{where}）：读取所有板上的零件</translation>
    </message>
    <message>
        <source>not used: settings of plates ({where}): {keys}</source>
        <translation>未使用：打印板设置（{where}）：{keys}</translation>
    </message>
    <message>
        <source>printed like the part: a volume of the unknown kind &apos;{kind}&apos; ({where})</source>
        <translation>按零件打印：未知类型“{kind}”的体积（{where}）</translation>
    </message>
    <message>
        <source>the slicer&apos;s settings</source>
        <translation>切片软件的设置</translation>
    </message>
    <message>
        <source>variable layer heights</source>
        <translation>可变层高</translation>
    </message>
    <message>
        <source>settings of ranges of height</source>
        <translation>高度区间的设置</translation>
    </message>
    <message>
        <source>stops, tools and G-code at given heights</source>
        <translation>指定高度处的停止、工具和 G-code</translation>
    </message>
    <message>
        <source>points of support</source>
        <translation>支撑点</translation>
    </message>
    <message>
        <source>drain holes</source>
        <translation>排液孔</translation>
    </message>
    <message>
        <source>ears of the brim</source>
        <translation>帽檐耳</translation>
    </message>
    <message>
        <source>not used: {what} (&apos;{member}&apos;)</source>
        <translation>未使用：{what}（“{member}”）</translation>
    </message>
    <message>
        <source>not used: {count} further members of the package</source>
        <translation>未使用：包中另外 {count} 个成员</translation>
    </message>
    <message>
        <source>not used: &apos;{member}&apos; in the package</source>
        <translation>未使用：包中的“{member}”</translation>
    </message>
    <message>
        <source>not used, as they are damaged: kinds and settings of objects ({where}): modifiers and negative volumes may be printed as parts: {why}</source>
        <translation>因损坏而未使用：对象的类型和设置（{where}）：修改体积和负体积可能按零件打印：{why}</translation>
    </message>
    <message>
        <source>does not have three numbers</source>
        <translation>没有三个数字</translation>
    </message>
    <message>
        <source>refers to a missing vertex</source>
        <translation>引用了不存在的顶点</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>没有三角形</translation>
    </message>
    <message>
        <source>is another version</source>
        <translation>是另一个版本</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): overhang after cutting {left:.0f} (pieces: {pieces}) instead of {leftBefore:.0f#} (pieces: {piecesBefore}, estimated); uncut {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>零件绕 ({x}, {y}, {z}) 转动了 {angle:.0f}：切割后悬垂 {left:.0f}（分块：{pieces}），原为 {leftBefore:.0f#}（分块：{piecesBefore}，估计值）；不切割时 {overhang:.0f}，原为 {overhangBefore:.0f#}</translation>
    </message>
    <message numerus="yes">
        <source>{shots} shots into pockets last up to {seconds:.1f}: after {most:.0f} in a pocket the nozzle melts the layers around it</source>
        <translation>
            <numerusform>{shots} 次向腔穴的注入持续达 {seconds:.1f}：在腔穴中超过 {most:.0f} 后喷嘴会熔化周围的层</numerusform>
        </translation>
    </message>
    <message>
        <source>use a process with a greater flow, or smaller pockets (`stitchDiameter`)</source>
        <translation>使用流量更大的工艺，或更小的腔穴（`stitchDiameter`）</translation>
    </message>
    <message>
        <source>support in closed hollows of the part cannot be removed: {volume:.3g}</source>
        <translation>零件封闭空腔中的支撑无法去除：{volume:.3g}</translation>
    </message>
    <message>
        <source>too many intersecting triangles to unite them ({pairs} pairs, at most {most}): shells stay as they are, overlaps count as one solid when layers are made</source>
        <translation>相交三角形过多，无法合并（{pairs} 对，最多 {most}）：各壳保持原样，生成层时重叠部分按一个实体处理</translation>
    </message>
    <message>
        <source>change parameters, process or cell of the plan, or leave this format out</source>
        <translation>更改规划的参数、工艺或工作单元，或不使用此格式</translation>
    </message>
    <message>
        <source>choose another program format</source>
        <translation>选择另一种程序格式</translation>
    </message>
    <message>
        <source>the tool-paths are those of the file: change them where they were made</source>
        <translation>工具路径来自文件：请在制作它们的软件中更改</translation>
    </message>
    <message>
        <source>slice the part again with supports there, or with denser infill; its tool-paths are printed as they are</source>
        <translation>在该处加支撑或用更密的填充重新切片；其工具路径按原样打印</translation>
    </message>
    <message>
        <source>check the widths and layer heights in the slicer against the bead of the process; the tool-paths are printed as they are</source>
        <translation>对照工艺的挤出线检查切片软件中的线宽和层高；工具路径按原样打印</translation>
    </message>
    <message>
        <source>check the flow in the slicer, and purge or prime lines that it does not mark; the tool-paths are printed as they are</source>
        <translation>检查切片软件中的流量，以及其未标注的清料线或预挤出线；工具路径按原样打印</translation>
    </message>
    <message>
        <source>check the slicer&apos;s flow, its filament diameter and its amounts at tool changes; the tool-paths are printed as they are</source>
        <translation>检查切片软件的流量、耗材直径和换工具时的用量；工具路径按原样打印</translation>
    </message>
    <message>
        <source>no {format} program: {why}</source>
        <translation>没有 {format} 程序：{why}</translation>
    </message>
    <message>
        <source>the {format} program lays beads by position, without the force of process {process}</source>
        <translation>{format} 程序按位置铺放挤出线，不带工艺 {process} 的力</translation>
    </message>
    <message>
        <source>to press with the force, use {formats}, or add the statements to the process (beadWords)</source>
        <translation>要以该力施压，使用 {formats}，或为工艺添加语句 (beadWords)</translation>
    </message>
    <message numerus="yes">
        <source>not used: {command} in {count} lines, the first is line {line}</source>
        <translation>
            <numerusform>未使用：{count} 行中的 {command}，第一行是第 {line} 行</numerusform>
        </translation>
    </message>
    <message>
        <source>{cell}: best of the planned rows (row {row})</source>
        <translation>{cell}：已规划各行中最好的（第 {row} 行）</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} statements &apos;{word}&apos;, the first in line {line}</source>
        <translation>
            <numerusform>未使用：{count} 条“{word}”语句，第一条在第 {line} 行</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;{word}&apos; is not followed by a joint motion: it changes the speed of a later travel</source>
        <translation>“{word}”之后没有关节运动：它会改变后面某个空移的速度</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out already</source>
        <translation>纤维带切刀已伸出</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not out</source>
        <translation>纤维带切刀未伸出</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is out for {time:.2f}: it needs {least:.1f} to {most:.1f}</source>
        <translation>纤维带切刀伸出 {time:.2f}：需要 {least:.1f} 至 {most:.1f}</translation>
    </message>
    <message>
        <source>the tape&apos;s cutter is not drawn back</source>
        <translation>纤维带切刀未收回</translation>
    </message>
    <message>
        <source>outside the function of a part: &apos;{code}&apos;</source>
        <translation>在程序分部的函数之外：“{code}”</translation>
    </message>
    <message>
        <source>the cutter&apos;s output needs S255 or S0</source>
        <translation>切刀的输出需要 S255 或 S0</translation>
    </message>
    <message>
        <source>the cutter&apos;s output runs ahead of the motions: M400 is missing before it</source>
        <translation>切刀的输出先于运动执行：其前缺少 M400</translation>
    </message>
    <message>
        <source>the first module declares &apos;{procedure}&apos;, too</source>
        <translation>第一个模块也声明了“{procedure}”</translation>
    </message>
    <message>
        <source>frame {id} follows frame {before}: frames are missing or in another order</source>
        <translation>帧 {id} 紧随帧 {before}：有帧缺失或顺序不同</translation>
    </message>
    <message>
        <source>the velocity at this point leads off the path</source>
        <translation>此点的速度偏离路径</translation>
    </message>
    <message>
        <source>the motors&apos; power for the first motion</source>
        <translation>第一个运动的电机功率</translation>
    </message>
    <message>
        <source>full</source>
        <translation>高</translation>
    </message>
    <message>
        <source>low</source>
        <translation>低</translation>
    </message>
    <message>
        <source>no place differs from the plan by more than the tolerances</source>
        <translation>没有与规划之差超过公差的位置</translation>
    </message>
    <message numerus="yes">
        <source>{count} places are beyond the tolerances</source>
        <translation>
            <numerusform>{count} 处超出公差</numerusform>
        </translation>
    </message>
    <message>
        <source>only {recorded:.1f} of {planned:.1f} of beads are recorded</source>
        <translation>挤出线仅记录了 {planned:.1f} 中的 {recorded:.1f}</translation>
    </message>
    <message>
        <source>this is no record of this job: {recorded:.1f} of {planned:.1f} of beads agree</source>
        <translation>这不是此作业的记录：挤出线 {planned:.1f} 中有 {recorded:.1f} 相符</translation>
    </message>
    <message>
        <source>Plan: {finding}.</source>
        <translation>规划：{finding}。</translation>
    </message>
    <message numerus="yes">
        <source>Plan: {count} more blocking findings.</source>
        <translation>
            <numerusform>规划：另有 {count} 个阻断问题。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not approved: the plan has blocking findings.</source>
        <translation>未批准：规划有阻断问题。</translation>
    </message>
    <message>
        <source>exists, perhaps with measured frames and obstacles</source>
        <translation>已存在，可能带有测得的坐标系和障碍物</translation>
    </message>
    <message>
        <source>give another name, --id, or replace it: --replace</source>
        <translation>用 --id 另取名称，或替换它：--replace</translation>
    </message>
    <message>
        <source>a share that is not positive</source>
        <translation>比例不是正数</translation>
    </message>
    <message>
        <source>amounts are taken as volumes, as UltiGCode states them</source>
        <translation>用量按体积读取，与 UltiGCode 一致</translation>
    </message>
    <message>
        <source>give S in percent</source>
        <translation>以百分比给出 S</translation>
    </message>
    <message>
        <source>two commands in one line: &apos;{code}&apos; and &apos;{next}&apos;</source>
        <translation>一行中有两条指令：“{code}”和“{next}”</translation>
    </message>
    <message>
        <source>write each command in a line of its own</source>
        <translation>每条指令单独写一行</translation>
    </message>
    <message>
        <source>a second object of the id &apos;{id}&apos;</source>
        <translation>第二个 id 为“{id}”的对象</translation>
    </message>
    <message>
        <source>cells of {pitch} are too fine for a block of {along} by {across}</source>
        <translation>{pitch} 的单元格对 {along} 乘 {across} 的毛坯来说太细</translation>
    </message>
    <message>
        <source>give --pitch of {least} or more</source>
        <translation>给出 {least} 或更大的 --pitch</translation>
    </message>
    <message>
        <source>must be within a kilometre</source>
        <translation>必须在一公里以内</translation>
    </message>
    <message>
        <source>not used: {bytes} bytes behind the {facets} facets that the header states</source>
        <translation>未使用：文件头声明的 {facets} 个面片之后的 {bytes} 字节</translation>
    </message>
    <message>
        <source>under G93 a way from an unknown place has no speed</source>
        <translation>G93 下从未知位置出发的路线没有速度</translation>
    </message>
    <message>
        <source>the table turns while the nozzle goes to its start</source>
        <translation>喷嘴前往起点时工作台转动</translation>
    </message>
    <message>
        <source>the nozzle is not above its start: its way has no speed</source>
        <translation>喷嘴不在其起点上方：其路线没有速度</translation>
    </message>
    <message>
        <source>the nozzle&apos;s height beside the print</source>
        <translation>喷嘴在打印件旁的高度</translation>
    </message>
    <message>
        <source>at least {height:.1f}</source>
        <translation>至少 {height:.1f}</translation>
    </message>
    <message>
        <source>the heat of {tool}</source>
        <translation>{tool} 的加热</translation>
    </message>
    <message>
        <source>the payload</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>the payload is not set</source>
        <translation>未设置负载</translation>
    </message>
    <message>
        <source>the payload&apos;s centre, mm</source>
        <translation>负载重心，mm</translation>
    </message>
    <message>
        <source>a payload&apos;s centre is no sensible place</source>
        <translation>负载重心的位置不合理</translation>
    </message>
    <message>
        <source>this text does not go to the extruder as those before it</source>
        <translation>此文本未像之前那样发送到挤出机</translation>
    </message>
    <message>
        <source>the head is {tip:.3g} wide at its tip and {end:.3g} at its other end: its nozzle seems to point away from the part</source>
        <translation>打印头尖端宽 {tip:.3g}，另一端宽 {end:.3g}：其喷嘴似乎背向零件</translation>
    </message>
    <message>
        <source>turn the head of process {process} over</source>
        <translation>将工艺 {process} 的打印头翻转</translation>
    </message>
    <message>
        <source>the plates of machine {one} ({cell}) and machine {two} ({other}) overlap by {depth:.1f} ({area:.0f})</source>
        <translation>机器 {one}（{cell}）与机器 {two}（{other}）的打印板重叠 {depth:.1f}（{area:.0f}）</translation>
    </message>
    <message>
        <source>{volume:.1f} extruded at rest are left out, from line {line} on</source>
        <translation>省略了静止时挤出的 {volume:.1f}，从第 {line} 行起</translation>
    </message>
    <message>
        <source>{volume:.0f} extruded by the printer&apos;s own code are left out, from line {line} on</source>
        <translation>省略了打印机自身代码挤出的 {volume:.0f}，从第 {line} 行起</translation>
    </message>
    <message>
        <source>the file states the filament diameter &apos;{text}&apos;: {diameter} assumed for values that cannot be used; for another one set `pathsFlow`</source>
        <translation>文件声明耗材直径为“{text}”：对无法使用的值假定为 {diameter}；若为其他值，设置 `pathsFlow`</translation>
    </message>
    <message>
        <source>the program ends here, beads that follow in line {line} would not be printed</source>
        <translation>程序在此结束，其后第 {line} 行的挤出线不会打印</translation>
    </message>
    <message>
        <source>remove the end (M2, M30, M112), or everything that follows it</source>
        <translation>移除结束指令 (M2, M30, M112)，或其后的所有内容</translation>
    </message>
    <message numerus="yes">
        <source>{count} settings have no effect on the tool-paths of a file: {keys}</source>
        <translation>
            <numerusform>{count} 项设置对文件的工具路径不起作用：{keys}</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the job has {count} tools: its first tool prints the file&apos;s beads of {tools}</source>
        <translation>
            <numerusform>作业有 {count} 个工具：第一个工具打印文件中 {tools} 的挤出线</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} entries of the element &apos;{name}&apos;</source>
        <translation>
            <numerusform>未使用：{count} 个“{name}”元素条目</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>divided into triangles: {count} facets of more than three vertices, the first in line {line}</source>
        <translation>
            <numerusform>已分成三角形：{count} 个顶点多于三个的面片，第一个在第 {line} 行</numerusform>
        </translation>
    </message>
    <message>
        <source>two joints are named &apos;{joint}&apos;</source>
        <translation>两个关节都名为“{joint}”</translation>
    </message>
    <message>
        <source>joint &apos;{joint}&apos;: the limits of its safety controller leave no room</source>
        <translation>关节“{joint}”：其安全控制器的极限没有留下余地</translation>
    </message>
    <message>
        <source>the time runs backwards, from {before:.3f} to {after:.3f} after the first row</source>
        <translation>第一行之后时间倒退，从 {before:.3f} 到 {after:.3f}</translation>
    </message>
    <message>
        <source>record one run in one file</source>
        <translation>一个文件记录一次运行</translation>
    </message>
    <message>
        <source>not used: the material or colour of objects and triangles, from line {line} of {where}</source>
        <translation>未使用：对象和三角形的材料或颜色，从 {where} 的第 {line} 行起</translation>
    </message>
    <message>
        <source>not used: the recommended extension &apos;{name}&apos; ({where})</source>
        <translation>未使用：推荐的扩展“{name}”（{where}）</translation>
    </message>
    <message>
        <source>not used: the unit {unit} of {where}: its lengths are taken in {main}, the unit of the main model</source>
        <translation>未使用：{where} 的单位 {unit}：其长度按主模型的单位 {main} 处理</translation>
    </message>
    <message>
        <source>not used: the layer &apos;{path}&apos;, which is not in the list of layers</source>
        <translation>未使用：不在层列表中的层“{path}”</translation>
    </message>
    <message>
        <source>the name of the folder is empty</source>
        <translation>文件夹名称为空</translation>
    </message>
    <message>
        <source>name a folder for the results</source>
        <translation>指定存放结果的文件夹</translation>
    </message>
    <message>
        <source>beads of {least} to {most} do not fit a nozzle of {nozzle}</source>
        <translation>{least} 至 {most} 的挤出线不适合 {nozzle} 的喷嘴</translation>
    </message>
    <message>
        <source>check nozzleDiameterMm and beadWidthMm</source>
        <translation>检查 nozzleDiameterMm 和 beadWidthMm</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no pair x,radius</source>
        <translation>“{text}”不是数对 x,半径</translation>
    </message>
    <message>
        <source>contains no points</source>
        <translation>不含点</translation>
    </message>
    <message>
        <source>give numbers in mm, separated by commas: x,y,z</source>
        <translation>以 mm 给出数字，用逗号分隔：x,y,z</translation>
    </message>
    <message>
        <source>is no result of this kind of job, and would be replaced</source>
        <translation>不是此类作业的结果，将被替换</translation>
    </message>
    <message>
        <source>choose another folder, or give --replace</source>
        <translation>选择另一个文件夹，或指定 --replace</translation>
    </message>
    <message>
        <source>give it for the job: --set {key}=...</source>
        <translation>为作业指定：--set {key}=...</translation>
    </message>
    <message>
        <source>one mesh</source>
        <translation>一个网格</translation>
    </message>
    <message>
        <source>one mesh; read by a program of its own</source>
        <translation>一个网格；由单独的程序读取</translation>
    </message>
    <message>
        <source>several parts, or tool-paths (build files)</source>
        <translation>多个零件，或工具路径（构建文件）</translation>
    </message>
    <message>
        <source>solid cells, drawn as text</source>
        <translation>实心单元格，以文本绘制</translation>
    </message>
    <message>
        <source>tool-paths of a slicer</source>
        <translation>切片软件的工具路径</translation>
    </message>
    <message>
        <source>{key} is a setting of the job, not of a part</source>
        <translation>{key} 是作业的设置，不是零件的设置</translation>
    </message>
    <message>
        <source>use one of these formats: {formats}</source>
        <translation>使用以下格式之一：{formats}</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not a part</source>
        <translation>是多机工位的项目，不是零件</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, &apos;verify&apos; or &apos;resume&apos;; a part is a file of its own</source>
        <translation>将其交给 &apos;together&apos;、&apos;verify&apos; 或 &apos;resume&apos;；零件是单独的文件</translation>
    </message>
    <message>
        <source>a project, not a part</source>
        <translation>是项目，不是零件</translation>
    </message>
    <message>
        <source>give it to &apos;resume&apos;, &apos;verify&apos; or &apos;together&apos;; a part is a file of its own</source>
        <translation>将其交给 &apos;resume&apos;、&apos;verify&apos; 或 &apos;together&apos;；零件是单独的文件</translation>
    </message>
    <message>
        <source>not the file of a part</source>
        <translation>不是零件文件</translation>
    </message>
    <message>
        <source>the file ends within line {line}, without a line end: it may be cut there, and the part unfinished; export it again</source>
        <translation>文件在第 {line} 行内结束，没有换行符：可能在此被截断，零件不完整；请重新导出</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is more than a kilometre away</source>
        <translation>“{text}”在一公里以外</translation>
    </message>
    <message>
        <source>give places in mm</source>
        <translation>以 mm 给出位置</translation>
    </message>
    <message>
        <source>there is no curve for tapes</source>
        <translation>没有用于纤维带的曲线</translation>
    </message>
    <message>
        <source>this text goes nowhere: the connection &apos;{name}&apos; is not open</source>
        <translation>此文本无处可发：连接“{name}”未打开</translation>
    </message>
    <message>
        <source>a connection needs an address and a port</source>
        <translation>连接需要地址和端口</translation>
    </message>
    <message>
        <source>this file moves the arm before it states the payload</source>
        <translation>此文件在声明负载之前就移动机械臂</translation>
    </message>
    <message>
        <source>this file sets the flow before it states the range of the output</source>
        <translation>此文件在声明输出范围之前就设置流量</translation>
    </message>
    <message>
        <source>G28 with a number goes to a place first: give letters alone, or none</source>
        <translation>带数字的 G28 会先去某个位置：只给字母，或不给</translation>
    </message>
    <message>
        <source>G94 is missing before this motion: after a run that was stopped its F would be read as a time</source>
        <translation>此运动之前缺少 G94：在中止的运行之后，其 F 会被读作时间</translation>
    </message>
    <message>
        <source>change the places of the machines in their table</source>
        <translation>在机器表格中更改机器的位置</translation>
    </message>
    <message>
        <source>every two machines can work together, but no order of work was found for all</source>
        <translation>任意两台机器可以一起工作，但未找到适用于所有机器的工作顺序</translation>
    </message>
    <message>
        <source>give a bead or a line for each machine, in their order</source>
        <translation>按顺序为每台机器给出一条挤出线或一行</translation>
    </message>
    <message>
        <source>give it to &apos;together&apos;, or the job.voluta of one machine here</source>
        <translation>将其交给 &apos;together&apos;，或在此给出一台机器的 job.voluta</translation>
    </message>
    <message>
        <source>increase the minimum distance of moving arms, or place the machines further apart</source>
        <translation>增大运动机械臂的最小距离，或使机器相距更远</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>这是文件夹</translation>
    </message>
    <message>
        <source>no order of work keeps the machines apart: {first} of machine {one} and {second} of machine {two} hinder each other</source>
        <translation>没有工作顺序能使机器互不干涉：机器 {one} 的 {first} 与机器 {two} 的 {second} 互相妨碍</translation>
    </message>
    <message>
        <source>no program of it passed that states the arm</source>
        <translation>它没有说明机械臂的程序通过</translation>
    </message>
    <message>
        <source>not the project of a station</source>
        <translation>不是工位的项目</translation>
    </message>
    <message>
        <source>place the machines further apart if they stand at two plates</source>
        <translation>如果机器位于两块打印板旁，使机器相距更远</translation>
    </message>
    <message>
        <source>place the machines further apart, or the parts further from the border</source>
        <translation>使机器相距更远，或使零件离边界更远</translation>
    </message>
    <message>
        <source>place the machines further apart, the parts further from the border, or the arms at rest further from it</source>
        <translation>使机器相距更远，使零件离边界更远，或使静止的机械臂离边界更远</translation>
    </message>
    <message>
        <source>see the report of that machine</source>
        <translation>参见该机器的报告</translation>
    </message>
    <message>
        <source>the file of the station is truncated</source>
        <translation>工位文件被截断</translation>
    </message>
    <message>
        <source>the folder holds no program of the station</source>
        <translation>文件夹中没有该工位的程序</translation>
    </message>
    <message>
        <source>the header of the station&apos;s file is damaged</source>
        <translation>工位文件的文件头已损坏</translation>
    </message>
    <message>
        <source>the part of machine {one} or {two} is inside the part, the plate or an obstacle of the other</source>
        <translation>机器 {one} 或 {two} 的零件位于另一台的零件、打印板或障碍物之内</translation>
    </message>
    <message>
        <source>the place of a machine is damaged</source>
        <translation>机器的位置数据已损坏</translation>
    </message>
    <message>
        <source>the program is refused</source>
        <translation>程序被拒绝</translation>
    </message>
    <message>
        <source>the project is not of machines that work together</source>
        <translation>项目不是由一起工作的机器组成</translation>
    </message>
    <message>
        <source>the project of a station of several machines, not of one job</source>
        <translation>是多机工位的项目，不是单个作业的项目</translation>
    </message>
    <message>
        <source>the rules of the station are damaged</source>
        <translation>工位的规则已损坏</translation>
    </message>
    <message>
        <source>the station has no machines</source>
        <translation>工位没有机器</translation>
    </message>
    <message>
        <source>write the programs of all machines again</source>
        <translation>重新写出所有机器的程序</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} ({layer})</source>
        <translation>机器 {one} 的 {body} 与机器 {two} 的 {obstacle} 相碰（{layer}）</translation>
    </message>
    <message>
        <source>{body} of machine {one} meets {obstacle} of machine {two} after {time}; collisions of the machines: {collisions}</source>
        <translation>在 {time} 之后机器 {one} 的 {body} 与机器 {two} 的 {obstacle} 相碰；机器间碰撞：{collisions}</translation>
    </message>
    <message>
        <source>{places} places for {machines} machines</source>
        <translation>{machines} 台机器有 {places} 个位置</translation>
    </message>
    <message>
        <source>bead {bead} is printed: this rest begins with bead {first}</source>
        <translation>挤出线 {bead} 已打印：此剩余部分从挤出线 {first} 开始</translation>
    </message>
    <message>
        <source>beads have the numbers of the whole print</source>
        <translation>挤出线沿用整个打印的编号</translation>
    </message>
    <message>
        <source>the place of a machine</source>
        <translation>机器的位置</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>How far the printed part may differ from the requested one before the plan is marked. Never changes what is safe to run.</source>
        <translation>打印出的零件与要求的零件相差多少后标记规划。绝不改变运行安全的判定。</translation>
    </message>
    <message>
        <source>In this job; the verification report lists it</source>
        <translation>用于此作业；验证报告会列出</translation>
    </message>
    <message numerus="yes">
        <source>Nothing that was checked endangers robot or cell: {checks} checks of the part are beyond their limits.</source>
        <translation>
            <numerusform>检查过的内容均不危及机器人或工作单元：零件有 {checks} 项检查超出限制。</numerusform>
        </translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量等级</translation>
    </message>
    <message>
        <source>Safe to run, but it does not print the part as asked.</source>
        <translation>可安全运行，但不能按要求打印零件。</translation>
    </message>
    <message>
        <source>accepted differences</source>
        <translation>接受的差异</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>重量</translation>
    </message>
    <message>
        <source>overfill</source>
        <translation>过填充</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>质量等级</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>严格</translation>
    </message>
    <message>
        <source>uncovered</source>
        <translation>未覆盖</translation>
    </message>
    <message>
        <source>unsupported</source>
        <translation>无支承</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>{length:.1f} of bead ({share:.2f}) is unsupported</source>
        <translation>{length:.1f} 挤出线（{share:.2f}）无支承</translation>
    </message>
    <message>
        <source>{quality}; accepted: {shares}</source>
        <translation>{quality}；已接受：{shares}</translation>
    </message>
    <message>
        <source>How a part whose surface has wide openings or no thickness is handled: close openings that are flat or small and refuse others, refuse it, close the openings with patches, thicken the surface to a wall two beads wide, or print it as one wall, one bead wide.</source>
        <translation>表面有大开口或没有厚度的零件如何处理：封闭平的或小的开口并拒绝其他；拒绝；用补片封闭开口；将表面加厚成两条挤出线宽的壁；或打印为一条挤出线宽的单壁。</translation>
    </message>
    <message>
        <source>Shares that are accepted in this job beyond the quality&apos;s limits: uncovered, unsupported, overfill, mass and thin, such as uncovered=0.05, mass=0.04. Verification reports list them.</source>
        <translation>此作业中超出质量等级限制而接受的比例：uncovered、unsupported、overfill、mass 和 thin，如 uncovered=0.05, mass=0.04。验证报告会列出。</translation>
    </message>
    <message>
        <source>The spiral follows the largest contour of each layer; holes and other contours are left out.</source>
        <translation>螺旋沿每层最大的轮廓；孔和其他轮廓被省略。</translation>
    </message>
    <message>
        <source>Thin: {share:.1f} of the part is narrower than the narrowest bead and stays open; at most {limit:.4g} allowed.</source>
        <translation>过薄：零件的 {share:.1f} 窄于最窄挤出线，保持空缺；最多允许 {limit:.4g}。</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>check these places in the view; move the part on the plate if they matter</source>
        <translation>在视图中检查这些位置；如果重要，在打印板上移动零件</translation>
    </message>
    <message>
        <source>choose a process with narrower beads, or slice the part again with wider ones</source>
        <translation>选择挤出线更窄的工艺，或用更宽的挤出线重新切片</translation>
    </message>
    <message>
        <source>choose the process that the file was sliced for; the tool-paths are printed as they are</source>
        <translation>选择文件切片时所用的工艺；工具路径按原样打印</translation>
    </message>
    <message>
        <source>export the file again in millimetres, at the size to be printed</source>
        <translation>以毫米为单位、按要打印的尺寸重新导出文件</translation>
    </message>
    <message>
        <source>in line {line} first</source>
        <translation>自第 {line} 行起</translation>
    </message>
    <message>
        <source>in no single line</source>
        <translation>总体上</translation>
    </message>
    <message>
        <source>look at that line: export the file again without it, with straight lines or arcs (G1, G2, G3)</source>
        <translation>查看该行：去掉该行重新导出文件，使用直线或圆弧 (G1, G2, G3)</translation>
    </message>
    <message>
        <source>move the part on the plate, or slice it again for a lower speed there</source>
        <translation>在打印板上移动零件，或以更低的速度在该处重新切片</translation>
    </message>
    <message>
        <source>move the part on the plate, or use another cell; its tool-paths are printed as they are</source>
        <translation>在打印板上移动零件，或使用另一个工作单元；其工具路径按原样打印</translation>
    </message>
    <message>
        <source>move the part on the plate, use a slimmer print head, or allow less clearance</source>
        <translation>在打印板上移动零件，使用更细长的打印头，或允许更小的安全间距</translation>
    </message>
    <message>
        <source>outer contour alone</source>
        <translation>仅外轮廓</translation>
    </message>
    <message>
        <source>plan again with more clearance, or move the part on the plate</source>
        <translation>以更大的安全间距重新规划，或在打印板上移动零件</translation>
    </message>
    <message>
        <source>see its report</source>
        <translation>参见其报告</translation>
    </message>
    <message>
        <source>see the remedies in the job of that machine</source>
        <translation>参见该机器作业中的解决办法</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, its beads and what is left out have {read:.0f}; they part {line}</source>
        <translation>按 E 字，文件挤出 {stated:.0f}；其挤出线与省略部分合计 {read:.0f}；二者{line}不一致</translation>
    </message>
    <message>
        <source>the file extrudes {stated:.0f} by its E words, the tool-paths taken from it have {read:.0f}; they part {line}</source>
        <translation>按 E 字，文件挤出 {stated:.0f}；取自文件的工具路径为 {read:.0f}；二者{line}不一致</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>过薄</translation>
    </message>
    <message>
        <source>use a cell whose arm can tilt the nozzle, or print the paths on the plate</source>
        <translation>使用机械臂可倾斜喷嘴的工作单元，或在打印板上打印路径</translation>
    </message>
    <message>
        <source>use a cell with a larger plate, or slice the part again at a smaller size</source>
        <translation>使用打印板更大的工作单元，或以更小的尺寸重新切片</translation>
    </message>
    <message numerus="yes">
        <source>{share:.2f} of the part ({volume:.3g}) is narrower than the narrowest bead ({bead:.3g}) and stays open, at {places} places, mostly around this point</source>
        <translation>
            <numerusform>零件的 {share:.2f}（{volume:.3g}）窄于最窄挤出线（{bead:.3g}），保持空缺，共 {places} 处，主要在此点周围</numerusform>
        </translation>
    </message>
    <message>
        <source>choose another pattern or another share, or a quality that accepts longer bridges</source>
        <translation>选择另一种图案或另一比例，或接受更长桥接的质量等级</translation>
    </message>
    <message>
        <source>its lines branch below skins that would sag between them</source>
        <translation>其线条在表皮之下分叉，否则表皮会在其间下垂</translation>
    </message>
    <message>
        <source>sparse infill fills {found:.0f} of the interior instead of {asked:.0f}: {reason}</source>
        <translation>稀疏填充填满内部的 {found:.0f}，应为 {asked:.0f}：{reason}</translation>
    </message>
    <message>
        <source>the interior is too small for its lines, or they cannot lie any closer</source>
        <translation>内部太小，容不下其线条，或线条无法更密</translation>
    </message>
    <message>
        <source>Bead width, length that it bridges with a sag of up to 0.2 mm; and so on, in mm. Quality usual and draft accept it. Those of the program&apos;s materials are estimates: replace them by those of a test print.</source>
        <translation>挤出线宽、下垂不超过 0.2 mm 时可桥接的长度；依此类推，单位 mm。质量等级“常规”和“草稿”接受此下垂。程序自带材料的值为估计值：请用试打结果替换。</translation>
    </message>
    <message>
        <source>Maximum distance between waypoints along a tool-path; plain G-code has fewer where beads are straight.</source>
        <translation>沿工具路径的最大路径点间距；普通 G-code 在挤出线为直线处的点较少。</translation>
    </message>
    <message>
        <source>Share of the speed of a wall that overhangs the layer below by that share of its width.</source>
        <translation>壁相对下层悬垂其宽度的该比例时，所用速度的比例。</translation>
    </message>
    <message>
        <source>add supports (`supports=auto`), turn the part, or use planar or curved mode</source>
        <translation>添加支撑（`supports=auto`），转动零件，或使用平面分块或曲面层</translation>
    </message>
    <message>
        <source>bridges with a little sag</source>
        <translation>略有下垂的桥接</translation>
    </message>
    <message>
        <source>choose a plate with a size, or type the number of copies</source>
        <translation>选择有尺寸的打印板，或输入份数</translation>
    </message>
    <message>
        <source>is above 1000 mm: check the unit</source>
        <translation>大于 1000 mm：检查单位</translation>
    </message>
    <message>
        <source>is more than with less overhang</source>
        <translation>大于悬垂较小时的值</translation>
    </message>
    <message>
        <source>is not wider than the bead before it</source>
        <translation>不比前一条挤出线宽</translation>
    </message>
    <message>
        <source>must be a pair of bead width and length</source>
        <translation>必须是挤出线宽与长度的数对</translation>
    </message>
    <message>
        <source>must have four shares, for 25, 50, 75 and 100 % of the width</source>
        <translation>必须有四个比例，对应宽度的 25、50、75 和 100 %</translation>
    </message>
    <message>
        <source>speed of walls, 100 % overhang</source>
        <translation>壁速度，悬垂 100 %</translation>
    </message>
    <message>
        <source>speed of walls, 25 % overhang</source>
        <translation>壁速度，悬垂 25 %</translation>
    </message>
    <message>
        <source>speed of walls, 50 % overhang</source>
        <translation>壁速度，悬垂 50 %</translation>
    </message>
    <message>
        <source>speed of walls, 75 % overhang</source>
        <translation>壁速度，悬垂 75 %</translation>
    </message>
    <message>
        <source>the plate is made as large as the parts need</source>
        <translation>打印板按零件所需大小制作</translation>
    </message>
    <message>
        <source>write the program again, or use smaller cells for the part&apos;s map</source>
        <translation>重新写出程序，或为零件的网格图使用更小的单元格</translation>
    </message>
    <message>
        <source>allow larger facets, or export less detail</source>
        <translation>允许更大的面片，或导出较少的细节</translation>
    </message>
    <message>
        <source>cannot be read: voluta-cad-reader is missing beside this program</source>
        <translation>无法读取：本程序旁缺少 voluta-cad-reader</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>重新复制或导出</translation>
    </message>
    <message>
        <source>export the solid from the CAD program</source>
        <translation>从 CAD 程序导出实体</translation>
    </message>
    <message>
        <source>give it the ending .stl</source>
        <translation>将扩展名改为 .stl</translation>
    </message>
    <message>
        <source>has no solid and no surface</source>
        <translation>没有实体和曲面</translation>
    </message>
    <message>
        <source>has only curves, no solid and no surface</source>
        <translation>只有曲线，没有实体和曲面</translation>
    </message>
    <message>
        <source>is an STL, not a STEP or IGES file</source>
        <translation>是 STL 文件，不是 STEP 或 IGES 文件</translation>
    </message>
    <message>
        <source>is cut short: {lacking}</source>
        <translation>不完整：{lacking}</translation>
    </message>
    <message>
        <source>is damaged: Open CASCADE cannot read it</source>
        <translation>已损坏：Open CASCADE 无法读取</translation>
    </message>
    <message>
        <source>needs more than 4 GB of memory to read</source>
        <translation>读取需要超过 4 GB 内存</translation>
    </message>
    <message>
        <source>not a STEP or IGES file</source>
        <translation>不是 STEP 或 IGES 文件</translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} curves</source>
        <translation>
            <numerusform>已忽略：{n} 条曲线</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>omitted: {n} surfaces without facets</source>
        <translation>
            <numerusform>已忽略：{n} 个没有面片的曲面</numerusform>
        </translation>
    </message>
    <message>
        <source>one or several solids; read by a program of its own</source>
        <translation>一个或多个实体；由单独的程序读取</translation>
    </message>
    <message>
        <source>open the hollow or turn the part; without supports (`supports=none`, `rimSupports=none`) the hollow&apos;s roof is unsupported</source>
        <translation>打开空腔或转动零件；不用支撑时（`supports=none`、`rimSupports=none`）空腔顶部没有支撑</translation>
    </message>
    <message>
        <source>surfaces are read as facets, at most {chord:.3g} off</source>
        <translation>曲面按面片读取，最大偏差 {chord:.3g}</translation>
    </message>
    <message>
        <source>takes longer than {time:.0f} to read</source>
        <translation>读取时间超过 {time:.0f}</translation>
    </message>
    <message>
        <source>the end of a STEP file is missing</source>
        <translation>缺少 STEP 文件的结尾</translation>
    </message>
    <message>
        <source>the last line of an IGES file is missing, or names other numbers of lines</source>
        <translation>IGES 文件的最后一行缺失，或写明的行数不符</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; cannot be a preset&apos;s id</source>
        <translation>“{id}”不能作为预设的标识</translation>
    </message>
    <message>
        <source>&apos;{key}&apos; is not a setting of presets</source>
        <translation>“{key}”不是预设的设置项</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not a list of layers</source>
        <translation>“{text}”不是层列表</translation>
    </message>
    <message>
        <source>Fill of what is meant to be solid: mean along the view, for beads with round edges</source>
        <translation>应为实心部分的填充率：沿视线方向取平均，按圆边焊道计算</translation>
    </message>
    <message>
        <source>Overhang
mm²</source>
        <translation>悬垂
mm²</translation>
    </message>
    <message>
        <source>Unprinted
voxels</source>
        <translation>未打印
体素</translation>
    </message>
    <message>
        <source>a film of {length} cannot be made</source>
        <translation>无法制作长度为 {length} 的影片</translation>
    </message>
    <message>
        <source>a preset &apos;{id}&apos; comes with the program</source>
        <translation>程序自带预设“{id}”</translation>
    </message>
    <message>
        <source>a preset &apos;{label}&apos; comes with the program</source>
        <translation>程序自带预设“{label}”</translation>
    </message>
    <message>
        <source>a preset needs a name</source>
        <translation>预设需要名称</translation>
    </message>
    <message>
        <source>add supports, make sparse infill denser, rotate the part, or choose mode auto</source>
        <translation>添加支撑、加密稀疏填充、旋转零件，或选择自动模式</translation>
    </message>
    <message>
        <source>choose a smaller dovetail, another direction or another plane</source>
        <translation>选择较小的燕尾榫、其他方向或其他平面</translation>
    </message>
    <message>
        <source>choose a smaller pin or another plane</source>
        <translation>选择较小的销或其他平面</translation>
    </message>
    <message>
        <source>choose another folder, or check the space on the disk</source>
        <translation>选择其他文件夹，或检查磁盘空间</translation>
    </message>
    <message>
        <source>drawing the film</source>
        <translation>正在绘制影片</translation>
    </message>
    <message>
        <source>format {format} has no command for {event}</source>
        <translation>格式 {format} 没有用于{event}的命令</translation>
    </message>
    <message>
        <source>give numbers, such as 12, 40</source>
        <translation>请给出数字，例如 12, 40</translation>
    </message>
    <message>
        <source>import the parent first, or name another one</source>
        <translation>先导入父预设，或指定另一个</translation>
    </message>
    <message>
        <source>in their home poses machines {one} and {two} are too close to each other</source>
        <translation>机器 {one} 和 {two} 在各自原位时彼此过近</translation>
    </message>
    <message>
        <source>infill tool</source>
        <translation>填充工具</translation>
    </message>
    <message>
        <source>move the plane into the part</source>
        <translation>将平面移入零件</translation>
    </message>
    <message>
        <source>move them apart, or change a home pose</source>
        <translation>将它们移开，或更改某个原位</translation>
    </message>
    <message>
        <source>must not be blank</source>
        <translation>不能为空</translation>
    </message>
    <message>
        <source>name another parent</source>
        <translation>指定另一个父预设</translation>
    </message>
    <message>
        <source>name it &apos;{id}&apos;</source>
        <translation>将其命名为“{id}”</translation>
    </message>
    <message>
        <source>no platform below the overhang: {area:.3g}</source>
        <translation>悬垂下方没有平台：{area:.3g}</translation>
    </message>
    <message>
        <source>no room in the section for a dovetail of {width}, {height} high</source>
        <translation>截面中放不下宽 {width}、高 {height} 的燕尾榫</translation>
    </message>
    <message>
        <source>no room in the section for a pin of {diameter}, {depth} deep</source>
        <translation>截面中放不下直径 {diameter}、深 {depth} 的销</translation>
    </message>
    <message>
        <source>pauses before layers</source>
        <translation>层前暂停</translation>
    </message>
    <message>
        <source>preset &apos;{id}&apos; is its own parent, through its parents</source>
        <translation>预设“{id}”经其父预设成为自己的父预设</translation>
    </message>
    <message>
        <source>repair the part, or move the plane</source>
        <translation>修复零件，或移动平面</translation>
    </message>
    <message>
        <source>small contact with the plate: {foot:.3g}; uncut, the part has {whole:.3g#}</source>
        <translation>与平台接触面小：{foot:.3g}；未切割时零件为 {whole:.3g#}</translation>
    </message>
    <message>
        <source>support tool</source>
        <translation>支撑工具</translation>
    </message>
    <message>
        <source>the bead below is covered after {time:.1f}, before the minimum layer time of {limit:.1f}; on {length:.0f} of beads in all</source>
        <translation>下方焊道在 {time:.1f} 后即被覆盖，短于最短层时间 {limit:.1f}；总计涉及 {length:.0f} 的焊道</translation>
    </message>
    <message>
        <source>the cutter cuts into the fixture below the block</source>
        <translation>刀具切入毛坯下方的夹具</translation>
    </message>
    <message>
        <source>the film cannot be written</source>
        <translation>无法写入影片</translation>
    </message>
    <message>
        <source>the id &apos;{id}&apos; is not the name of the file</source>
        <translation>标识“{id}”与文件名不符</translation>
    </message>
    <message>
        <source>the joint cannot be cut out of this mesh</source>
        <translation>无法从该网格中切出接头</translation>
    </message>
    <message>
        <source>the parent &apos;{parent}&apos; of preset &apos;{id}&apos; does not exist</source>
        <translation>预设“{id}”的父预设“{parent}”不存在</translation>
    </message>
    <message>
        <source>the plane does not cut the part</source>
        <translation>平面未切到零件</translation>
    </message>
    <message>
        <source>there is a preset &apos;{label}&apos; already</source>
        <translation>已有预设“{label}”</translation>
    </message>
    <message>
        <source>type a name</source>
        <translation>输入名称</translation>
    </message>
    <message>
        <source>unknown preset &apos;{id}&apos;</source>
        <translation>未知预设“{id}”</translation>
    </message>
    <message>
        <source>use a smaller cutter or a smaller stepover, or rotate the part</source>
        <translation>使用更小的刀具或更小的行距，或旋转零件</translation>
    </message>
    <message>
        <source>x,y,z in the part&apos;s file, for example 1,0,0: reports the strength for a load in this direction. Empty: no load.</source>
        <translation>零件文件中的 x,y,z，例如 1,0,0：报告该方向载荷下的强度。留空：无载荷。</translation>
    </message>
    <message>
        <source>the film cannot be written: FFmpeg has no encoder for VP9</source>
        <translation>无法写入影片：FFmpeg 没有 VP9 编码器</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from &apos;{parent}&apos;, which does not exist</source>
        <translation>“{id}”继承自“{parent}”，但后者不存在</translation>
    </message>
    <message>
        <source>&apos;{id}&apos; inherits from itself, through its parents</source>
        <translation>“{id}”经其父项继承自自身</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is incomplete</source>
        <translation>“{text}”不完整</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is not an event of a layer</source>
        <translation>“{text}”不是层事件</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} {number} is out of range</source>
        <translation>“{text}”：{field} {number} 超出范围</translation>
    </message>
    <message>
        <source>At a stop the pendant shows no text: the controller sends it to the sender of the frames, which has to show it.</source>
        <translation>停止时示教器不显示文本：控制器将其发给帧的发送程序，由后者显示。</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>切除</translation>
    </message>
    <message>
        <source>Cylinder along Z</source>
        <translation>沿 Z 的圆柱</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>方向 X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>方向 Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>方向 Z</translation>
    </message>
    <message>
        <source>Flat layers along a direction</source>
        <translation>沿某一方向的平面层</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Height (Z)</source>
        <translation>高度 (Z)</translation>
    </message>
    <message>
        <source>Layers along the surface</source>
        <translation>沿表面的层</translation>
    </message>
    <message>
        <source>Layers around the rest</source>
        <translation>环绕其余部分的层</translation>
    </message>
    <message>
        <source>Layers that turn to a direction</source>
        <translation>转向某一方向的层</translation>
    </message>
    <message>
        <source>Middle X</source>
        <translation>中心 X</translation>
    </message>
    <message>
        <source>Middle Y</source>
        <translation>中心 Y</translation>
    </message>
    <message>
        <source>Middle Z</source>
        <translation>中心 Z</translation>
    </message>
    <message>
        <source>Numbers of layers of the part, separated by commas: before each of them the arm goes beside the part and waits until the operator continues, for example to put in an insert. Then it primes the nozzle there.</source>
        <translation>零件的层号，用逗号分隔：在每个层之前机械臂移到零件旁并等待操作员继续，例如放入嵌件。然后在该处进行喷嘴预挤出。</translation>
    </message>
    <message>
        <source>Own settings</source>
        <translation>自定义设置</translation>
    </message>
    <message>
        <source>Painted surface</source>
        <translation>涂绘表面</translation>
    </message>
    <message>
        <source>Pauses before layers</source>
        <translation>层前暂停</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Range of heights over the plate</source>
        <translation>打印板上方的高度范围</translation>
    </message>
    <message>
        <source>Skin below the upper surface</source>
        <translation>上表面之下的表皮</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Steepest slope (degrees)</source>
        <translation>最大坡度（度）</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>a change of colour</source>
        <translation>换色</translation>
    </message>
    <message>
        <source>a change to extruder {number}</source>
        <translation>切换到挤出机 {number}</translation>
    </message>
    <message>
        <source>a painted fuzzy skin</source>
        <translation>涂绘的绒毛表面</translation>
    </message>
    <message>
        <source>a painted seam</source>
        <translation>涂绘的接缝</translation>
    </message>
    <message>
        <source>a pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>a spiral has no regions</source>
        <translation>螺旋没有区域</translation>
    </message>
    <message>
        <source>a statement of your own</source>
        <translation>自定义语句</translation>
    </message>
    <message>
        <source>a tool changes before a layer, not at a height</source>
        <translation>工具在层之前更换，而不是在某个高度</translation>
    </message>
    <message>
        <source>add it from its file again</source>
        <translation>从其文件重新添加</translation>
    </message>
    <message>
        <source>change the tool where the file was made</source>
        <translation>在生成该文件的程序中更换工具</translation>
    </message>
    <message>
        <source>check what it does on the controller; leave it out of `layerEvents` if you do not need it</source>
        <translation>检查其在控制器上的作用；若不需要，将其从 `layerEvents` 中移除</translation>
    </message>
    <message>
        <source>choose a process without corrections, or remove the regions</source>
        <translation>选择没有修正的工艺，或移除区域</translation>
    </message>
    <message>
        <source>correct the setting; layers are counted for each part</source>
        <translation>更正该设置；层号按每个零件分别计数</translation>
    </message>
    <message>
        <source>custom G-code</source>
        <translation>自定义 G 代码</translation>
    </message>
    <message>
        <source>event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>events before layers</source>
        <translation>层前事件</translation>
    </message>
    <message>
        <source>format {format} has outputs {first} to {last}, not {number}</source>
        <translation>格式 {format} 的输出为 {first} 至 {last}，没有 {number}</translation>
    </message>
    <message>
        <source>give a steeper slope</source>
        <translation>给出更大的坡度</translation>
    </message>
    <message>
        <source>give a tilted direction</source>
        <translation>请给出倾斜的方向</translation>
    </message>
    <message>
        <source>give the lower height first</source>
        <translation>先给出较低的高度</translation>
    </message>
    <message>
        <source>give the number of the layer</source>
        <translation>给出层号</translation>
    </message>
    <message>
        <source>give {field} from {least} to {most}</source>
        <translation>给出 {field}，{least} 至 {most}</translation>
    </message>
    <message>
        <source>height {height}</source>
        <translation>高度 {height}</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>不是 JSON 对象</translation>
    </message>
    <message>
        <source>layers of region {region} turn to a vertical direction</source>
        <translation>区域 {region} 的层转向竖直方向</translation>
    </message>
    <message>
        <source>layers that turn by {angle} within the region are {thin:.2f} to {thick:.2f} thick, outside the limits</source>
        <translation>在区域内转动 {angle} 的层厚 {thin:.2f} 至 {thick:.2f}，超出限制</translation>
    </message>
    <message>
        <source>line {line}: the print pauses before bead {bead} in layer {layer}: {text} ({command})</source>
        <translation>第 {line} 行：打印在层 {layer} 的焊道 {bead} 之前暂停：{text}（{command}）</translation>
    </message>
    <message>
        <source>make it deeper, or use a process with lower layers</source>
        <translation>加大深度，或使用层更薄的工艺</translation>
    </message>
    <message>
        <source>make the region higher or narrower, or turn by less</source>
        <translation>使区域更高或更窄，或减小转动角度</translation>
    </message>
    <message>
        <source>make the region smaller</source>
        <translation>缩小该区域</translation>
    </message>
    <message>
        <source>make the region smaller, or move it</source>
        <translation>缩小该区域，或移动它</translation>
    </message>
    <message>
        <source>make the regions smaller, or move them up</source>
        <translation>缩小区域，或将其上移</translation>
    </message>
    <message>
        <source>mode {mode} prints on the part: it has no regions</source>
        <translation>{mode} 模式在零件上打印：没有区域</translation>
    </message>
    <message>
        <source>move the plane further into the part</source>
        <translation>将平面进一步移入零件</translation>
    </message>
    <message>
        <source>move the plane into a body, or split the part into its bodies</source>
        <translation>将平面移入某个实体，或将零件拆分为各个实体</translation>
    </message>
    <message>
        <source>no change of the tool before layer {layer}: the part has {layers} layers</source>
        <translation>第 {layer} 层前不换工具：零件共 {layers} 层</translation>
    </message>
    <message>
        <source>no {what} before {place} of part {part}: the part has {layers} layers</source>
        <translation>零件 {part} 的{place}之前没有{what}：该零件共 {layers} 层</translation>
    </message>
    <message>
        <source>no {what} before {place}: the print ends with layer {layers}</source>
        <translation>{place}之前没有{what}：打印到第 {layers} 层为止</translation>
    </message>
    <message>
        <source>nobody but you knows what the statement is for</source>
        <translation>只有编写者知道该语句的用途</translation>
    </message>
    <message>
        <source>not used, as they are damaged: {what} (&apos;{member}&apos;): {why}</source>
        <translation>因损坏而未使用：{what}（&apos;{member}&apos;）：{why}</translation>
    </message>
    <message>
        <source>not used: invalid settings of region &apos;{region}&apos; from the file: {settings}</source>
        <translation>未使用：文件中区域 &apos;{region}&apos; 的无效设置：{settings}</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file, which has no settings</source>
        <translation>未使用：文件中没有设置的区域 &apos;{region}&apos;</translation>
    </message>
    <message>
        <source>not used: region &apos;{region}&apos; from the file: its mesh is not closed</source>
        <translation>未使用：文件中的区域 &apos;{region}&apos;：其网格未封闭</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height (&apos;{member}&apos;)</source>
        <translation>未使用：高度范围的设置（&apos;{member}&apos;）</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height of object {number}, which does not exist (&apos;{member}&apos;)</source>
        <translation>未使用：不存在的对象 {number} 的高度范围设置（&apos;{member}&apos;）</translation>
    </message>
    <message>
        <source>not used: settings of ranges of height: the objects of the file are one part</source>
        <translation>未使用：高度范围的设置：文件中的对象是一个零件</translation>
    </message>
    <message>
        <source>not used: settings of region &apos;{region}&apos; from the file without a counterpart: {settings}</source>
        <translation>未使用：文件中区域 &apos;{region}&apos; 没有对应项的设置：{settings}</translation>
    </message>
    <message>
        <source>not used: the range of heights from {from} to {to} in the file, which is empty</source>
        <translation>未使用：文件中从 {from} 到 {to} 的空高度范围</translation>
    </message>
    <message>
        <source>not used: tool {tool} of region &apos;{region}&apos; from the file: the job has {tools}</source>
        <translation>未使用：文件中区域 &apos;{region}&apos; 的工具 {tool}：任务有 {tools} 个</translation>
    </message>
    <message>
        <source>not used: {count} further events at heights (&apos;{member}&apos;)</source>
        <translation>未使用：另外 {count} 个按高度的事件（&apos;{member}&apos;）</translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} further regions of the file</source>
        <translation>
            <numerusform>未使用：文件中另外 {count} 个区域</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops before the first bead, since programs begin with a question</source>
        <translation>
            <numerusform>未使用：第一条焊道之前的 {count} 个停止，因为程序以询问开始</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} (&apos;{member}&apos;)</source>
        <translation>未使用：高度 {height} 处的{event}（&apos;{member}&apos;）</translation>
    </message>
    <message numerus="yes">
        <source>not used: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, from line {line} of {where})</source>
        <translation>
            <numerusform>未使用：&apos;{object}&apos; 的 {count} 个三角形上的{paint}（{attribute}，从 {where} 的第 {line} 行起）</numerusform>
        </translation>
    </message>
    <message>
        <source>output {number} is used by the program itself</source>
        <translation>输出 {number} 由程序自身使用</translation>
    </message>
    <message>
        <source>paint it in the window, or give a body</source>
        <translation>在窗口中涂绘，或给出一个实体</translation>
    </message>
    <message>
        <source>painted colours</source>
        <translation>涂绘的颜色</translation>
    </message>
    <message>
        <source>painted supports</source>
        <translation>涂绘的支撑</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>presets hold settings of layers, beads, tool-paths, cooling and quality</source>
        <translation>预设包含层、焊道、工具路径、冷却和质量等级的设置</translation>
    </message>
    <message>
        <source>process {process} corrects sizes: layers of regions have no corrections</source>
        <translation>工艺 {process} 修正尺寸：区域的层没有修正</translation>
    </message>
    <message>
        <source>region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: its mesh is open, and was closed</source>
        <translation>文件中的区域 &apos;{region}&apos;：其网格未封闭，已将其封闭</translation>
    </message>
    <message>
        <source>region &apos;{region}&apos; from the file: the skin is as thick as the larger one of top and bottom</source>
        <translation>文件中的区域 &apos;{region}&apos;：表层厚度取顶部和底部中的较大者</translation>
    </message>
    <message numerus="yes">
        <source>region &apos;{region}&apos; from the file: {count} settings</source>
        <translation>
            <numerusform>文件中的区域 &apos;{region}&apos;：{count} 个设置</numerusform>
        </translation>
    </message>
    <message>
        <source>region &apos;{text}&apos; has no painted surface</source>
        <translation>区域“{text}”没有涂绘表面</translation>
    </message>
    <message>
        <source>region &apos;{text}&apos;: &apos;{setting}&apos; is no setting</source>
        <translation>区域“{text}”：“{setting}”不是设置项</translation>
    </message>
    <message>
        <source>region {region} cannot be separated from the part: one of them is not closed or intersects itself</source>
        <translation>区域 {region} 无法从零件中分离：二者之一未封闭或自相交</translation>
    </message>
    <message>
        <source>region {region} contains the whole part: nothing carries its layers</source>
        <translation>区域 {region} 包含整个零件：没有东西承载其层</translation>
    </message>
    <message>
        <source>region {region} cuts away the whole part</source>
        <translation>区域 {region} 切除了整个零件</translation>
    </message>
    <message>
        <source>region {region} follows no surface: it has no layers of its own</source>
        <translation>区域 {region} 不跟随任何表面：没有自己的层</translation>
    </message>
    <message>
        <source>region {region} has no mesh</source>
        <translation>区域 {region} 没有网格</translation>
    </message>
    <message>
        <source>region {region} is thinner than the lowest layer ({least})</source>
        <translation>区域 {region} 比最低的层更薄（{least}）</translation>
    </message>
    <message>
        <source>region {region}: no face of the part is as flat as that</source>
        <translation>区域 {region}：零件没有如此平缓的面</translation>
    </message>
    <message>
        <source>regions take away what the part stands on: the rest of it begins {gap:.3g} above its place</source>
        <translation>区域去掉了零件站立的部分：其余部分从其位置上方 {gap:.3g} 处开始</translation>
    </message>
    <message>
        <source>remove the regions, or choose another mode</source>
        <translation>移除区域，或选择其他模式</translation>
    </message>
    <message>
        <source>remove the regions, or plan layers of the part (`givenToolPaths=false`)</source>
        <translation>移除区域，或规划零件的层 (`givenToolPaths=false`)</translation>
    </message>
    <message>
        <source>remove the regions, or set spiral to false</source>
        <translation>移除区域，或将 spiral 设为 false</translation>
    </message>
    <message>
        <source>repair the part, or move the region a little</source>
        <translation>修复零件，或稍微移动该区域</translation>
    </message>
    <message>
        <source>setting an output</source>
        <translation>设置输出</translation>
    </message>
    <message>
        <source>settings of a region: {keys}</source>
        <translation>区域的设置：{keys}</translation>
    </message>
    <message>
        <source>template G-code</source>
        <translation>模板 G 代码</translation>
    </message>
    <message>
        <source>the body of a region is not closed</source>
        <translation>区域的实体未封闭</translation>
    </message>
    <message>
        <source>the plane leaves a slab of {thickness} at {place}, thinner than a layer</source>
        <translation>平面在 {place} 处留下厚 {thickness} 的薄片，比一层还薄</translation>
    </message>
    <message>
        <source>the plane passes between the bodies of the part and cuts none</source>
        <translation>平面从零件的各实体之间穿过，未切到任何一个</translation>
    </message>
    <message>
        <source>the range of heights from {from} to {to} is empty</source>
        <translation>从 {from} 到 {to} 的高度范围为空</translation>
    </message>
    <message>
        <source>the statement &apos;{text}&apos; is one of format {wanted}, not of {format}</source>
        <translation>语句“{text}”属于格式 {wanted}，而非 {format}</translation>
    </message>
    <message>
        <source>the tool-paths of a file have no regions</source>
        <translation>文件的工具路径没有区域</translation>
    </message>
    <message>
        <source>the tools of a file&apos;s tool-paths are its own: none changes before a layer</source>
        <translation>文件的工具路径使用文件自身的工具：不在层前更换</translation>
    </message>
    <message>
        <source>unknown parameter {key}</source>
        <translation>未知参数 {key}</translation>
    </message>
    <message>
        <source>unknown parent &apos;{id}&apos;</source>
        <translation>未知父项“{id}”</translation>
    </message>
    <message>
        <source>unknown region &apos;{name}&apos;</source>
        <translation>未知区域“{name}”</translation>
    </message>
    <message>
        <source>unknown use &apos;{name}&apos; of a region</source>
        <translation>未知的区域用途“{name}”</translation>
    </message>
    <message>
        <source>unsupported voxels in flat layers: {missed} of {voxels} ({share:.1f}); no layer below carries them</source>
        <translation>平面层中无支承的体素：{voxels} 个中的 {missed} 个（{share:.1f}）；下方没有层承载它们</translation>
    </message>
    <message>
        <source>use &apos;{text}&apos; of a region has no direction</source>
        <translation>区域用途“{text}”没有方向</translation>
    </message>
    <message>
        <source>use another output</source>
        <translation>使用其他输出</translation>
    </message>
    <message>
        <source>write {form}, lengths in mm</source>
        <translation>写 {form}，长度单位 mm</translation>
    </message>
    <message>
        <source>your own statement, which nothing checks: {statement}</source>
        <translation>自定义语句，未经任何检查：{statement}</translation>
    </message>
    <message>
        <source>{key} is a setting of the part, not of a region</source>
        <translation>{key} 是零件的设置，不是区域的设置</translation>
    </message>
    <message>
        <source>{name}; changed: {settings}</source>
        <translation>{name}；已更改：{settings}</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>&apos;{code}&apos; is missing before the line: it would run ahead of the arm</source>
        <translation>该行之前缺少 &apos;{code}&apos;：它会先于机械臂执行</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; has characters that controllers do not know</source>
        <translation>&apos;{text}&apos; 含有控制器不认识的字符</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: a pause&apos;s text has at most {limit} characters</source>
        <translation>&apos;{text}&apos;：暂停文本最多 {limit} 个字符</translation>
    </message>
    <message>
        <source>a stop shows no text</source>
        <translation>停止时没有显示文本</translation>
    </message>
    <message>
        <source>shorten the text</source>
        <translation>缩短文本</translation>
    </message>
    <message>
        <source>write English letters, digits and signs; in a pause&apos;s text no quotes</source>
        <translation>使用英文字母、数字和符号；暂停文本中不要用引号</translation>
    </message>
    <message numerus="yes">
        <source>{waits} pauses and waits above the part: the arm reaches no place beside it, nothing is primed, and material may drip on the part</source>
        <translation>
            <numerusform>在零件上方有 {waits} 次暂停或等待：机械臂到不了零件旁的位置，不会预挤出，材料可能滴落到零件上</numerusform>
        </translation>
    </message>
    <message>
        <source>a text is shown without a stop</source>
        <translation>显示了文本但没有停止</translation>
    </message>
    <message>
        <source>a module that reads G-code has no commands for stops, waits, tools and outputs</source>
        <translation>读取 G 代码的模块没有停止、等待、工具和输出的命令</translation>
    </message>
    <message>
        <source>give the cell a place for purges or a home pose beside the plate, or move the part on the plate</source>
        <translation>为工作单元指定清料处 或打印板旁的原位，或在打印板上移动零件</translation>
    </message>
    <message>
        <source>&apos;Close&apos; is missing behind the text</source>
        <translation>文本之后缺少“Close”</translation>
    </message>
    <message>
        <source>&apos;Close&apos; without its &apos;Open&apos; before it</source>
        <translation>“Close”之前没有对应的“Open”</translation>
    </message>
    <message>
        <source>&apos;{name}&apos; between PVTEnter and PVTExit</source>
        <translation>“{name}”位于 PVTEnter 和 PVTExit 之间</translation>
    </message>
    <message>
        <source>&apos;{part}&apos; is no point of a curve</source>
        <translation>“{part}”不是曲线的点</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement &apos;{text}&apos; {effect}</source>
        <translation>语句“{text}”中的“{word}”{effect}</translation>
    </message>
    <message>
        <source>&apos;{word}&apos; in the statement before {place}, &apos;{text}&apos;, {effect}</source>
        <translation>{place}之前的语句“{text}”中的“{word}”{effect}</translation>
    </message>
    <message>
        <source>Across
layers MPa</source>
        <translation>跨层应力
MPa</translation>
    </message>
    <message>
        <source>Add a skin</source>
        <translation>添加表皮</translation>
    </message>
    <message>
        <source>Along
stress %</source>
        <translation>沿应力
方向 %</translation>
    </message>
    <message>
        <source>Break-away columns below overhangs beyond the overhang angle, in mode curved below voxels that growth would miss. A region without them blocks them.</source>
        <translation>在超过悬垂角的悬垂下加可掰除的立柱；curved 模式下加在生长会遗漏的体素之下。不带立柱的区域会阻止它们。</translation>
    </message>
    <message>
        <source>Deflec-
tion mm</source>
        <translation>变形
mm</translation>
    </message>
    <message>
        <source>Factor of the speed of the part&apos;s beads, within the flow of the extruder and the speed of bridges.</source>
        <translation>零件挤出线速度的系数，不超出挤出机的流量和桥接速度。</translation>
    </message>
    <message>
        <source>For infill along a field: a direction x,y,z, or x,y,z,dx,dy,dz in mm on the plate, separated by spaces or lines, or a file of them. Empty: along the stress between regions that hold the part and regions with a force.</source>
        <translation>用于沿场的填充：一个方向 x,y,z，或打印板上以 mm 为单位的 x,y,z,dx,dy,dz，用空格或换行分隔，或含有它们的文件。留空：沿固定零件的区域与受力区域之间的应力方向。</translation>
    </message>
    <message>
        <source>Force X</source>
        <translation>力 X</translation>
    </message>
    <message>
        <source>Force Y</source>
        <translation>力 Y</translation>
    </message>
    <message>
        <source>Force Z</source>
        <translation>力 Z</translation>
    </message>
    <message>
        <source>Force on the part</source>
        <translation>作用于零件的力</translation>
    </message>
    <message>
        <source>Held under load</source>
        <translation>受载时固定</translation>
    </message>
    <message>
        <source>In a region: closed beads that pass through it begin there, or never do if they can begin elsewhere.</source>
        <translation>在区域中：穿过该区域的闭合挤出线从此处开始；或者，只要能从别处开始，就绝不从此处开始。</translation>
    </message>
    <message>
        <source>In flat layers the region reaches half of it into the part around it, in every other layer the part reaches as far into the region, so that both hold each other.</source>
        <translation>在平面层中，区域向周围零件伸入此值的一半；每隔一层则由零件向区域伸入同样的距离，使两者相互咬合。</translation>
    </message>
    <message>
        <source>Region {number}</source>
        <translation>区域 {number}</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements, which nothing checks.</source>
        <translation>除自定义语句外可安全运行；自定义语句未经任何检查。</translation>
    </message>
    <message>
        <source>Three curved layers along the upper surface, over the flat ones</source>
        <translation>在平面层之上，沿上表面加三个曲面层</translation>
    </message>
    <message>
        <source>What happens before layers of the part, separated by semicolons. Each begins with a layer (12) or a height in mm (z5.5): 12 pause TEXT; 20 wait SECONDS; 30 output NUMBER on; 35 photo OUTPUT SECONDS; 40 tool NUMBER; 50 statement FORMAT LINE.</source>
        <translation>零件的层之前发生的事件，用分号分隔。每项以层号 (12) 或以 mm 为单位的高度 (z5.5) 开头：12 pause 文本; 20 wait 秒数; 30 output 编号 on; 35 photo 输出编号 秒数; 40 tool 编号; 50 statement 格式 语句行。</translation>
    </message>
    <message>
        <source>a line for a wait differs from the line before in its last number</source>
        <translation>等待行与前一行的最后一个数不同</translation>
    </message>
    <message>
        <source>a region with a force contains nothing of the part that is held</source>
        <translation>受力区域不含被固定零件的任何部分</translation>
    </message>
    <message>
        <source>a skin of layers along the surface has none</source>
        <translation>由沿表面的层构成的表皮没有此项</translation>
    </message>
    <message>
        <source>a statement of your own sets &apos;{name}&apos;, which the program uses itself</source>
        <translation>自定义语句设置了程序自身使用的“{name}”</translation>
    </message>
    <message>
        <source>add a second region of that shape for its settings</source>
        <translation>为其设置再添加一个同样形状的区域</translation>
    </message>
    <message>
        <source>along a field</source>
        <translation>沿场</translation>
    </message>
    <message>
        <source>always</source>
        <translation>始终</translation>
    </message>
    <message>
        <source>changes a temperature</source>
        <translation>会更改温度</translation>
    </message>
    <message>
        <source>changes the extruder</source>
        <translation>会更改挤出机</translation>
    </message>
    <message>
        <source>changes the order of the program&apos;s lines</source>
        <translation>会更改程序各行的执行顺序</translation>
    </message>
    <message>
        <source>changes the origin, the tool or the units</source>
        <translation>会更改原点、工具或单位</translation>
    </message>
    <message>
        <source>deflection under the forces</source>
        <translation>受力变形</translation>
    </message>
    <message>
        <source>field of the infill</source>
        <translation>填充方向场</translation>
    </message>
    <message>
        <source>found no equilibrium of the part under its load</source>
        <translation>未找到零件在其载荷下的平衡</translation>
    </message>
    <message>
        <source>from the file: {event} at a height of {height}</source>
        <translation>来自文件：高度 {height} 处的{event}</translation>
    </message>
    <message>
        <source>give a direction x,y,z or samples x,y,z,dx,dy,dz, or the part regions that hold it and regions with a force</source>
        <translation>给出方向 x,y,z 或采样点 x,y,z,dx,dy,dz，或为零件添加固定它的区域和受力区域</translation>
    </message>
    <message>
        <source>give a region where the part is fixed the use &apos;hold&apos;</source>
        <translation>将零件固定处的区域用途设为“hold”</translation>
    </message>
    <message>
        <source>give it as a skin or a painted surface, or use it for settings</source>
        <translation>将其指定为表皮或涂绘表面，或用于设置</translation>
    </message>
    <message>
        <source>give, for example, 12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript LINE</source>
        <translation>例如给出 12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2; 50 statement urscript 语句行</translation>
    </message>
    <message>
        <source>hold the part in more places</source>
        <translation>在更多位置固定零件</translation>
    </message>
    <message>
        <source>infill along the stress</source>
        <translation>沿应力方向的填充</translation>
    </message>
    <message>
        <source>interlock of a region</source>
        <translation>区域的咬合</translation>
    </message>
    <message>
        <source>is above &apos;alongMPa&apos;</source>
        <translation>大于“alongMPa”</translation>
    </message>
    <message>
        <source>is above {limit}</source>
        <translation>大于 {limit}</translation>
    </message>
    <message>
        <source>leave it out: the plan moves the arm</source>
        <translation>将其去掉：机械臂由规划移动</translation>
    </message>
    <message>
        <source>machine {machine} is {verdict}: {reason}</source>
        <translation>机器 {machine} {verdict}：{reason}</translation>
    </message>
    <message>
        <source>move it into the part, paint it, or remove it</source>
        <translation>将其移入零件、涂绘或移除</translation>
    </message>
    <message>
        <source>move it onto the part, or make it larger</source>
        <translation>将其移到零件上，或将其放大</translation>
    </message>
    <message>
        <source>move them onto the part, or make them larger</source>
        <translation>将它们移到零件上，或将它们放大</translation>
    </message>
    <message>
        <source>moves the arm, or changes how it moves</source>
        <translation>会移动机械臂，或更改其运动方式</translation>
    </message>
    <message>
        <source>never</source>
        <translation>从不</translation>
    </message>
    <message numerus="yes">
        <source>not used, as it is damaged: {paint} on {count} triangles of &apos;{object}&apos; ({attribute}, {where})</source>
        <translation>
            <numerusform>因损坏而未使用：“{object}”的 {count} 个三角形上的{paint}（{attribute}，{where}）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>not used: {count} stops behind the last bead, where the print is done</source>
        <translation>
            <numerusform>未使用：最后一条挤出线之后的 {count} 个停止，此时打印已完成</numerusform>
        </translation>
    </message>
    <message>
        <source>not used: {event} at a height of {height} in the file: the part ends at {top}</source>
        <translation>未使用：文件中高度 {height} 处的{event}：零件到 {top} 为止</translation>
    </message>
    <message>
        <source>nothing of the part is within the regions that hold it</source>
        <translation>固定零件的区域内没有零件的任何部分</translation>
    </message>
    <message>
        <source>paint whole faces</source>
        <translation>涂绘整个面</translation>
    </message>
    <message>
        <source>put it into a routine on the controller, and call that</source>
        <translation>将其放入控制器上的例程，并调用该例程</translation>
    </message>
    <message>
        <source>region {region} asks for supports, which mode {mode} does not have</source>
        <translation>区域 {region} 要求支撑，而 {mode} 模式没有支撑</translation>
    </message>
    <message>
        <source>region {region} asks for supports: its own layers have none</source>
        <translation>区域 {region} 要求支撑：其自己的层没有支撑</translation>
    </message>
    <message>
        <source>region {region} carries the load: it has no settings</source>
        <translation>区域 {region} 用于载荷：没有设置</translation>
    </message>
    <message>
        <source>region {region} is outside the part, behind later regions, or not painted: it has no effect</source>
        <translation>区域 {region} 在零件之外、被后面的区域覆盖，或未涂绘：不起作用</translation>
    </message>
    <message>
        <source>region {region}: half of no face of the part is painted</source>
        <translation>区域 {region}：零件没有任何一个面涂绘过半</translation>
    </message>
    <message>
        <source>safe to run but for its own statements, which nothing checks</source>
        <translation>除其自定义语句外可安全运行，而这些语句未经任何检查</translation>
    </message>
    <message>
        <source>safe to run, but does not print its part as asked</source>
        <translation>可安全运行，但不能按要求打印其零件</translation>
    </message>
    <message>
        <source>seam here</source>
        <translation>此处接缝</translation>
    </message>
    <message>
        <source>set `supports=none` for the region, or choose another mode</source>
        <translation>为该区域设置 `supports=none`，或选择其他模式</translation>
    </message>
    <message>
        <source>set it in the cell before the program starts</source>
        <translation>在程序启动之前，在工作单元中设置</translation>
    </message>
    <message>
        <source>set it in the process</source>
        <translation>在工艺中设置</translation>
    </message>
    <message>
        <source>set the temperatures of the material</source>
        <translation>设置材料的温度</translation>
    </message>
    <message>
        <source>sets an output</source>
        <translation>会设置输出</translation>
    </message>
    <message>
        <source>speed factor</source>
        <translation>速度系数</translation>
    </message>
    <message>
        <source>stops or ends the program</source>
        <translation>会停止或结束程序</translation>
    </message>
    <message>
        <source>tension across layers</source>
        <translation>跨层拉应力</translation>
    </message>
    <message>
        <source>there are regions with a force, but none that holds the part</source>
        <translation>有受力区域，但没有固定零件的区域</translation>
    </message>
    <message>
        <source>there is no field of directions for the infill</source>
        <translation>没有用于填充的方向场</translation>
    </message>
    <message>
        <source>under all overhangs</source>
        <translation>所有悬垂之下</translation>
    </message>
    <message>
        <source>use another name</source>
        <translation>使用其他名称</translation>
    </message>
    <message>
        <source>{share:.0f} of the surface are gentle slopes with steps of {mean:.2g} on average</source>
        <translation>表面的 {share:.0f} 为缓坡，台阶平均 {mean:.2g}</translation>
    </message>
    <message>
        <source>a force acts only where the part is held</source>
        <translation>力只作用在零件被固定之处</translation>
    </message>
    <message>
        <source>infill across the stress</source>
        <translation>填充与应力方向不一致</translation>
    </message>
    <message>
        <source>may do anything: Voluta does not know it</source>
        <translation>作用未知：Voluta 不认识它</translation>
    </message>
    <message>
        <source>move the region with the force away from the one that holds</source>
        <translation>将受力区域移离固定区域</translation>
    </message>
    <message>
        <source>the flow is not 0 while the extruder is off</source>
        <translation>挤出机关闭时流量不为 0</translation>
    </message>
    <message>
        <source>the part has no volume to be loaded</source>
        <translation>零件没有可受力的体积</translation>
    </message>
    <message>
        <source>use a region of its own for the supports, whose use is settings</source>
        <translation>为支撑使用单独的区域，其用途为设置</translation>
    </message>
    <message>
        <source>use an event for it, for example 12 pause Put in the nut</source>
        <translation>请改用事件，例如 12 pause Put in the nut</translation>
    </message>
    <message>
        <source>use an event for it, for example 30 output 3 on</source>
        <translation>请改用事件，例如 30 output 3 on</translation>
    </message>
    <message>
        <source>&apos;{text}&apos; is no direction</source>
        <translation>&apos;{text}&apos; 不是方向</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} &apos;{word}&apos; is not a number</source>
        <translation>&apos;{text}&apos;：{field} &apos;{word}&apos; 不是数字</translation>
    </message>
    <message>
        <source>&apos;{text}&apos;: {field} is no whole number</source>
        <translation>&apos;{text}&apos;：{field} 不是整数</translation>
    </message>
    <message>
        <source>Before layer (0: automatic)</source>
        <translation>在此层之前（0：自动）</translation>
    </message>
    <message>
        <source>Inserted part</source>
        <translation>嵌件</translation>
    </message>
    <message>
        <source>Searches for a better orientation of the part: with the smallest overhanging area, with the fewest voxels missed by growth, along the axes, so that the projections on XY and XZ leave the least area of their bounding rectangles empty (blanks for milling), with the smallest overhanging area after the part is cut into pieces (mode planar), or with the least tension across the layers under the load of its regions.</source>
        <translation>搜索更好的零件朝向：悬垂面积最小；生长遗漏的体素最少；沿坐标轴，使 XY 和 XZ 投影在其外接矩形内的空余面积最小（用于铣削毛坯）；零件切成分块后悬垂面积最小（平面分块，planar 模式）；或在其区域的载荷下跨层拉应力最小。</translation>
    </message>
    <message>
        <source>`orient=leastTension` needs a region that pushes the part</source>
        <translation>`orient=leastTension` 需要一个对零件施力的区域</translation>
    </message>
    <message>
        <source>add a statement for {format} at that place, or use {formats}</source>
        <translation>在该处添加用于 {format} 的语句，或使用 {formats}</translation>
    </message>
    <message>
        <source>beads lie above its place before the print pauses</source>
        <translation>打印暂停之前其位置上方已有挤出线</translation>
    </message>
    <message>
        <source>beads lie in its place</source>
        <translation>其位置上有挤出线</translation>
    </message>
    <message>
        <source>figures</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>found no equilibrium of the beads</source>
        <translation>未找到挤出线的平衡</translation>
    </message>
    <message>
        <source>give forces that do not cancel each other</source>
        <translation>给出不会相互抵消的力</translation>
    </message>
    <message>
        <source>give regions with the uses &apos;hold&apos; and &apos;load&apos;</source>
        <translation>给出用途为 &apos;hold&apos; 和 &apos;load&apos; 的区域</translation>
    </message>
    <message>
        <source>give three numbers, x,y,z, of which one is not 0</source>
        <translation>给出三个数 x,y,z，其中至少一个不为 0</translation>
    </message>
    <message>
        <source>inserted part</source>
        <translation>嵌件</translation>
    </message>
    <message>
        <source>it is narrower than half a bead of {width}</source>
        <translation>窄于半条宽 {width} 的挤出线</translation>
    </message>
    <message>
        <source>it is too thin for a layer of its own</source>
        <translation>过薄，容不下自己的层</translation>
    </message>
    <message>
        <source>it is too thin to meet a layer</source>
        <translation>过薄，碰不到任何层</translation>
    </message>
    <message>
        <source>it stands above the first layer after it, so the head keeps away from it</source>
        <translation>它高出其后的第一层，因此打印头会避开它</translation>
    </message>
    <message>
        <source>its interlock of {width} reaches through it in {crossed} of {layers} layers</source>
        <translation>其 {width} 的咬合在 {layers} 层中的 {crossed} 层贯穿了它</translation>
    </message>
    <message>
        <source>later regions hold in all of it</source>
        <translation>其中处处以后面的区域为准</translation>
    </message>
    <message>
        <source>layers along given planes have no supports: those asked for are left out</source>
        <translation>沿给定平面的层没有支撑：所要求的支撑被省略</translation>
    </message>
    <message>
        <source>least tension across layers</source>
        <translation>跨层拉应力最小</translation>
    </message>
    <message>
        <source>make it larger, or the layers thinner</source>
        <translation>将其加大，或使层更薄</translation>
    </message>
    <message>
        <source>make it wider, or use a finer nozzle</source>
        <translation>将其加宽，或使用更细的喷嘴</translation>
    </message>
    <message>
        <source>material {material} states no elasticity</source>
        <translation>材料 {material} 未说明弹性</translation>
    </message>
    <message>
        <source>move it down the list of regions</source>
        <translation>将其在区域列表中下移</translation>
    </message>
    <message>
        <source>no bead is under stress</source>
        <translation>没有受应力的挤出线</translation>
    </message>
    <message>
        <source>no effect of region {region}: {reason}</source>
        <translation>区域 {region} 不起作用：{reason}</translation>
    </message>
    <message>
        <source>nothing is below it when the print pauses</source>
        <translation>打印暂停时其下方没有任何东西</translation>
    </message>
    <message>
        <source>nothing is printed after it: the print does not pause for it</source>
        <translation>其后不再打印任何东西：打印不会为它暂停</translation>
    </message>
    <message>
        <source>remove `layerPlanes`, or set `supports=none`</source>
        <translation>移除 `layerPlanes`，或设置 `supports=none`</translation>
    </message>
    <message>
        <source>run it on the controller if the rest needs it</source>
        <translation>若剩余部分需要它，在控制器上运行它</translation>
    </message>
    <message>
        <source>set a smaller `interlockMm`, or make the region larger</source>
        <translation>将 `interlockMm` 设得更小，或将区域加大</translation>
    </message>
    <message>
        <source>stiffness and tensions</source>
        <translation>刚度和拉应力</translation>
    </message>
    <message>
        <source>tape {process} or the plastic around it states no elasticity</source>
        <translation>纤维带 {process} 或其周围的塑料未说明弹性</translation>
    </message>
    <message numerus="yes">
        <source>the field is perpendicular to {patches} patches of the layers, filled with straight lines</source>
        <translation>
            <numerusform>该场垂直于层的 {patches} 个面块，这些面块以直线填充</numerusform>
        </translation>
    </message>
    <message>
        <source>the infill is not along a field</source>
        <translation>填充不是沿场的</translation>
    </message>
    <message>
        <source>the infill of region {region} is not along a field</source>
        <translation>区域 {region} 的填充不是沿场的</translation>
    </message>
    <message>
        <source>the inserted part {insert} does not fit: {reason}</source>
        <translation>嵌件 {insert} 不合适：{reason}</translation>
    </message>
    <message>
        <source>the part was turned by {angle:.0f} about ({x}, {y}, {z}): tension across its layers {tension:.2g} MPa instead of {tensionBefore:.2g}, overhang {overhang:.0f} instead of {overhangBefore:.0f#}</source>
        <translation>零件绕 ({x}, {y}, {z}) 转动了 {angle:.0f}：跨层拉应力 {tension:.2g} MPa，原为 {tensionBefore:.2g}；悬垂 {overhang:.0f}，原为 {overhangBefore:.0f#}</translation>
    </message>
    <message>
        <source>the rest does not run your statement before its beginning: {statement}</source>
        <translation>剩余部分不执行其起点之前的自定义语句：{statement}</translation>
    </message>
    <message>
        <source>turn the part, or choose another field or infill</source>
        <translation>转动零件，或选择其他场或填充</translation>
    </message>
    <message>
        <source>turn the part, or let the region have supports if the overhang sags</source>
        <translation>转动零件，或在悬垂下垂时允许该区域有支撑</translation>
    </message>
    <message>
        <source>unknown {figures} under the forces: {reason}</source>
        <translation>受力下的{figures}未知：{reason}</translation>
    </message>
    <message>
        <source>{area:.3g} overhangs by more than {angle} where regions block supports; here is most of it</source>
        <translation>在区域阻止支撑处，{area:.3g} 悬垂超过 {angle}；大部分在此处</translation>
    </message>
    <message>
        <source>give the material its elasticity</source>
        <translation>为该材料给出弹性</translation>
    </message>
    <message>
        <source>give the modulus and the share of its fibres, and the elasticity of the plastic</source>
        <translation>给出其纤维的模量和占比，以及塑料的弹性</translation>
    </message>
    <message>
        <source>it is thinner than a layer, which leaves no room for it</source>
        <translation>它比一层还薄，没有为它留出空间</translation>
    </message>
    <message>
        <source>it reaches below the plate</source>
        <translation>它伸到平台以下</translation>
    </message>
    <message>
        <source>it takes the place of {other}</source>
        <translation>它占据了 {other} 的位置</translation>
    </message>
    <message>
        <source>move its region on the Prepare page</source>
        <translation>在“准备”页移动其区域</translation>
    </message>
    <message>
        <source>move its region, or choose the layer before which it is put in</source>
        <translation>移动其区域，或选择在哪一层之前放入</translation>
    </message>
    <message>
        <source>no effect of {key}: {reason}</source>
        <translation>{key} 不起作用：{reason}</translation>
    </message>
    <message>
        <source>set `infill=field`, or remove the field</source>
        <translation>设置 `infill=field`，或移除该场</translation>
    </message>
</context>
<context>
    <name>EventMarks</name>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Pause: %1</source>
        <translation>暂停：%1</translation>
    </message>
    <message>
        <source>Wait: %1 s</source>
        <translation>等待：%1 s</translation>
    </message>
    <message>
        <source>Output %1 on</source>
        <translation>输出 %1 开</translation>
    </message>
    <message>
        <source>Output %1 off</source>
        <translation>输出 %1 关</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>工具 %1</translation>
    </message>
    <message>
        <source>Before layer %1: %2</source>
        <translation>第 %1 层前：%2</translation>
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
        <translation>喷嘴尖端半径</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>锥角</translation>
    </message>
    <message>
        <source>Cone height</source>
        <translation>锥体高度</translation>
    </message>
    <message>
        <source>Block width</source>
        <translation>块体宽度</translation>
    </message>
    <message>
        <source>Block height</source>
        <translation>块体高度</translation>
    </message>
</context>
<context>
    <name>LayerEvents</name>
    <message>
        <source>The next plan pauses before layer %1.</source>
        <translation>下次规划会在第 %1 层前暂停。</translation>
    </message>
    <message>
        <source>The next plan does not pause before layer %1.</source>
        <translation>下次规划不会在第 %1 层前暂停。</translation>
    </message>
    <message>
        <source>The next plan has the event before layer %1.</source>
        <translation>下次规划将包含第 %1 层前的事件。</translation>
    </message>
</context>
<context>
    <name>LegendFigures</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>重量</translation>
    </message>
    <message>
        <source>Travel and waits</source>
        <translation>空程与等待</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>全部设置</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>All findings</source>
        <translation>全部检查结果</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>检查结果</translation>
    </message>
    <message>
        <source>what would help</source>
        <translation>解决办法</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Algorithms</source>
        <translation>算法</translation>
    </message>
</context>
<context>
    <name>MillForm</name>
    <message>
        <source>Cutter diameter</source>
        <translation>铣刀直径</translation>
    </message>
    <message>
        <source>The cutter has a round end</source>
        <translation>球头铣刀</translation>
    </message>
    <message>
        <source>0: side load of the material; less leaves lower ridges</source>
        <translation>0：材料的侧吃刀量；值越小残脊越低</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>按材料</translation>
    </message>
    <message>
        <source>Roughing depth</source>
        <translation>粗加工深度</translation>
    </message>
    <message>
        <source>Depth of one pass that stays above the part</source>
        <translation>留在零件之上的一次走刀的深度</translation>
    </message>
    <message>
        <source>Across the lines; more than the cutter&apos;s diameter</source>
        <translation>垂直于行的方向；大于铣刀直径</translation>
    </message>
    <message>
        <source>Along the lines, with the ends that hold the block; more than the cutter&apos;s diameter</source>
        <translation>沿行的方向，含夹持毛坯的两端；大于铣刀直径</translation>
    </message>
    <message>
        <source>Thickness that is milled away over the whole part</source>
        <translation>在整个零件上铣去的厚度</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>安全高度</translation>
    </message>
    <message>
        <source>Height of rapid moves above the block</source>
        <translation>快速移动高出毛坯的高度</translation>
    </message>
    <message>
        <source>Of the contour, at the part&apos;s lower end along y; cut by hand</source>
        <translation>轮廓上、零件沿 y 的下端；手工切断</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Stock beyond the part, y</source>
        <translation>毛坯超出零件，y</translation>
    </message>
    <message>
        <source>Stock beyond the part, x</source>
        <translation>毛坯超出零件，x</translation>
    </message>
    <message>
        <source>Stock above and below</source>
        <translation>上下毛坯余量</translation>
    </message>
    <message>
        <source>Holding tab</source>
        <translation>固定桥</translation>
    </message>
</context>
<context>
    <name>MillPicture</name>
    <message>
        <source>Block</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>Rapid moves</source>
        <translation>快速移动</translation>
    </message>
    <message>
        <source>Side A, roughing</source>
        <translation>A 面，粗加工</translation>
    </message>
    <message>
        <source>Side A, finishing</source>
        <translation>A 面，精加工</translation>
    </message>
    <message>
        <source>Side B, roughing</source>
        <translation>B 面，粗加工</translation>
    </message>
    <message>
        <source>Side B, finishing</source>
        <translation>B 面，精加工</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>轮廓</translation>
    </message>
</context>
<context>
    <name>ModeSwitch</name>
    <message>
        <source>This way of building does not support that platform.</source>
        <translation>此构建方式不支持该平台。</translation>
    </message>
    <message>
        <source>This way of building places the part itself: the search for an orientation does not apply.</source>
        <translation>此构建方式自行放置零件：朝向搜索不适用。</translation>
    </message>
    <message>
        <source>This way of building needs the scale as a number.</source>
        <translation>此构建方式需要以数字表示的比例。</translation>
    </message>
    <message>
        <source>The platform file %1 is missing.</source>
        <translation>缺少平台文件 %1。</translation>
    </message>
    <message>
        <source>This way of building needs a cell with a rotating rod.</source>
        <translation>此构建方式需要带旋转芯棒的工作单元。</translation>
    </message>
    <message>
        <source>This cell rotates a rod: this way of building needs one with a plate.</source>
        <translation>此工作单元旋转芯棒：此构建方式需要带打印板的工作单元。</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Range: %1 to %2</source>
        <translation>范围：%1 至 %2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>默认值：%1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>键：%1</translation>
    </message>
</context>
<context>
    <name>PresetBar</name>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>D&amp;iscard changes</source>
        <translation>放弃更改(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>重命名(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>删除(&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>比较(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>导入(&amp;M)…</translation>
    </message>
</context>
<context>
    <name>Quote</name>
    <message>
        <source>Quote: %1</source>
        <translation>报价：%1</translation>
    </message>
    <message>
        <source>Price: %1</source>
        <translation>价格：%1</translation>
    </message>
    <message>
        <source>printed in %1, %2 g of material</source>
        <translation>打印时间 %1，材料 %2 g</translation>
    </message>
    <message>
        <source>The price of a material is missing.</source>
        <translation>缺少某种材料的价格。</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>%1, %2 g at %3 per kg: %4</source>
        <translation>%1，%2 g，每 kg %3：%4</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>%1 at %2 per hour: %3</source>
        <translation>%1，每小时 %2：%3</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>利润</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>价格</translation>
    </message>
</context>
<context>
    <name>Resume</name>
    <message>
        <source>Bead %1 of %2</source>
        <translation>挤出线 %1 / %2</translation>
    </message>
</context>
<context>
    <name>SettingWords</name>
    <message>
        <source>quality, resolution, thickness, fine, coarse, detail</source>
        <translation>质量, 层厚, 分辨率, 精细, 粗糙, 细节, quality, layer height</translation>
    </message>
    <message>
        <source>line width, extrusion width, nozzle, bead</source>
        <translation>线宽, 挤出宽度, 走线宽度, 喷嘴, 挤出线, line width</translation>
    </message>
    <message>
        <source>first layer, adhesion, line width, extrusion width</source>
        <translation>首层, 第一层, 附着, 线宽, 挤出宽度, first layer</translation>
    </message>
    <message>
        <source>retract, ooze, stringing, oozing</source>
        <translation>回抽, 回退, 抽丝, 拉丝, 渗料, 漏料, retract, stringing</translation>
    </message>
    <message>
        <source>resolution, point distance, segment length</source>
        <translation>分辨率, 点距, 线段长度, resolution</translation>
    </message>
    <message>
        <source>perimeter, perimeters, shell, shells, outline, contour, strength</source>
        <translation>周长, 外圈, 壁数, 墙, 外壳, 轮廓, 强度, perimeter, shell</translation>
    </message>
    <message>
        <source>fill, pattern, solid, interior</source>
        <translation>填充, 图案, 实心, 内部, infill</translation>
    </message>
    <message>
        <source>fill, percent, solid, hollow, strength, interior</source>
        <translation>填充, 百分比, 密度, 实心, 空心, 强度, 内部, infill</translation>
    </message>
    <message>
        <source>fill, infill, gyroid, honeycomb, grid</source>
        <translation>填充, 填充图案, 螺旋体, 蜂窝, 网格, gyroid, infill</translation>
    </message>
    <message>
        <source>roof, skin, top surface, shell</source>
        <translation>顶面, 顶层, 表皮, 上表面, 外壳, top</translation>
    </message>
    <message>
        <source>floor, skin, bottom surface, shell</source>
        <translation>底面, 底层, 表皮, 下表面, 外壳, bottom</translation>
    </message>
    <message>
        <source>roof, floor, top, bottom, shell</source>
        <translation>顶面, 底面, 顶部, 底部, 外壳, shell</translation>
    </message>
    <message>
        <source>orientation, rotation</source>
        <translation>朝向, 方向, 旋转, orientation</translation>
    </message>
    <message>
        <source>overhang, support, support material, bridge, hanging</source>
        <translation>悬垂, 悬空, 支撑, 支撑材料, 桥接, support, overhang</translation>
    </message>
    <message>
        <source>overhang, support material, hanging, edge</source>
        <translation>悬垂, 悬空, 支撑材料, 边缘, overhang</translation>
    </message>
    <message>
        <source>support, bridge, hanging, tilt</source>
        <translation>支撑, 桥接, 悬空, 倾斜, support</translation>
    </message>
    <message>
        <source>skirt, purge, priming, start line, prime line</source>
        <translation>裙边, 清料, 预挤出, 起始线, 擦料线, skirt, prime line</translation>
    </message>
    <message>
        <source>skirt, purge, start line</source>
        <translation>裙边, 清料, 起始线, skirt</translation>
    </message>
    <message>
        <source>adhesion, skirt, raft, warping, lifting, bed</source>
        <translation>附着, 裙边, 帽檐, 底筏, 翘曲, 翘边, 热床, brim, raft</translation>
    </message>
    <message>
        <source>zipper, start point, z seam, scar</source>
        <translation>接缝, 缝, 起点, Z 缝, 疤痕, z seam</translation>
    </message>
    <message>
        <source>thin, narrow, detail</source>
        <translation>薄, 窄, 细节, thin</translation>
    </message>
    <message>
        <source>vase, spiralize, continuous</source>
        <translation>花瓶, 花瓶模式, 螺旋, 连续, vase, spiralize</translation>
    </message>
    <message>
        <source>vase</source>
        <translation>花瓶, vase</translation>
    </message>
    <message>
        <source>cooling, fan, temperature, overheating</source>
        <translation>冷却, 风扇, 温度, 过热, cooling, fan</translation>
    </message>
    <message>
        <source>cooling, temperature, fan, pause, wait, overheating</source>
        <translation>冷却, 温度, 风扇, 暂停, 等待, 过热, cooling</translation>
    </message>
    <message>
        <source>temperature, adhesion, cold joint, interlayer</source>
        <translation>温度, 附着, 冷接, 层间, 层间粘合, interlayer</translation>
    </message>
    <message>
        <source>strength, force, stress</source>
        <translation>强度, 力, 应力, strength</translation>
    </message>
    <message>
        <source>perimeter, feed rate, velocity</source>
        <translation>周长, 外壁, 内壁, 进给速度, 速度, feed rate</translation>
    </message>
    <message>
        <source>fill, feed rate, velocity</source>
        <translation>填充, 进给速度, 速度, infill, feed rate</translation>
    </message>
    <message>
        <source>overhang, feed rate, velocity</source>
        <translation>悬垂, 悬空, 进给速度, 速度, feed rate</translation>
    </message>
    <message>
        <source>adhesion, feed rate, velocity, bed</source>
        <translation>附着, 进给速度, 速度, 热床, feed rate</translation>
    </message>
    <message>
        <source>z hop, travel, retract, hop</source>
        <translation>z 抬升, 空驶, 空移, 回抽, z hop</translation>
    </message>
    <message>
        <source>stringing, ooze, seam</source>
        <translation>拉丝, 渗料, 接缝, stringing</translation>
    </message>
    <message>
        <source>tool orientation, spin</source>
        <translation>工具姿态, 自转, 旋转, spin</translation>
    </message>
    <message>
        <source>tool orientation, angle</source>
        <translation>工具姿态, 角度, 倾斜</translation>
    </message>
    <message>
        <source>collision, distance, safety, robot</source>
        <translation>碰撞, 距离, 间隙, 安全, 机器人, collision</translation>
    </message>
    <message>
        <source>collision, distance, safety, nozzle</source>
        <translation>碰撞, 距离, 间隙, 安全, 喷嘴, collision</translation>
    </message>
    <message>
        <source>collision, check</source>
        <translation>碰撞, 检查, collision</translation>
    </message>
    <message>
        <source>configuration, flip, elbow, wrist</source>
        <translation>构型, 位形, 翻转, 肘, 腕, configuration</translation>
    </message>
    <message>
        <source>acceleration, vibration, smooth</source>
        <translation>加速度, 振动, 平滑, jerk</translation>
    </message>
    <message>
        <source>rotate, orientation, auto orient, lay flat</source>
        <translation>旋转, 朝向, 自动朝向, 放平, auto orient</translation>
    </message>
    <message>
        <source>repair, hole, mesh, thin, shell</source>
        <translation>修复, 孔, 网格, 薄, 外壳, mesh, repair</translation>
    </message>
    <message>
        <source>variable layer height, quality</source>
        <translation>可变层高, 质量, variable layer height</translation>
    </message>
    <message>
        <source>variable layer height, quality, adaptive</source>
        <translation>可变层高, 质量, 自适应, adaptive</translation>
    </message>
    <message>
        <source>extruder, nozzle, multi material, head</source>
        <translation>挤出机, 喷嘴, 多材料, 打印头, extruder</translation>
    </message>
    <message>
        <source>extruder, multi material, soluble</source>
        <translation>挤出机, 多材料, 水溶, 可溶, extruder</translation>
    </message>
    <message>
        <source>extruder, multi material, fill</source>
        <translation>挤出机, 多材料, 填充, extruder</translation>
    </message>
    <message>
        <source>extruder, multi material</source>
        <translation>挤出机, 多材料, extruder</translation>
    </message>
    <message>
        <source>tool change, wipe tower, multi material, colour change</source>
        <translation>换工具, 换头, 擦料塔, 多材料, 换色, wipe tower</translation>
    </message>
    <message>
        <source>carbon, continuous fibre, reinforcement, strength</source>
        <translation>碳纤维, 连续纤维, 增强, 强度, carbon fibre</translation>
    </message>
    <message>
        <source>resolution, grid</source>
        <translation>分辨率, 网格, resolution</translation>
    </message>
    <message>
        <source>split program, memory</source>
        <translation>拆分程序, 内存, 存储器</translation>
    </message>
    <message>
        <source>simplify, tolerance</source>
        <translation>简化, 公差, simplify</translation>
    </message>
    <message>
        <source>G2, G3, circle</source>
        <translation>G2, G3, 圆, 圆弧, arc</translation>
    </message>
    <message>
        <source>tolerance, strict, draft</source>
        <translation>公差, 严格, 草稿, draft</translation>
    </message>
    <message>
        <source>strategy, slicing, non-planar, way of building</source>
        <translation>策略, 切片, 非平面, 构建方式, non-planar</translation>
    </message>
    <message>
        <source>plate, bed, build plate, table, rod</source>
        <translation>打印板, 热床, 床, 构建板, 工作台, 芯棒, plate, bed</translation>
    </message>
    <message>
        <source>robot, arm, machine, printer, nozzle, head</source>
        <translation>机器人, 机械臂, 机器, 打印机, 喷嘴, 打印头, robot</translation>
    </message>
    <message>
        <source>nozzle, tool, extruder, speed, feed rate, bead, head, temperature</source>
        <translation>喷嘴, 工具, 挤出机, 速度, 进给速度, 挤出线, 打印头, 温度, nozzle</translation>
    </message>
    <message>
        <source>temperature, filament, plastic, heat, hot end, bed, fan, cooling, price, cost, flow, retraction</source>
        <translation>温度, 耗材, 线材, 塑料, 加热, 热端, 热床, 风扇, 冷却, 价格, 成本, 流量, 回抽, filament</translation>
    </message>
    <message>
        <source>tool, second nozzle, extruder, multi material, tool change, colour</source>
        <translation>工具, 第二喷嘴, 双喷嘴, 挤出机, 多材料, 换工具, 颜色, tool</translation>
    </message>
    <message>
        <source>scheme, curved, algorithm</source>
        <translation>方案, 曲面, 算法</translation>
    </message>
    <message>
        <source>random, repeatable</source>
        <translation>随机, 可重复, seed</translation>
    </message>
    <message>
        <source>as process</source>
        <translation>同工艺</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>no brim</source>
        <translation>无帽檐</translation>
    </message>
    <message>
        <source>as the part</source>
        <translation>同零件</translation>
    </message>
    <message>
        <source>no tapes</source>
        <translation>无纤维带</translation>
    </message>
    <message>
        <source>all that fit</source>
        <translation>能铺多少铺多少</translation>
    </message>
    <message>
        <source>only waits</source>
        <translation>只等待</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无限制</translation>
    </message>
    <message>
        <source>one bead</source>
        <translation>一条挤出线</translation>
    </message>
    <message>
        <source>never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>as format</source>
        <translation>同格式</translation>
    </message>
    <message>
        <source>round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>pause, stop, colour change, insert, M600</source>
        <translation>暂停, 停止, 换色, 嵌件, M600</translation>
    </message>
</context>
<context>
    <name>SizesDialog</name>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Slot length</source>
        <translation>槽长</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>槽宽</translation>
    </message>
    <message>
        <source>Hole diameter</source>
        <translation>孔径</translation>
    </message>
</context>
<context>
    <name>TypedChange</name>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1：%2 mm</translation>
    </message>
</context>
<context>
    <name>ValueBoxes</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>This character is not possible here. Enter a number: %1.</source>
        <translation>此处不能输入该字符。请输入数字：%1。</translation>
    </message>
    <message>
        <source>%1 is not possible here: %2 is used. Range: %3.</source>
        <translation>此处不能使用 %1：采用 %2。范围：%3。</translation>
    </message>
</context>
<context>
    <name>voluta::document::Document</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>重置%1</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>重置所有参数</translation>
    </message>
    <message>
        <source>Scale the part</source>
        <translation>缩放零件</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>复制 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Change print order</source>
        <translation>更改打印顺序</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>排列零件</translation>
    </message>
    <message>
        <source>Paste %1 parts</source>
        <translation>粘贴 %1 个零件</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>粘贴 %1</translation>
    </message>
    <message>
        <source>Remove %1 parts</source>
        <translation>移除 %1 个零件</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
</context>
<context>
    <name>voluta::document::Opening</name>
    <message>
        <source>the rest of %1</source>
        <translation>%1 的剩余部分</translation>
    </message>
</context>
<context>
    <name>voluta::document::RecentFiles</name>
    <message>
        <source>%1 no longer exists. It was removed from the list.</source>
        <translation>%1 已不存在，已从列表中移除。</translation>
    </message>
</context>
<context>
    <name>voluta::document::Saving</name>
    <message>
        <source>There is nothing to save yet. Open a part first.</source>
        <translation>还没有可保存的内容。先打开一个零件。</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ChoicesForm</name>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>工艺</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Another seed may find other travel paths; the same seed always gives the same result.</source>
        <translation>不同的种子可能得到不同的空移路径；相同的种子总是得到相同的结果。</translation>
    </message>
    <message>
        <source>Your own cells are JSON files in %1</source>
        <translation>自定义工作单元是 %1 中的 JSON 文件</translation>
    </message>
    <message>
        <source>Your own processes are JSON files in %1</source>
        <translation>自定义工艺是 %1 中的 JSON 文件</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Your own materials are JSON files in %1</source>
        <translation>自定义材料是 %1 中的 JSON 文件</translation>
    </message>
    <message>
        <source>Edit processes</source>
        <translation>编辑工艺</translation>
    </message>
    <message>
        <source>Edit materials</source>
        <translation>编辑材料</translation>
    </message>
    <message>
        <source>Growth scheme</source>
        <translation>生长方案</translation>
    </message>
    <message>
        <source>How the part is divided into layers</source>
        <translation>如何将零件划分为层</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterForm</name>
    <message>
        <source>Simple</source>
        <translation>简单</translation>
    </message>
    <message>
        <source>Show the most important and the changed parameters</source>
        <translation>显示最重要的和已更改的参数</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Show every parameter</source>
        <translation>显示每个参数</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Reset every parameter to its default</source>
        <translation>将每个参数恢复为默认值</translation>
    </message>
    <message>
        <source>No matching parameter.</source>
        <translation>没有匹配的参数。</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>打印</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>Search settings</source>
        <translation>搜索设置</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ParameterRow</name>
    <message>
        <source>Reset to %1</source>
        <translation>重置为 %1</translation>
    </message>
    <message>
        <source>Files (%1)</source>
        <translation>文件 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>选择文件</translation>
    </message>
</context>
<context>
    <name>voluta::forms::PlatformEditor</name>
    <message>
        <source>Body to print on</source>
        <translation>在其上打印的实体</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>A closed mesh, positioned as in the part&apos;s file</source>
        <translation>封闭网格，位置与零件文件中一致</translation>
    </message>
    <message>
        <source>%1
Click to choose another one</source>
        <translation>%1
点击以选择另一个</translation>
    </message>
    <message>
        <source>Stepped: x,radius points</source>
        <translation>阶梯形：x,半径 点</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Hexagonal, across corners</source>
        <translation>六边形，对角宽</translation>
    </message>
    <message>
        <source>%1 sides, across corners</source>
        <translation>%1 边形，对角宽</translation>
    </message>
    <message>
        <source>Shape of the rod</source>
        <translation>芯棒形状</translation>
    </message>
    <message>
        <source>Profile of the rod</source>
        <translation>芯棒轮廓</translation>
    </message>
    <message>
        <source>Pairs of x and radius in mm; a step has two pairs at one x</source>
        <translation>x 与半径的数对，单位 mm；台阶在同一 x 处有两个数对</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>网格 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Surface on which the print begins</source>
        <translation>打印起始的表面</translation>
    </message>
</context>
<context>
    <name>voluta::forms::ToolRows</name>
    <message>
        <source>Add tool</source>
        <translation>添加工具</translation>
    </message>
    <message>
        <source>Adds a second nozzle or material, for some parts, supports, pieces or the interior. The program stops for each change.</source>
        <translation>添加第二个喷嘴或材料，用于某些零件、支撑、分块或内部。每次更换时程序停止。</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>工具 %1</translation>
    </message>
    <message>
        <source>Process of tool %1</source>
        <translation>工具 %1 的工艺</translation>
    </message>
    <message>
        <source>Material of tool %1</source>
        <translation>工具 %1 的材料</translation>
    </message>
    <message>
        <source>Remove tool %1</source>
        <translation>移除工具 %1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ComparePanel</name>
    <message>
        <source>Cells</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Compares these cells; none selected: the job&apos;s own</source>
        <translation>比较这些工作单元；未选择：作业自身的工作单元</translation>
    </message>
    <message>
        <source>Open a part first.</source>
        <translation>先打开一个零件。</translation>
    </message>
    <message>
        <source>Select what to compare.</source>
        <translation>选择要比较的内容。</translation>
    </message>
    <message>
        <source>Plans: %1</source>
        <translation>规划数：%1</translation>
    </message>
    <message>
        <source>Ways of building</source>
        <translation>构建方式</translation>
    </message>
    <message>
        <source>Growth of curved layers</source>
        <translation>曲面层的生长</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>Delete removes the selected one from the list</source>
        <translation>按 Delete 从列表中移除所选项</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Also compare with this platform</source>
        <translation>也与此平台比较</translation>
    </message>
    <message>
        <source>Plan up to</source>
        <translation>规划到</translation>
    </message>
    <message>
        <source>verified programs</source>
        <translation>经验证的程序</translation>
    </message>
    <message>
        <source>missed voxels and pieces</source>
        <translation>遗漏的体素和分块</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Plans them one after the other, in the background</source>
        <translation>在后台逐个规划</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stops; completed rows are kept</source>
        <translation>停止；已完成的行保留</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Ways without blocking findings rank first, then the lowest score: each figure as a share of the column&apos;s largest, times its weight.</source>
        <translation>没有阻断问题的方式排在前面，其次是得分最低者：每项指标占该列最大值的比例乘以其权重。</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Restore the default weights</source>
        <translation>恢复默认权重</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CompareTable</name>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Rank, and the score below it: lower is better</source>
        <translation>名次，其下为得分：越低越好</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>名次</translation>
    </message>
    <message>
        <source>Way of building</source>
        <translation>构建方式</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CursorInfo</name>
    <message>
        <source>Line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>喷嘴</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>The nozzle&apos;s tip, from the middle of the platform</source>
        <translation>喷嘴尖端，从平台中心算起</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>已打印</translation>
    </message>
    <message>
        <source>About X, Y and Z of the platform, from the upright nozzle</source>
        <translation>绕平台的 X、Y 和 Z，从喷嘴竖直起算</translation>
    </message>
</context>
<context>
    <name>voluta::panels::CutPanel</name>
    <message>
        <source>Cut</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>切割 %1</translation>
    </message>
    <message>
        <source>Perpendicular to</source>
        <translation>垂直于</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Distance from the lowest point of the part along the axis</source>
        <translation>沿轴线到零件最低点的距离</translation>
    </message>
    <message>
        <source>Tilt about %1</source>
        <translation>绕 %1 倾斜</translation>
    </message>
    <message>
        <source>Parallel to a face</source>
        <translation>平行于某个面</translation>
    </message>
    <message>
        <source>Then click the face; the plane goes through the clicked point</source>
        <translation>然后点击该面；平面通过点击处</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Both halves</source>
        <translation>两半</translation>
    </message>
    <message>
        <source>Lower half</source>
        <translation>下半部分</translation>
    </message>
    <message>
        <source>Upper half</source>
        <translation>上半部分</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>接头</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Dowels</source>
        <translation>圆销</translation>
    </message>
    <message>
        <source>Pegs</source>
        <translation>凸销</translation>
    </message>
    <message>
        <source>Dovetail</source>
        <translation>燕尾榫</translation>
    </message>
    <message>
        <source>Dowels: loose pins in holes of both halves. Pegs: pins of the lower half. Dovetail: a tongue of the lower half in a groove.</source>
        <translation>圆销：装入两半孔中的活动销。凸销：下半部分上的销。燕尾榫：下半部分的榫舌嵌入槽中。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Height of the tongue</source>
        <translation>榫舌高度</translation>
    </message>
    <message>
        <source>Of a pin in each half</source>
        <translation>销在每一半中的深度</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Gap on every side of a pin or of the tongue</source>
        <translation>销或榫舌每一侧的间隙</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Pins in each section, if there is room</source>
        <translation>每个截面的销数（若有空间）</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>In which the dovetail slides, from the horizontal</source>
        <translation>燕尾榫的滑动方向，从水平起算</translation>
    </message>
    <message>
        <source>Lay halves on their cut face</source>
        <translation>将两半以切面放平</translation>
    </message>
    <message>
        <source>A half with pegs or a tongue keeps its orientation</source>
        <translation>带凸销或榫舌的一半保持原方向</translation>
    </message>
    <message>
        <source>Show apart</source>
        <translation>分开显示</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>voluta::panels::EffectCard</name>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Takes the remedy back, and shows the plan before it</source>
        <translation>撤销该对策，并显示之前的规划</translation>
    </message>
    <message>
        <source>Hide this</source>
        <translation>隐藏</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ExportPanel</name>
    <message>
        <source>Replay of %1</source>
        <translation>%1 的回放</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Choose at least one format.</source>
        <translation>至少选择一种格式。</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>选择文件夹。</translation>
    </message>
    <message>
        <source>Folder for the programs</source>
        <translation>程序文件夹</translation>
    </message>
    <message>
        <source>Refused programs</source>
        <translation>被拒绝的程序</translation>
    </message>
    <message>
        <source>The replay refused some of the programs. Never run them on a robot.</source>
        <translation>回放拒绝了部分程序。切勿在机器人上运行。</translation>
    </message>
    <message>
        <source>For inspection only, they can be saved as:</source>
        <translation>仅供查看，可保存为：</translation>
    </message>
    <message>
        <source>Save them too</source>
        <translation>一并保存</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>不保存</translation>
    </message>
    <message>
        <source>Formats</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>程序文本</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>%1 options</source>
        <translation>%1 选项</translation>
    </message>
    <message>
        <source>Blocked plan</source>
        <translation>规划被阻断</translation>
    </message>
    <message>
        <source>The plan has blocking findings: %1</source>
        <translation>规划有阻断问题：%1</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>仍然导出</translation>
    </message>
    <message>
        <source>Not as asked</source>
        <translation>未达要求</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>可安全运行，未达要求：%1</translation>
    </message>
    <message>
        <source>The part will differ from the requested one there. To export without this question, accept it in the list of findings.</source>
        <translation>零件在该处会与要求的不同。要不再询问直接导出，请在问题列表中接受。</translation>
    </message>
    <message>
        <source>Do not run the programs before these are solved.</source>
        <translation>解决这些问题之前不要运行程序。</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>未检查</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>除自定义语句外可安全运行：%1</translation>
    </message>
    <message>
        <source>Nothing checks what they do. Try them on the controller with the arm clear first.</source>
        <translation>它们的作用未经任何检查。先在控制器上、机械臂远离障碍物时试运行。</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsModel</name>
    <message>
        <source>Blocked: %1</source>
        <translation>阻断：%1</translation>
    </message>
    <message>
        <source>Worth knowing: %1</source>
        <translation>提示：%1</translation>
    </message>
    <message>
        <source>at %1, %2, %3 mm</source>
        <translation>位于 %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>before the change</source>
        <translation>更改之前</translation>
    </message>
    <message>
        <source>Not as asked: %1</source>
        <translation>未达要求：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>Not checked: %1</source>
        <translation>未检查：%1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FindingsPanel</name>
    <message>
        <source>Findings</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>问题 (%1)</translation>
    </message>
    <message>
        <source>%1 blocking, %2 for information</source>
        <translation>%1 个阻断，%2 个提示</translation>
    </message>
    <message>
        <source>Blocked (%1)</source>
        <translation>阻断 (%1)</translation>
    </message>
    <message>
        <source>No blocking findings.</source>
        <translation>没有阻断问题。</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>未发现问题。</translation>
    </message>
    <message>
        <source>No findings yet.</source>
        <translation>尚无问题。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Move the camera, the sliders and the robot there</source>
        <translation>将视角、滑块和机器人移到该处</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>未检查：%1。</translation>
    </message>
    <message>
        <source>No problems found so far.</source>
        <translation>目前未发现问题。</translation>
    </message>
    <message>
        <source>%1 blocking, %2 not as asked, %3 for information</source>
        <translation>%1 个阻断，%2 个未达要求，%3 个提示</translation>
    </message>
    <message>
        <source>Not as asked (%1)</source>
        <translation>未达要求 (%1)</translation>
    </message>
    <message>
        <source>Blocked (%1), not as asked (%2)</source>
        <translation>阻断 (%1)，未达要求 (%2)</translation>
    </message>
    <message>
        <source>Show only findings that block, or by which the part differs</source>
        <translation>只显示造成阻断或使零件不符的问题</translation>
    </message>
    <message>
        <source>What helps: %1</source>
        <translation>解决办法：%1</translation>
    </message>
    <message>
        <source>Place %1 of %2</source>
        <translation>位置 %1 / %2</translation>
    </message>
    <message>
        <source>Show next</source>
        <translation>显示下一个</translation>
    </message>
    <message>
        <source>Apply and plan:</source>
        <translation>应用并规划：</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FormatList</name>
    <message>
        <source>%1, foreign</source>
        <translation>%1，其他厂家</translation>
    </message>
    <message>
        <source>For another maker&apos;s controller: where the nozzle goes, not how this robot moves</source>
        <translation>用于其他厂家的控制器：喷嘴去往何处，而非此机器人如何运动</translation>
    </message>
    <message>
        <source>Not replayed yet</source>
        <translation>尚未回放</translation>
    </message>
    <message>
        <source>Passed: the replay found no errors</source>
        <translation>通过：回放未发现错误</translation>
    </message>
    <message>
        <source>Refused by the replay: %1</source>
        <translation>被回放拒绝：%1</translation>
    </message>
    <message>
        <source>Not replayed since the change</source>
        <translation>更改后尚未回放</translation>
    </message>
    <message>
        <source>Not passed, the plan is blocked: %1</source>
        <translation>未通过，规划被阻断：%1</translation>
    </message>
    <message>
        <source>Safe to run, not as asked: %1</source>
        <translation>可安全运行，未达要求：%1</translation>
    </message>
    <message>
        <source>Safe to run but for your own statements: %1</source>
        <translation>除自定义语句外可安全运行：%1</translation>
    </message>
</context>
<context>
    <name>voluta::panels::FrameForm</name>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>About the fixed X, then Y, then Z axis</source>
        <translation>依次绕固定的 X、Y、Z 轴</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Place along %1</source>
        <translation>沿 %1 的位置</translation>
    </message>
    <message>
        <source>Turn about %1</source>
        <translation>绕 %1 的转角</translation>
    </message>
    <message>
        <source>Edge along %1</source>
        <translation>沿 %1 的边长</translation>
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
        <translation>打印头，%1 × ⌀ %2 mm</translation>
    </message>
    <message>
        <source>Bead, %1 × %2 mm</source>
        <translation>挤出线，%1 × %2 mm</translation>
    </message>
    <message>
        <source>Head, nozzle and bead, to scale</source>
        <translation>打印头、喷嘴和挤出线，按比例</translation>
    </message>
    <message>
        <source>Left: profile of the head, used for collision checks. Right: its tip with a bead of the usual width and height.</source>
        <translation>左：用于碰撞检查的打印头轮廓。右：其尖端及常用宽度和高度的挤出线。</translation>
    </message>
    <message>
        <source>The head&apos;s sections do not rise from the tip.</source>
        <translation>打印头的截面未从尖端向上递增。</translation>
    </message>
</context>
<context>
    <name>voluta::panels::HeadTable</name>
    <message>
        <source>Height [mm]</source>
        <translation>高度 [mm]</translation>
    </message>
    <message>
        <source>Radius [mm]</source>
        <translation>半径 [mm]</translation>
    </message>
    <message>
        <source>Sections of the head from the tip up. Two rows of the same height are a step.</source>
        <translation>从尖端向上的打印头截面。高度相同的两行构成台阶。</translation>
    </message>
    <message>
        <source>Sections of the head</source>
        <translation>打印头截面</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>添加行</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>移除行</translation>
    </message>
    <message>
        <source>Reset head</source>
        <translation>重置打印头</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ItemForm</name>
    <message>
        <source>Choose a colour</source>
        <translation>选择颜色</translation>
    </message>
</context>
<context>
    <name>voluta::panels::JogPanel</name>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>喷嘴</translation>
    </message>
    <message>
        <source>The tip on the platform, and rotations about X, Y and Z (A, B, C) from the upright nozzle</source>
        <translation>平台上的喷嘴尖端，以及从喷嘴竖直起绕 X、Y、Z 的旋转 (A, B, C)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Step of X, Y and Z</source>
        <translation>X、Y 和 Z 的步长</translation>
    </message>
    <message>
        <source>Step of A, B and C</source>
        <translation>A、B 和 C 的步长</translation>
    </message>
    <message>
        <source>Back to the plan</source>
        <translation>返回规划</translation>
    </message>
    <message>
        <source>Joint %1</source>
        <translation>关节 %1</translation>
    </message>
    <message>
        <source>%1 one step less</source>
        <translation>%1 减一步</translation>
    </message>
    <message>
        <source>%1 one step more</source>
        <translation>%1 加一步</translation>
    </message>
</context>
<context>
    <name>voluta::panels::LayerInfo</name>
    <message>
        <source>Layer</source>
        <translation>层</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>面块</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Minimum, mean and maximum</source>
        <translation>最小、平均和最大</translation>
    </message>
</context>
<context>
    <name>voluta::panels::MeshPanel</name>
    <message>
        <source>Repair the mesh</source>
        <translation>修复网格</translation>
    </message>
    <message>
        <source>Closes holes, orients triangles and removes duplicates, as far as the shape is not in doubt</source>
        <translation>在形状无疑义的前提下，封闭孔洞、统一三角形朝向并删除重复项</translation>
    </message>
    <message>
        <source>No part is open.</source>
        <translation>未打开零件。</translation>
    </message>
    <message>
        <source>The mesh is not watertight.</source>
        <translation>网格未封闭。</translation>
    </message>
    <message>
        <source>The mesh is watertight.</source>
        <translation>网格封闭。</translation>
    </message>
    <message>
        <source>The mesh is watertight, but has defects.</source>
        <translation>网格封闭，但有缺陷。</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>三角形：%1</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>发现</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>已修复</translation>
    </message>
    <message>
        <source>Remains</source>
        <translation>剩余</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ObjectTree</name>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>喷嘴</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>打印板</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Part and cell</source>
        <translation>零件与工作站</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PaintForm</name>
    <message>
        <source>Paint with</source>
        <translation>涂绘方式</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Whole faces</source>
        <translation>整个面</translation>
    </message>
    <message>
        <source>Up to edges of</source>
        <translation>直到棱边角度</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Paint on the part. Shift or the right button erases.</source>
        <translation>在零件上涂绘。按住 Shift 或用右键擦除。</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Drag a rectangle: it paints what you see in it. Shift or the right button erases.</source>
        <translation>拖出矩形：涂绘其中可见的部分。按住 Shift 或用右键擦除。</translation>
    </message>
    <message>
        <source>Layers while the brush rests</source>
        <translation>画笔停顿时生成层</translation>
    </message>
    <message>
        <source>One second after a stroke, the layers are made again in the background</source>
        <translation>每笔之后一秒，在后台重新生成层</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PartList</name>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Size [mm]</source>
        <translation>尺寸 [mm]</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>添加…</translation>
    </message>
    <message>
        <source>Adds a part from a file beside the others</source>
        <translation>从文件添加一个零件，放在其他零件旁</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Adds a copy of the selected part with its settings</source>
        <translation>添加所选零件及其设置的副本</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Removes the selected part; can be undone</source>
        <translation>移除所选零件；可撤销</translation>
    </message>
    <message>
        <source>Print order</source>
        <translation>打印顺序</translation>
    </message>
    <message>
        <source>One after another</source>
        <translation>逐个</translation>
    </message>
    <message>
        <source>Layer by layer</source>
        <translation>逐层</translation>
    </message>
    <message>
        <source>One after another: each part is finished before the next begins. Layer by layer: all parts grow together.</source>
        <translation>逐个：每个零件完成后再开始下一个。逐层：所有零件一起生长。</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>排列</translation>
    </message>
    <message>
        <source>Moves all parts beside each other, with room for the print head</source>
        <translation>将所有零件并排放置，并为打印头留出空间</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PiecesPanel</name>
    <message>
        <source>Printed as number %1, on piece %2</source>
        <translation>第 %1 个打印，位于分块 %2 上</translation>
    </message>
    <message>
        <source>Printed as number %1, on the plate</source>
        <translation>第 %1 个打印，位于打印板上</translation>
    </message>
    <message>
        <source>Needs support: %1, uncut %2</source>
        <translation>需要支撑：%1，不切割时 %2</translation>
    </message>
    <message>
        <source>With this cut: %1 need support. Press Plan.</source>
        <translation>按此切割：%1 需要支撑。按“规划”。</translation>
    </message>
    <message>
        <source>With this cut: about %1 need support</source>
        <translation>按此切割：约 %1 需要支撑</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Risky</source>
        <translation>风险</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>In print order; each piece is listed below the one it is printed on</source>
        <translation>按打印顺序；每个分块列在其所依附的分块之下</translation>
    </message>
    <message>
        <source>Area that needs support when the piece is printed from its base</source>
        <translation>分块从其底面开始打印时需要支撑的面积</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>分离</translation>
    </message>
    <message>
        <source>Moves each piece away from the one it is printed on</source>
        <translation>将每个分块移离其所依附的分块</translation>
    </message>
    <message>
        <source>Base planes</source>
        <translation>底平面</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>重新搜索</translation>
    </message>
    <message>
        <source>Keep these cuts</source>
        <translation>保留这些切割</translation>
    </message>
    <message>
        <source>Discards your cuts and searches for others</source>
        <translation>放弃自定义切割并搜索其他切割</translation>
    </message>
    <message>
        <source>Keeps these cuts: they become your own and are not searched again</source>
        <translation>保留这些切割：它们成为自定义切割，不再搜索</translation>
    </message>
    <message>
        <source>Pick root</source>
        <translation>选取根部</translation>
    </message>
    <message>
        <source>Then click a point on the piece to print first</source>
        <translation>然后点击首先打印的分块上的一点</translation>
    </message>
    <message>
        <source>Click a piece to see its base plane and to move that cut.</source>
        <translation>点击分块以查看其底平面并移动该切割。</translation>
    </message>
    <message>
        <source>Drag the arrow to move the cut, a ring to tilt it. Esc deselects.</source>
        <translation>拖动箭头移动切割，拖动圆环倾斜切割。Esc 取消选择。</translation>
    </message>
    <message>
        <source>This piece is on the plate: it has no cut to move.</source>
        <translation>此分块在打印板上：没有可移动的切割。</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>In the picture, in print order</source>
        <translation>在图中按打印顺序标出</translation>
    </message>
    <message>
        <source>Shows where each piece is cut</source>
        <translation>显示每个分块的切割位置</translation>
    </message>
</context>
<context>
    <name>voluta::panels::PlacementPanel</name>
    <message>
        <source>Drop to plate</source>
        <translation>落到打印板</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>居中</translation>
    </message>
    <message>
        <source>Reset placement</source>
        <translation>重置放置</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>About the fixed axes: first X, then Y, then Z</source>
        <translation>绕固定轴：先 X，再 Y，后 Z</translation>
    </message>
    <message>
        <source>Height of the lowest point above the plate</source>
        <translation>最低点高出打印板的高度</translation>
    </message>
    <message>
        <source>Centre of the part along %1</source>
        <translation>零件沿 %1 的中心</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Rotate about the fixed axis %1; X comes first, then Y, then Z</source>
        <translation>绕固定轴 %1 旋转；先 X，再 Y，后 Z</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>Rotate by -90° about %1, from the present orientation</source>
        <translation>从当前朝向绕 %1 旋转 -90°</translation>
    </message>
    <message>
        <source>Rotate by 90° about %1, from the present orientation</source>
        <translation>从当前朝向绕 %1 旋转 90°</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Scale in percent</source>
        <translation>缩放百分比</translation>
    </message>
    <message>
        <source>Scale as a factor</source>
        <translation>缩放系数</translation>
    </message>
    <message>
        <source>Fit to reach</source>
        <translation>适应可达范围</translation>
    </message>
    <message>
        <source>Scale down, if necessary, to the size that the arm reaches everywhere</source>
        <translation>必要时缩小到机械臂处处可达的尺寸</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>按面放平</translation>
    </message>
    <message>
        <source>Then click the face to place on the plate</source>
        <translation>然后点击要贴到打印板上的面</translation>
    </message>
    <message>
        <source>Put the centre of the part over the centre of the plate</source>
        <translation>将零件中心置于打印板中心之上</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Position and size as in the file</source>
        <translation>位置和尺寸与文件一致</translation>
    </message>
    <message>
        <source>Size along %1. A new size scales the part as a whole.</source>
        <translation>沿 %1 的尺寸。输入新尺寸会整体缩放零件。</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>沿 %1 的尺寸</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>毫米或英寸</translation>
    </message>
    <message>
        <source>Unit of the size</source>
        <translation>尺寸单位</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ProgramFacts</name>
    <message>
        <source>Assumptions about the controller</source>
        <translation>对控制器的假设</translation>
    </message>
    <message>
        <source>%1 in one file</source>
        <translation>%1，一个文件</translation>
    </message>
    <message>
        <source>%1 in %2 files</source>
        <translation>%1，%2 个文件</translation>
    </message>
    <message>
        <source>Time on the controller: %1, as planned</source>
        <translation>控制器上的时间：%1，与规划一致</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % more than the planned time of %2</source>
        <translation>控制器上的时间：%1，比规划时间 %2 多 %3 %</translation>
    </message>
    <message>
        <source>Time on the controller: %1, %3 % less than the planned time of %2</source>
        <translation>控制器上的时间：%1，比规划时间 %2 少 %3 %</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ReachPanel</name>
    <message>
        <source>Calculating…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>No part on a plate.</source>
        <translation>打印板上没有零件。</translation>
    </message>
    <message>
        <source>The part is off the plate.</source>
        <translation>零件超出打印板。</translation>
    </message>
    <message>
        <source>Fully reachable upright.</source>
        <translation>竖直时完全可达。</translation>
    </message>
    <message>
        <source>%1 % reachable upright.</source>
        <translation>竖直时可达 %1 %。</translation>
    </message>
    <message>
        <source>With up to %1° of tilt: %2 %.</source>
        <translation>倾斜不超过 %1° 时：%2 %。</translation>
    </message>
    <message>
        <source>There %1 % is reachable upright, %2 % tilted</source>
        <translation>该处竖直时可达 %1 %，倾斜时 %2 %</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>可达范围</translation>
    </message>
    <message>
        <source>Reach of the head over the whole height of the part; collisions with printed material are not checked</source>
        <translation>打印头在零件整个高度上的可达范围；不检查与已打印材料的碰撞</translation>
    </message>
    <message>
        <source>Show on plate</source>
        <translation>在打印板上显示</translation>
    </message>
    <message>
        <source>Move to best place</source>
        <translation>移到最佳位置</translation>
    </message>
</context>
<context>
    <name>voluta::panels::RegionsPanel</name>
    <message>
        <source>Regions</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Regions of %1</source>
        <translation>%1 的区域</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>重命名区域</translation>
    </message>
    <message>
        <source>Use of a region</source>
        <translation>区域的用途</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>更改区域</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>Delete region</source>
        <translation>删除区域</translation>
    </message>
    <message>
        <source>Order of regions</source>
        <translation>区域顺序</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Where regions overlap, the lower one in the list holds. Double-click renames.</source>
        <translation>区域重叠处以列表中靠下的为准。双击可重命名。</translation>
    </message>
    <message>
        <source>A region is printed by settings, or in layers, of its own.</source>
        <translation>区域按自己的设置或层打印。</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move down: where regions overlap, the lower one holds</source>
        <translation>下移：区域重叠处以靠下的为准</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Only a skin or a painted surface says which faces the layers follow</source>
        <translation>只有表皮或涂绘表面才能指明层所跟随的面</translation>
    </message>
</context>
<context>
    <name>voluta::panels::ResumeBar</name>
    <message>
        <source>Resume from here…</source>
        <translation>从此处继续…</translation>
    </message>
    <message>
        <source>Opens the rest of a print that was stopped there as a new project</source>
        <translation>将在该处停止的打印的剩余部分作为新项目打开</translation>
    </message>
</context>
<context>
    <name>voluta::panels::VerdictTable</name>
    <message>
        <source>Coverage</source>
        <translation>覆盖率</translation>
    </message>
    <message>
        <source>Unsupported</source>
        <translation>无支承</translation>
    </message>
    <message>
        <source>Overfill</source>
        <translation>过填充</translation>
    </message>
    <message>
        <source>Mass error</source>
        <translation>重量误差</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>Limit violations</source>
        <translation>超限</translation>
    </message>
    <message>
        <source>Path deviation</source>
        <translation>路径偏差</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>极限</translation>
    </message>
    <message>
        <source>Within limit</source>
        <translation>在极限内</translation>
    </message>
    <message>
        <source>Outside limit</source>
        <translation>超出极限</translation>
    </message>
    <message>
        <source>Not checked since the change</source>
        <translation>更改后尚未检查</translation>
    </message>
    <message>
        <source>Less than half supported</source>
        <translation>支承不足一半</translation>
    </message>
    <message>
        <source>Longest unsupported run</source>
        <translation>最长无支承段</translation>
    </message>
    <message>
        <source>Flow error</source>
        <translation>流量误差</translation>
    </message>
    <message>
        <source>Time on the controller</source>
        <translation>控制器上的时间</translation>
    </message>
    <message>
        <source>Differences from the plan</source>
        <translation>与规划的差异</translation>
    </message>
    <message>
        <source>Outside limit, not refused</source>
        <translation>超出极限，未拒绝</translation>
    </message>
    <message>
        <source>Thin and open</source>
        <translation>过薄空缺</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WayCard</name>
    <message>
        <source>Contact %1 mm²</source>
        <translation>接触 %1 mm²</translation>
    </message>
    <message>
        <source>Missed voxels %1</source>
        <translation>遗漏体素 %1</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>约 %1</translation>
    </message>
    <message>
        <source>contact %1 mm², overhang %2 mm²
%3 mm high
%4 of %5 voxels missed in one growth pass
about %6, estimated from size, walls and infill without supports</source>
        <translation>接触 %1 mm²，悬垂 %2 mm²
高 %3 mm
一轮生长中 %5 个体素遗漏 %4 个
约 %6，按尺寸、壁和填充估计，不含支撑</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WaysList</name>
    <message>
        <source>Calculating…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>custom orientation</source>
        <translation>自定义朝向</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Click one to orient the part that way</source>
        <translation>点击其一，按此摆放零件</translation>
    </message>
</context>
<context>
    <name>voluta::panels::WrittenBar</name>
    <message>
        <source>Open report</source>
        <translation>打开报告</translation>
    </message>
    <message>
        <source>The report to hand over: verdict, margins and hashes of the program</source>
        <translation>用于交付的报告：程序的结论、余量和哈希值</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>显示文件夹</translation>
    </message>
    <message>
        <source>Opens the folder with the programs in the file manager</source>
        <translation>在文件管理器中打开程序所在的文件夹</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::JointPlots</name>
    <message>
        <source>Angle (°)</source>
        <translation>角度 (°)</translation>
    </message>
    <message>
        <source>Speed (°/s)</source>
        <translation>速度 (°/s)</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>时间 (s)</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>极限</translation>
    </message>
    <message>
        <source>Show the limits of the joints as dashed lines</source>
        <translation>以虚线显示关节极限</translation>
    </message>
    <message>
        <source>Show joint %1</source>
        <translation>显示关节 %1</translation>
    </message>
    <message>
        <source>Preparing the curves…</source>
        <translation>正在准备曲线…</translation>
    </message>
    <message>
        <source>Joint curves appear here once the motion is planned.</source>
        <translation>规划运动后，关节曲线显示在此处。</translation>
    </message>
    <message>
        <source>No joint selected.</source>
        <translation>未选择关节。</translation>
    </message>
    <message>
        <source>Show axis %1</source>
        <translation>显示轴 %1</translation>
    </message>
    <message>
        <source>Angle (°), position (mm)</source>
        <translation>角度 (°)，位置 (mm)</translation>
    </message>
    <message>
        <source>Speed (°/s, mm/s)</source>
        <translation>速度 (°/s, mm/s)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³)</source>
        <translation>加加速度 (rad/s³)</translation>
    </message>
    <message>
        <source>Jerk (rad/s³, mm/s³)</source>
        <translation>加加速度 (rad/s³, mm/s³)</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>加加速度</translation>
    </message>
    <message>
        <source>Earlier motion</source>
        <translation>先前的运动</translation>
    </message>
    <message>
        <source>Show the jerk of the motion planned before, in pale colours, to compare</source>
        <translation>以浅色显示先前规划的运动的加加速度，用于比较</translation>
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
        <translation>显示的层</translation>
    </message>
    <message>
        <source>No layers</source>
        <translation>无层</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3</source>
        <translation>层 %1 至 %2，共 %3</translation>
    </message>
    <message>
        <source>Layers appear here once they are planned.</source>
        <translation>规划层后显示在此处。</translation>
    </message>
    <message>
        <source>Layers %1 to %2 of %3. Up and down keys move the upper end, with Shift the lower one; a double click shows a single layer.</source>
        <translation>层 %1 至 %2，共 %3。上下键移动上端，按住 Shift 移动下端；双击显示单层。</translation>
    </message>
    <message>
        <source>r %1 mm</source>
        <translation>r %1 mm</translation>
    </message>
    <message>
        <source>, a pause before the last</source>
        <translation>，最后一层前暂停</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>移除第 %1 层前的暂停</translation>
    </message>
    <message>
        <source>Pause before layer %1: the arm goes beside the part and waits, for example to put in an insert</source>
        <translation>第 %1 层前暂停：机械臂移到零件旁并等待，例如放入嵌件</translation>
    </message>
</context>
<context>
    <name>voluta::timeline::TimelineBar</name>
    <message>
        <source>Wait: %1 s</source>
        <translation>等待：%1 s</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>上一层</translation>
    </message>
    <message>
        <source>Previous move</source>
        <translation>上一个移动</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Next move</source>
        <translation>下一个移动</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>下一层</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Moves of the layer</source>
        <translation>该层的移动</translation>
    </message>
    <message>
        <source>growth step %1</source>
        <translation>生长步 %1</translation>
    </message>
    <message>
        <source>Ten steps back</source>
        <translation>后退十步</translation>
    </message>
    <message>
        <source>Previous growth step</source>
        <translation>上一个生长步</translation>
    </message>
    <message>
        <source>Next growth step</source>
        <translation>下一个生长步</translation>
    </message>
    <message>
        <source>Ten steps forward</source>
        <translation>前进十步</translation>
    </message>
    <message>
        <source>Growth steps</source>
        <translation>生长步</translation>
    </message>
    <message>
        <source>Printing time so far / planned time</source>
        <translation>已打印时间 / 规划时间</translation>
    </message>
    <message>
        <source>Time-line</source>
        <translation>时间轴</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::MachinesView</name>
    <message>
        <source>View of the machines</source>
        <translation>机器视图</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::ViewCube</name>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Click a face to look from there, drag to turn the view</source>
        <translation>点击一个面从该侧观察，拖动以旋转视图</translation>
    </message>
</context>
<context>
    <name>voluta::viewer::Viewport</name>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
</context>
<context>
    <name>voluta::window::ArmImportDialog</name>
    <message>
        <source>Six axes with a spherical wrist, solved in closed form</source>
        <translation>六轴，球形手腕，闭式求解</translation>
    </message>
    <message>
        <source>Six axes, 2 to 4 parallel, solved in closed form</source>
        <translation>六轴，2 至 4 个轴平行，闭式求解</translation>
    </message>
    <message>
        <source>Six axes with an offset wrist, solved by a search</source>
        <translation>六轴，偏置手腕，通过搜索求解</translation>
    </message>
    <message>
        <source>Six axes, solved numerically: plans take longer</source>
        <translation>六轴，数值求解：规划耗时更长</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>导入机械臂</translation>
    </message>
    <message>
        <source>Nozzle on the arm, plate on a table</source>
        <translation>喷嘴在机械臂上，打印板在工作台上</translation>
    </message>
    <message>
        <source>Plate on the arm, nozzle fixed</source>
        <translation>打印板在机械臂上，喷嘴固定</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>法兰</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>Assumed:</source>
        <translation>假定：</translation>
    </message>
    <message>
        <source>An arm named %1 exists.</source>
        <translation>已有名为 %1 的机械臂。</translation>
    </message>
    <message>
        <source>Replacing it loses the frames, obstacles and other changes in these files:</source>
        <translation>替换它会丢失这些文件中的坐标系、障碍物和其他更改：</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Use another name</source>
        <translation>使用其他名称</translation>
    </message>
    <message>
        <source>Found in the file</source>
        <translation>文件中的内容</translation>
    </message>
</context>
<context>
    <name>voluta::window::BodyTree</name>
    <message>
        <source>Robot&apos;s base</source>
        <translation>机器人基座</translation>
    </message>
    <message>
        <source>Flange of %1</source>
        <translation>%1 的法兰</translation>
    </message>
    <message>
        <source>Nozzle</source>
        <translation>喷嘴</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>打印板</translation>
    </message>
    <message>
        <source>in the flange</source>
        <translation>在法兰上</translation>
    </message>
    <message>
        <source>on the last axis</source>
        <translation>在最后一个轴上</translation>
    </message>
    <message>
        <source>on the previous axis</source>
        <translation>在前一个轴上</translation>
    </message>
    <message>
        <source>in the robot&apos;s base</source>
        <translation>在机器人基座坐标系中</translation>
    </message>
    <message>
        <source>Place for purges</source>
        <translation>清料处</translation>
    </message>
</context>
<context>
    <name>voluta::window::CellEditor</name>
    <message>
        <source>in the flange</source>
        <translation>在法兰上</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>编辑工作单元</translation>
    </message>
    <message>
        <source>Save as my cell</source>
        <translation>另存为我的工作单元</translation>
    </message>
    <message>
        <source>Mass on the flange before printing: the plate and its stem, or head and extruder</source>
        <translation>打印前法兰上的重量：打印板及其立柱，或打印头和挤出机</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Extruder</source>
        <translation>挤出机</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>添加长方体</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Find home pose</source>
        <translation>查找原位</translation>
    </message>
    <message>
        <source>Finds the home pose with the greatest clearance, the nozzle over the plate</source>
        <translation>查找安全间距最大的原位，喷嘴位于打印板上方</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>extruder</source>
        <translation>挤出机</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>移动%1</translation>
    </message>
    <message>
        <source>edges of %1</source>
        <translation>%1的边长</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Select a body to move it</source>
        <translation>选择一个物体以移动它</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>没有问题。</translation>
    </message>
    <message>
        <source>add a box</source>
        <translation>添加长方体</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>移除%1</translation>
    </message>
    <message>
        <source>home pose</source>
        <translation>原位</translation>
    </message>
    <message>
        <source>No collision-free home pose over the plate was found.</source>
        <translation>未找到打印板上方无碰撞的原位。</translation>
    </message>
    <message>
        <source>Replace the cell %1?</source>
        <translation>替换工作单元 %1？</translation>
    </message>
    <message>
        <source>Add from file…</source>
        <translation>从文件添加…</translation>
    </message>
    <message>
        <source>An obstacle from a drawing: a mesh, approximated by boxes, cylinders and capsules</source>
        <translation>来自图纸模型的障碍物：网格，用长方体、圆柱和胶囊体近似</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>测量…</translation>
    </message>
    <message>
        <source>Computes the body&apos;s pose from points touched at the real cell</source>
        <translation>根据在实际工作单元中触碰的点计算物体的位姿</translation>
    </message>
    <message>
        <source>Collision solids</source>
        <translation>碰撞实体</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>添加%1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base, axes at 0</source>
        <translation>在机器人基座坐标系中，各轴为 0</translation>
    </message>
    <message>
        <source>measure %1</source>
        <translation>测量%1</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>在机械臂上叠加显示用于碰撞检查的实体</translation>
    </message>
    <message>
        <source>searching…</source>
        <translation>正在搜索…</translation>
    </message>
    <message>
        <source>Discard the changes to this cell?</source>
        <translation>放弃对此工作单元的更改？</translation>
    </message>
    <message>
        <source>The last one is: %1.</source>
        <translation>最后一项是：%1。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Add place for purges</source>
        <translation>添加清料处</translation>
    </message>
    <message>
        <source>Only a nozzle on the arm goes to a place for purges</source>
        <translation>只有机械臂上的喷嘴才会去清料处</translation>
    </message>
    <message>
        <source>The cell has a place for purges: select it to move it</source>
        <translation>工作单元已有清料处：选中即可移动</translation>
    </message>
    <message>
        <source>Where the nozzle&apos;s tip is when tools are changed and nozzles purged, instead of a place that the plan chooses</source>
        <translation>换工具和喷嘴清料时喷嘴尖端所在的位置，代替规划自动选择的位置</translation>
    </message>
    <message>
        <source>add the place for purges</source>
        <translation>添加清料处</translation>
    </message>
    <message>
        <source>Bodies of the cell</source>
        <translation>工作站中的物体</translation>
    </message>
</context>
<context>
    <name>voluta::window::ChoicesEditor</name>
    <message>
        <source>growth</source>
        <translation>生长</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>process</source>
        <translation>工艺</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>工作单元 %1</translation>
    </message>
    <message>
        <source>platform %1</source>
        <translation>平台 %1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>工艺 %1</translation>
    </message>
    <message>
        <source>scale %1</source>
        <translation>比例 %1</translation>
    </message>
    <message>
        <source>the part&apos;s orientation unchanged</source>
        <translation>零件朝向不变</translation>
    </message>
    <message>
        <source>rod shape</source>
        <translation>芯棒形状</translation>
    </message>
    <message>
        <source>way of building</source>
        <translation>构建方式</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>使用 %1</translation>
    </message>
    <message>
        <source>Which body is printed on? If none is chosen, the plate.</source>
        <translation>在哪个实体上打印？如不选择，则为打印板。</translation>
    </message>
    <message>
        <source>Choose the body…</source>
        <translation>选择实体…</translation>
    </message>
    <message>
        <source>Changed with it: %1.</source>
        <translation>随之更改：%1。</translation>
    </message>
    <message>
        <source>choices that fit the way of building</source>
        <translation>适合该构建方式的选项</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>The first way of building and platform without blocking findings.</source>
        <translation>第一个没有阻断问题的构建方式和平台。</translation>
    </message>
    <message>
        <source>Rejected: %1.</source>
        <translation>已排除：%1。</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>%1 g/cm³</source>
        <translation>%1 g/cm³</translation>
    </message>
    <message>
        <source>nozzle %1 °C</source>
        <translation>喷嘴 %1 °C</translation>
    </message>
    <message>
        <source>plate %1 °C</source>
        <translation>打印板 %1 °C</translation>
    </message>
    <message>
        <source>fan %1 %</source>
        <translation>风扇 %1 %</translation>
    </message>
    <message>
        <source>up to %1 mm³/s</source>
        <translation>最高 %1 mm³/s</translation>
    </message>
    <message>
        <source>tool added</source>
        <translation>已添加工具</translation>
    </message>
    <message>
        <source>tool removed</source>
        <translation>已移除工具</translation>
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
        <translation>命令与设置</translation>
    </message>
    <message>
        <source>Find a command or a setting</source>
        <translation>查找命令或设置</translation>
    </message>
    <message>
        <source>No command and no setting has these words.</source>
        <translation>没有命令或设置包含这些词。</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareItemsDialog</name>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>字段</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>没有差异。</translation>
    </message>
    <message>
        <source>Differing fields: %1</source>
        <translation>不同的字段：%1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePage</name>
    <message>
        <source>Nothing can be compared</source>
        <translation>没有可比较的内容</translation>
    </message>
    <message>
        <source>Adopted: %1. Press Plan.</source>
        <translation>已采用：%1。按“规划”。</translation>
    </message>
</context>
<context>
    <name>voluta::window::ComparePresetsDialog</name>
    <message>
        <source>Compare presets</source>
        <translation>比较预设</translation>
    </message>
    <message>
        <source>First preset</source>
        <translation>第一个预设</translation>
    </message>
    <message>
        <source>Second preset</source>
        <translation>第二个预设</translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation>不同的设置</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>没有差异。</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>不同的设置：%1</translation>
    </message>
</context>
<context>
    <name>voluta::window::CompareView</name>
    <message>
        <source>way of building</source>
        <translation>构建方式</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>规划中</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>未规划</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>No blocking findings</source>
        <translation>没有阻断问题</translation>
    </message>
    <message>
        <source>Blocked: %1</source>
        <translation>阻断：%1</translation>
    </message>
    <message>
        <source>Cannot be planned</source>
        <translation>无法规划</translation>
    </message>
    <message>
        <source>Planned in %1</source>
        <translation>规划用时 %1</translation>
    </message>
    <message>
        <source>Out of date: the part or its settings have changed since.</source>
        <translation>已过期：零件或其设置此后已更改。</translation>
    </message>
    <message>
        <source>Best: %1.</source>
        <translation>最佳：%1。</translation>
    </message>
    <message>
        <source>As good: %1.</source>
        <translation>同样好：%1。</translation>
    </message>
    <message>
        <source>None is best: all of them are blocked.</source>
        <translation>没有最佳项：全部被阻断。</translation>
    </message>
    <message>
        <source>Which way of building suits this part?
Tick the ways to compare at the right, then press Compare.</source>
        <translation>哪种构建方式适合此零件？
在右侧勾选要比较的方式，然后按“比较”。</translation>
    </message>
    <message>
        <source>Adopt this way</source>
        <translation>采用此方式</translation>
    </message>
    <message>
        <source>Builds the part as in the selected row; can be undone</source>
        <translation>按所选行构建零件；可撤销</translation>
    </message>
</context>
<context>
    <name>voluta::window::CopiesDialog</name>
    <message>
        <source>Number of copies</source>
        <translation>份数</translation>
    </message>
    <message>
        <source>Number of these parts on the plate; all parts are arranged anew</source>
        <translation>打印板上这些零件的数量；所有零件重新排列</translation>
    </message>
    <message>
        <source>&amp;Copies on the plate</source>
        <translation>打印板上的份数(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Fill the plate</source>
        <translation>铺满打印板(&amp;F)</translation>
    </message>
    <message>
        <source>As many copies as the plate has room for</source>
        <translation>打印板能容纳的最多份数</translation>
    </message>
</context>
<context>
    <name>voluta::window::CutTool</name>
    <message>
        <source>Calculating…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Lower half %1 cm³, upper half %2 cm³.</source>
        <translation>下半部分 %1 cm³，上半部分 %2 cm³。</translation>
    </message>
    <message>
        <source>Pins: %1.</source>
        <translation>销：%1。</translation>
    </message>
    <message>
        <source>Cutting…</source>
        <translation>正在切割…</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>切割 %1</translation>
    </message>
    <message>
        <source>dowel</source>
        <translation>圆销</translation>
    </message>
    <message>
        <source>Split to parts</source>
        <translation>拆分为零件</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>拆分 %1</translation>
    </message>
    <message>
        <source>The mesh has more than %1 bodies.</source>
        <translation>网格的实体超过 %1 个。</translation>
    </message>
    <message>
        <source>The part is one body.</source>
        <translation>该零件是单个实体。</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n 个零件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. Their regions have moved with them.</source>
        <translation>%1。其区域已随之移动。</translation>
    </message>
</context>
<context>
    <name>voluta::window::ExportPage</name>
    <message>
        <source>Open a part first.</source>
        <translation>先打开一个零件。</translation>
    </message>
    <message>
        <source>Planning is in progress.</source>
        <translation>正在规划。</translation>
    </message>
    <message>
        <source>Nothing has been planned yet. Press Plan.</source>
        <translation>尚未规划。按“规划”。</translation>
    </message>
    <message>
        <source>Programs are not saved in a project. Press Plan to generate them.</source>
        <translation>程序不保存在项目中。按“规划”生成。</translation>
    </message>
    <message>
        <source>The programs are out of date. Press Plan.</source>
        <translation>程序已过期。按“规划”。</translation>
    </message>
    <message>
        <source>program formats</source>
        <translation>程序格式</translation>
    </message>
    <message>
        <source>Files written to %1: %2</source>
        <translation>写入 %1 的文件：%2</translation>
    </message>
    <message>
        <source>; refused and not written: %1</source>
        <translation>；被拒绝而未写出：%1</translation>
    </message>
    <message>
        <source>; the reports have no pictures: %1</source>
        <translation>；报告没有图片：%1</translation>
    </message>
    <message>
        <source>The files are being written.</source>
        <translation>正在写出文件。</translation>
    </message>
    <message>
        <source>Nothing was exported</source>
        <translation>未导出任何内容</translation>
    </message>
    <message>
        <source>The replay refused all programs: %1.</source>
        <translation>回放拒绝了所有程序：%1。</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>替换文件？</translation>
    </message>
    <message>
        <source>These files already exist in %1:</source>
        <translation>%1 中已存在这些文件：</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>This is the rest of a print made with other settings. Undo the change: Plan would plan the whole part again.</source>
        <translation>这是以其他设置完成的打印的剩余部分。请撤销更改：“规划”会重新规划整个零件。</translation>
    </message>
    <message>
        <source>Slower on the controller by %1 s</source>
        <translation>在控制器上慢 %1 s</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>第 %1 行，%2</translation>
    </message>
    <message>
        <source>Verify a program</source>
        <translation>验证程序</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Cannot open %1</source>
        <translation>无法打开 %1</translation>
    </message>
    <message>
        <source>No program on this computer is set up to open it.</source>
        <translation>此计算机上没有设置用于打开它的程序。</translation>
    </message>
</context>
<context>
    <name>voluta::window::FilmDialog</name>
    <message>
        <source>Film</source>
        <translation>影片</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length of the film. The whole print is shown in it, with equal steps</source>
        <translation>影片长度。以相等步长展示整个打印过程</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>顶</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>长度(&amp;L)</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>尺寸(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the film</source>
        <translation>保存影片</translation>
    </message>
    <message>
        <source>Films (*.webm)</source>
        <translation>影片 (*.webm)</translation>
    </message>
</context>
<context>
    <name>voluta::window::FlowBar</name>
    <message>
        <source>nothing yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>blocked: see the findings</source>
        <translation>阻断：参见问题</translation>
    </message>
    <message>
        <source>not as asked or not checked: see the findings</source>
        <translation>未达要求或未检查：参见问题</translation>
    </message>
</context>
<context>
    <name>voluta::window::HeadNumbersDialog</name>
    <message>
        <source>Head from a few numbers</source>
        <translation>由几个数值生成打印头</translation>
    </message>
    <message>
        <source>The head contains the corners of the square block.</source>
        <translation>打印头包含方形块体的各角。</translation>
    </message>
    <message>
        <source>Use this head</source>
        <translation>使用此打印头</translation>
    </message>
</context>
<context>
    <name>voluta::window::Jogging</name>
    <message>
        <source>Collision: %1 and %2</source>
        <translation>碰撞：%1 与 %2</translation>
    </message>
    <message>
        <source>Free: more than %1 mm between bodies</source>
        <translation>无碰撞：物体间距超过 %1 mm</translation>
    </message>
    <message>
        <source>Free: %1 mm between the nearest bodies</source>
        <translation>无碰撞：最近物体间距 %1 mm</translation>
    </message>
    <message>
        <source>The arm does not reach that pose within its joint limits. It stays here.</source>
        <translation>机械臂在关节限位内到不了该位姿。保持在此处。</translation>
    </message>
    <message>
        <source>The printed part is not checked yet.</source>
        <translation>尚未检查已打印的零件。</translation>
    </message>
    <message>
        <source>Checking the pose…</source>
        <translation>正在检查位姿…</translation>
    </message>
</context>
<context>
    <name>voluta::window::JoinedMachines</name>
    <message>
        <source>Machine %1</source>
        <translation>机器 %1</translation>
    </message>
    <message>
        <source>Waits %1 for machine %2</source>
        <translation>等待机器 %2，时长 %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayerEventDialog</name>
    <message>
        <source>Event before layer %1</source>
        <translation>第 %1 层前的事件</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Own statement</source>
        <translation>自定义语句</translation>
    </message>
    <message>
        <source>Shown to the operator; the arm waits until the operator continues</source>
        <translation>显示给操作员；机械臂等待操作员继续</translation>
    </message>
    <message>
        <source>This line is written into programs of the format. Nothing checks it</source>
        <translation>此行写入该格式的程序，未经任何检查</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>&amp;Event</source>
        <translation>事件(&amp;E)</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>文本(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>时长(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>编号(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>工具(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Line</source>
        <translation>语句行(&amp;L)</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>拍照</translation>
    </message>
    <message>
        <source>The camera&apos;s output is on for this long; the arm waits beside the part</source>
        <translation>相机的输出保持接通这么长时间；机械臂在零件旁等待</translation>
    </message>
    <message>
        <source>Change of filament</source>
        <translation>更换耗材</translation>
    </message>
</context>
<context>
    <name>voluta::window::LayersPage</name>
    <message>
        <source>Replaying growth: all layers shown</source>
        <translation>正在回放生长：显示所有层</translation>
    </message>
    <message>
        <source>Pieces are always shown whole</source>
        <translation>分块始终完整显示</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>此层前的事件…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>暂停、等待、输出、更换工具或自定义语句行</translation>
    </message>
</context>
<context>
    <name>voluta::window::LegendView</name>
    <message>
        <source>Click to show these beads</source>
        <translation>点击显示这些挤出线</translation>
    </message>
    <message>
        <source>Click to hide these beads</source>
        <translation>点击隐藏这些挤出线</translation>
    </message>
</context>
<context>
    <name>voluta::window::LibraryDialog</name>
    <message>
        <source>Processes and materials</source>
        <translation>工艺和材料</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Use in this job</source>
        <translation>用于此作业</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>工艺</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>From a few numbers…</source>
        <translation>由几个数值…</translation>
    </message>
    <message>
        <source>From a mesh…</source>
        <translation>由网格…</translation>
    </message>
    <message>
        <source>A drawing of the head with its nozzle pointing down: the largest radius at each height</source>
        <translation>喷嘴朝下的打印头模型：取每个高度处的最大半径</translation>
    </message>
    <message>
        <source>%1 (in this job)</source>
        <translation>%1（此作业中）</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>程序自带</translation>
    </message>
    <message>
        <source>Stored in this job</source>
        <translation>存储在此作业中</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Comes with the program. Duplicate it to change it.</source>
        <translation>程序自带。要更改，请复制它。</translation>
    </message>
    <message>
        <source>Stored in this job, not in your library. Duplicate it to keep it.</source>
        <translation>存储在此作业中，不在库中。要保留，请复制它。</translation>
    </message>
    <message>
        <source>Your own.</source>
        <translation>自定义。</translation>
    </message>
    <message>
        <source>Your own, based on %1; fields that differ are marked.</source>
        <translation>自定义，基于 %1；不同的字段已标出。</translation>
    </message>
    <message>
        <source>Cannot be saved: %1 %2</source>
        <translation>无法保存：%1 %2</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>打印头</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>尚未保存。</translation>
    </message>
    <message>
        <source>Save and use in this job</source>
        <translation>保存并用于此作业</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Small letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;:</source>
        <translation>小写字母、数字、&apos;-&apos;、&apos;_&apos; 和 &apos;.&apos;：</translation>
    </message>
    <message>
        <source>There is another &apos;%1&apos;.</source>
        <translation>已有另一个“%1”。</translation>
    </message>
    <message>
        <source>Delete %1 and its file?</source>
        <translation>删除 %1 及其文件？</translation>
    </message>
    <message>
        <source>Import a process</source>
        <translation>导入工艺</translation>
    </message>
    <message>
        <source>Import a material</source>
        <translation>导入材料</translation>
    </message>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON 文件 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Replace your own %1?</source>
        <translation>替换自定义的 %1？</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>导出 %1</translation>
    </message>
    <message>
        <source>JSON files (*.json)</source>
        <translation>JSON 文件 (*.json)</translation>
    </message>
    <message>
        <source>Head from a mesh</source>
        <translation>由网格生成打印头</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>保存更改？</translation>
    </message>
    <message>
        <source>The job uses another version of this process.</source>
        <translation>作业使用此工艺的另一版本。</translation>
    </message>
    <message>
        <source>Sizes from a measured plate…</source>
        <translation>由测量板得出尺寸…</translation>
    </message>
    <message>
        <source>Corrects the sizes of flat layers by those of a printed accuracy plate</source>
        <translation>根据打印的精度测试板校正平面层的尺寸</translation>
    </message>
    <message>
        <source>Does the nozzle point up in the drawing?</source>
        <translation>模型中喷嘴是否朝上？</translation>
    </message>
    <message>
        <source>Turn it over</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>Use it as drawn</source>
        <translation>按原样使用</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>网格 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Your own. It follows %1 in all fields that are not marked.</source>
        <translation>自定义。所有未标出的字段均跟随 %1。</translation>
    </message>
</context>
<context>
    <name>voluta::window::LogDialog</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>No program on this computer opens the folder %1.</source>
        <translation>此计算机上没有程序能打开文件夹 %1。</translation>
    </message>
</context>
<context>
    <name>voluta::window::MachineTable</name>
    <message>
        <source>Job</source>
        <translation>作业</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>机器</translation>
    </message>
</context>
<context>
    <name>voluta::window::MainWindow</name>
    <message>
        <source>Part and cell</source>
        <translation>零件和工作单元</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>无法写入 %1。请选择另一个文件夹。</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>芯棒</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 个零件</translation>
    </message>
    <message>
        <source>Saved the film %1</source>
        <translation>已保存影片 %1</translation>
    </message>
</context>
<context>
    <name>voluta::window::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>手册页面</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>返回(&amp;B)</translation>
    </message>
</context>
<context>
    <name>voluta::window::MeasureDialog</name>
    <message>
        <source>One point per row, in mm, %1. Three rows x, y, z: origin, a point on X, a point in the XY plane. Or at least three rows of six: nominal point, touched point.</source>
        <translation>每行一个点，单位 mm，%1。三行 x, y, z：原点、X 上的点、XY 平面内的点。或至少三行、每行六个数：名义点、触碰点。</translation>
    </message>
    <message>
        <source>At least four poses in which the tip touches the same point, tilted to different sides, one per row: the robot&apos;s joints, or x, y, z, qw, qx, qy, qz of the flange.</source>
        <translation>至少四个位姿，尖端触碰同一点并向不同方向倾斜，每行一个：机器人各关节，或法兰的 x, y, z, qw, qx, qy, qz。</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>测量%1</translation>
    </message>
    <message>
        <source>Use this frame</source>
        <translation>使用此坐标系</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
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
        <translation>圆边：半径 %1，直径 %2</translation>
    </message>
    <message>
        <source>Round face: radius %1, diameter %2</source>
        <translation>圆柱面：半径 %1，直径 %2</translation>
    </message>
    <message>
        <source>Ball: radius %1, diameter %2</source>
        <translation>球面：半径 %1，直径 %2</translation>
    </message>
    <message>
        <source>Corner: X %1, Y %2, Z %3</source>
        <translation>角点：X %1，Y %2，Z %3</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Wall behind the face: %1</source>
        <translation>面后的壁厚：%1</translation>
    </message>
    <message>
        <source>Distance: %1</source>
        <translation>距离：%1</translation>
    </message>
    <message>
        <source>X %1, Y %2, Z %3</source>
        <translation>X %1，Y %2，Z %3</translation>
    </message>
    <message>
        <source>Distance of the parallel faces: %1</source>
        <translation>平行面的距离：%1</translation>
    </message>
    <message>
        <source>Angle: %1°</source>
        <translation>角度：%1°</translation>
    </message>
    <message>
        <source>Click a corner, an edge or a face of the part.</source>
        <translation>点击零件的角点、边或面。</translation>
    </message>
    <message>
        <source>Click a second place for distance and angle.</source>
        <translation>点击第二处可得距离和角度。</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillDialog</name>
    <message>
        <source>Mill %1 from a block</source>
        <translation>从毛坯铣削 %1</translation>
    </message>
    <message>
        <source>Save G-code…</source>
        <translation>保存 G-code…</translation>
    </message>
    <message>
        <source>Compute passes</source>
        <translation>计算走刀</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Milled block</source>
        <translation>铣削后的毛坯</translation>
    </message>
    <message>
        <source>Computing the passes and running them on the block…</source>
        <translation>正在计算走刀并在毛坯上运行…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>Values have changed: compute the passes again.</source>
        <translation>数值已更改：重新计算走刀。</translation>
    </message>
    <message>
        <source>Passed: the program was read back and run on the block.</source>
        <translation>通过：程序已读回并在毛坯上运行。</translation>
    </message>
    <message>
        <source>Refused: %1 (%2)</source>
        <translation>拒绝：%1 (%2)</translation>
    </message>
    <message>
        <source>Block %1 × %2 × %3 mm</source>
        <translation>毛坯 %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Time %1, %2 moves</source>
        <translation>时间 %1，%2 个移动</translation>
    </message>
    <message>
        <source>Removed %1 of %2 cm³</source>
        <translation>已切除 %2 cm³ 中的 %1</translation>
    </message>
    <message>
        <source>Left on the part: at most %1 mm</source>
        <translation>零件上的残留：最多 %1 mm</translation>
    </message>
    <message>
        <source>Missing from the part: at most %1 mm</source>
        <translation>零件的过切：最多 %1 mm</translation>
    </message>
    <message>
        <source>Save the G-code</source>
        <translation>保存 G-code</translation>
    </message>
    <message>
        <source>G-code (*.nc)</source>
        <translation>G-code (*.nc)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Not complete: %1 (%2)</source>
        <translation>不完整：%1 (%2)</translation>
    </message>
</context>
<context>
    <name>voluta::window::MillForm</name>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>刀齿</translation>
    </message>
    <message>
        <source>Lay the part down</source>
        <translation>放平零件</translation>
    </message>
    <message>
        <source>Turns the part so that the least material is milled away; otherwise it keeps its orientation on the plate</source>
        <translation>转动零件，使铣去的材料最少；否则保持其在打印板上的朝向</translation>
    </message>
    <message>
        <source>%1 rpm, feed %2 mm/min, lines every %3 mm, fine passes of %4 mm</source>
        <translation>%1 rpm，进给 %2 mm/min，行距 %3 mm，精加工每次 %4 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObjectMenus</name>
    <message>
        <source>Show its place</source>
        <translation>显示位置</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>复制文本</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>只显示此项</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Select this part</source>
        <translation>选择此零件</translation>
    </message>
    <message>
        <source>Show all beads</source>
        <translation>显示全部挤出线</translation>
    </message>
    <message>
        <source>Show only layer %1</source>
        <translation>只显示第 %1 层</translation>
    </message>
    <message>
        <source>Show up to layer %1</source>
        <translation>显示到第 %1 层</translation>
    </message>
    <message>
        <source>Show all layers</source>
        <translation>显示全部层</translation>
    </message>
    <message>
        <source>Go to this moment</source>
        <translation>转到此时刻</translation>
    </message>
    <message>
        <source>Hide beads of this kind</source>
        <translation>隐藏此类挤出线</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>unit of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>Repair the mesh</source>
        <translation>修复网格</translation>
    </message>
    <message>
        <source>repair the mesh</source>
        <translation>修复网格</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>按读入的网格</translation>
    </message>
</context>
<context>
    <name>voluta::window::ObstacleImport</name>
    <message>
        <source>Obstacle from a file</source>
        <translation>来自文件的障碍物</translation>
    </message>
    <message>
        <source>%1 is %2 mm long. Was it drawn in metres?</source>
        <translation>%1 长 %2 mm。绘制时单位是米吗？</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>网格 (%1);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::PageStack</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Layers, paths and programs are not up to date yet: press Plan.</source>
        <translation>层、路径和程序尚未更新：按“规划”。</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>The settings have changed since: press Plan.</source>
        <translation>设置此后已更改：按“规划”。</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>第 %1 层</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>总计</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartHandles</name>
    <message>
        <source>drop to plate</source>
        <translation>落到打印板</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>居中</translation>
    </message>
    <message>
        <source>lay on face</source>
        <translation>按面放平</translation>
    </message>
    <message>
        <source>place on touched points</source>
        <translation>按触碰点放置</translation>
    </message>
    <message>
        <source>move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>旋转</translation>
    </message>
</context>
<context>
    <name>voluta::window::PartsView</name>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Arrange parts</source>
        <translation>排列零件</translation>
    </message>
    <message>
        <source>Arranging the copies…</source>
        <translation>正在排列副本…</translation>
    </message>
    <message>
        <source>Number of copies</source>
        <translation>份数</translation>
    </message>
    <message numerus="yes">
        <source>%n copies on the plate</source>
        <translation>
            <numerusform>打印板上 %n 份</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>voluta::window::PictureArea</name>
    <message>
        <source>The viewport needs OpenGL 3.2; this display offers %1. Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export work without a picture.</source>
        <translation>视图需要 OpenGL 3.2；此显示器提供 %1。请更新显卡驱动，或设置 LIBGL_ALWAYS_SOFTWARE=1。没有图像时规划和导出仍可使用。</translation>
    </message>
</context>
<context>
    <name>voluta::window::PieceCuts</name>
    <message>
        <source>keep cuts</source>
        <translation>保留切割</translation>
    </message>
    <message>
        <source>search for cuts</source>
        <translation>搜索切割</translation>
    </message>
    <message>
        <source>move cut</source>
        <translation>移动切割</translation>
    </message>
    <message>
        <source>pick root</source>
        <translation>选取根部</translation>
    </message>
</context>
<context>
    <name>voluta::window::PreparePage</name>
    <message>
        <source>repair the mesh</source>
        <translation>修复网格</translation>
    </message>
    <message>
        <source>mesh as read</source>
        <translation>网格按读取原样</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Edit cell</source>
        <translation>编辑工作单元</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetBar</name>
    <message>
        <source>%1 (changed)</source>
        <translation>%1（已更改）</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Save, compare, export or import presets</source>
        <translation>保存、比较、导出或导入预设</translation>
    </message>
    <message>
        <source>Preset menu</source>
        <translation>预设菜单</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetEditor</name>
    <message>
        <source>JSON files (*.json);;All files (*)</source>
        <translation>JSON 文件 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>In this project</source>
        <translation>在此项目中</translation>
    </message>
    <message>
        <source>With the program</source>
        <translation>程序自带</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>您自己的</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1：%2，而非 %3</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>另有 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>Change preset</source>
        <translation>切换预设</translation>
    </message>
    <message>
        <source>Settings of the preset were changed. Take the changes to %1?</source>
        <translation>预设的设置已更改。将更改带到 %1？</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>转移(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Keep this preset</source>
        <translation>保留此预设(&amp;K)</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>预设 %1</translation>
    </message>
    <message>
        <source>Save preset %1</source>
        <translation>保存预设 %1</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1（自己的）</translation>
    </message>
    <message>
        <source>Save preset as</source>
        <translation>预设另存为</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>重命名预设</translation>
    </message>
    <message>
        <source>Rename preset %1</source>
        <translation>重命名预设 %1</translation>
    </message>
    <message>
        <source>Delete preset</source>
        <translation>删除预设</translation>
    </message>
    <message>
        <source>Delete the preset %1? The settings of this project stay.</source>
        <translation>删除预设 %1？此项目的设置保持不变。</translation>
    </message>
    <message>
        <source>Delete preset %1</source>
        <translation>删除预设 %1</translation>
    </message>
    <message>
        <source>Discard changes of the preset</source>
        <translation>放弃对预设的更改</translation>
    </message>
    <message>
        <source>Present settings</source>
        <translation>当前设置</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>导出 %1</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>导入预设</translation>
    </message>
    <message>
        <source>Replace your own preset %1?</source>
        <translation>替换您自己的预设 %1？</translation>
    </message>
</context>
<context>
    <name>voluta::window::PresetNameDialog</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
</context>
<context>
    <name>voluta::window::ProjectFiles</name>
    <message>
        <source>settings of the sample</source>
        <translation>示例的设置</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>就绪。按“规划”。</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>无法打开 %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>%1 is not saved</source>
        <translation>%1 未保存</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>打开最近文件</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>已打开 %1</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Voluta 项目 (*.voluta)</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>恢复未保存的工作</translation>
    </message>
    <message>
        <source>Voluta ended unexpectedly. A copy of “%1” was saved on %2.</source>
        <translation>Voluta 意外结束。已于 %2 保存“%1”的副本。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>以后</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Resume from here?</source>
        <translation>从此处继续？</translation>
    </message>
    <message>
        <source>%1 % of the material counts as printed. The rest of “%2” opens as a new project.</source>
        <translation>材料的 %1 % 视为已打印。“%2”的剩余部分作为新项目打开。</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Import a robot arm</source>
        <translation>导入机械臂</translation>
    </message>
    <message>
        <source>Robot descriptions (*.urdf *.xml);;All files (*)</source>
        <translation>机器人描述 (*.urdf *.xml);;所有文件 (*)</translation>
    </message>
    <message>
        <source>No folder for your own robots: set HOME.</source>
        <translation>没有用于自定义机器人的文件夹：请设置 HOME。</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>工作单元</translation>
    </message>
    <message>
        <source>Imported: cell %1</source>
        <translation>已导入：工作单元 %1</translation>
    </message>
    <message>
        <source>Add part</source>
        <translation>添加零件</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>零件 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>One part?</source>
        <translation>一个零件？</translation>
    </message>
    <message>
        <source>“%1” and “%2” in “%3” touch. Open the file as one part?</source>
        <translation>“%3”中的“%1”与“%2”相接触。将文件作为一个零件打开？</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>一个零件</translation>
    </message>
    <message>
        <source>Several parts</source>
        <translation>多个零件</translation>
    </message>
    <message>
        <source>Add or replace?</source>
        <translation>添加还是替换？</translation>
    </message>
    <message>
        <source>Add “%1” beside “%2”, or open it instead?</source>
        <translation>将“%1”添加到“%2”旁，还是改为打开它？</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Parts and projects (%1);;All files (*)</source>
        <translation>零件和项目 (%1);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>voluta::window::QuoteDialog</name>
    <message>
        <source>Quote</source>
        <translation>报价</translation>
    </message>
    <message>
        <source>Price of each print, whatever its size</source>
        <translation>每次打印的价格，与大小无关</translation>
    </message>
    <message>
        <source>Added to the cost</source>
        <translation>加到成本上</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>成本</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>金额</translation>
    </message>
    <message>
        <source>Machine, per hour</source>
        <translation>机器，每小时</translation>
    </message>
    <message>
        <source>Set-up, per print</source>
        <translation>准备，每次打印</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>利润</translation>
    </message>
    <message>
        <source>Save page…</source>
        <translation>保存页面…</translation>
    </message>
    <message>
        <source>A page for the customer, as PDF or HTML</source>
        <translation>给客户的页面，PDF 或 HTML</translation>
    </message>
    <message>
        <source>%1 g at %2 per kg</source>
        <translation>%1 g，每 kg %2</translation>
    </message>
    <message>
        <source>%1 g; its price is not known</source>
        <translation>%1 g；价格未知</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Plan the part first.</source>
        <translation>请先规划零件。</translation>
    </message>
    <message>
        <source>Enter the price of the material under Processes and materials.</source>
        <translation>请在“工艺与材料”中输入材料价格。</translation>
    </message>
    <message>
        <source>Save page</source>
        <translation>保存页面</translation>
    </message>
    <message>
        <source>%1 quote</source>
        <translation>%1 报价</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;HTML (*.html)</source>
        <translation>PDF (*.pdf);;HTML (*.html)</translation>
    </message>
    <message>
        <source>Drawing the part…</source>
        <translation>正在绘制零件…</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>已保存为 %1。</translation>
    </message>
    <message>
        <source>Price of an hour of the machine, with power and operator; each cell has its own</source>
        <translation>机器每小时价格，含电费和人工；每个工作单元各有其价格</translation>
    </message>
</context>
<context>
    <name>voluta::window::ReachView</name>
    <message>
        <source>move to best place</source>
        <translation>移到最佳位置</translation>
    </message>
</context>
<context>
    <name>voluta::window::RegionsTool</name>
    <message>
        <source>Move region</source>
        <translation>移动区域</translation>
    </message>
    <message>
        <source>Paint region</source>
        <translation>涂绘区域</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>添加区域</translation>
    </message>
    <message>
        <source>Body of a region</source>
        <translation>区域的实体</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>网格 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>Nothing is painted yet: the region has no effect.</source>
        <translation>尚未涂绘任何内容：该区域不起作用。</translation>
    </message>
</context>
<context>
    <name>voluta::window::RemedyEffect</name>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1：%2 → %3</translation>
    </message>
    <message>
        <source>Not covered</source>
        <translation>未覆盖</translation>
    </message>
    <message>
        <source>Printed in the air</source>
        <translation>悬空打印</translation>
    </message>
    <message>
        <source>Overfilled</source>
        <translation>过填充</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Applied: %1</source>
        <translation>已应用：%1</translation>
    </message>
    <message>
        <source>It cannot be planned this way. Undo it, or try another remedy.</source>
        <translation>这样无法规划。请撤销，或尝试其他对策。</translation>
    </message>
    <message>
        <source>The figures follow when the plan is done.</source>
        <translation>规划完成后显示数值。</translation>
    </message>
    <message>
        <source>Plan to see its effect.</source>
        <translation>规划后可查看效果。</translation>
    </message>
    <message>
        <source>No longer found</source>
        <translation>不再出现</translation>
    </message>
    <message>
        <source>Unchanged: %1</source>
        <translation>未变：%1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>之前：%1</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>之后：%1</translation>
    </message>
</context>
<context>
    <name>voluta::window::RunDialog</name>
    <message>
        <source>Path %1 mm over %2 mm</source>
        <translation>路径 %1 mm，长 %2 mm</translation>
    </message>
    <message>
        <source>Speed %1 % over %2 mm</source>
        <translation>速度 %1 %，长 %2 mm</translation>
    </message>
    <message>
        <source>Flow %1 % over %2 mm</source>
        <translation>流量 %1 %，长 %2 mm</translation>
    </message>
    <message>
        <source>%1 mm of beads are missing</source>
        <translation>缺少 %1 mm 挤出线</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>最差位置</translation>
    </message>
    <message>
        <source>Recorded run %1</source>
        <translation>运行记录 %1</translation>
    </message>
    <message>
        <source>Comparing the record with the current plan…</source>
        <translation>正在将记录与当前规划比较…</translation>
    </message>
    <message>
        <source>Flow, recorded: mean %1 %, from %2 to %3 %</source>
        <translation>流量，记录值：平均 %1 %，%2 至 %3 %</translation>
    </message>
    <message>
        <source>Flow at this speed: mean %1 %, from %2 to %3 %</source>
        <translation>此速度下的流量：平均 %1 %，%2 至 %3 %</translation>
    </message>
    <message>
        <source>Path: mean %1 mm, greatest %2 mm</source>
        <translation>路径：平均 %1 mm，最大 %2 mm</translation>
    </message>
    <message>
        <source>Speed: mean %1 %, from %2 to %3 %</source>
        <translation>速度：平均 %1 %，%2 至 %3 %</translation>
    </message>
    <message>
        <source>Beads recorded: %1 of %2 mm</source>
        <translation>已记录挤出线：%1 / %2 mm</translation>
    </message>
</context>
<context>
    <name>voluta::window::Runs</name>
    <message>
        <source>1 voxel, %1 missed</source>
        <translation>1 个体素，遗漏 %1</translation>
    </message>
    <message>
        <source>%1 voxels, %2 missed</source>
        <translation>%1 个体素，遗漏 %2</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 层</translation>
    </message>
    <message>
        <source>1 waypoint</source>
        <translation>1 个路径点</translation>
    </message>
    <message>
        <source>%1 waypoints</source>
        <translation>%1 个路径点</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>replay passed</source>
        <translation>回放通过</translation>
    </message>
    <message>
        <source>replay not passed</source>
        <translation>回放未通过</translation>
    </message>
    <message>
        <source>Ready. Press Plan.</source>
        <translation>就绪。按“规划”。</translation>
    </message>
    <message>
        <source>Done. Blocking findings: %1.</source>
        <translation>完成。阻断问题：%1。</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>完成。</translation>
    </message>
    <message>
        <source>Pieces updated. Press Plan for layers and paths.</source>
        <translation>分块已更新。按“规划”生成层和路径。</translation>
    </message>
    <message>
        <source>Voxels updated. Press Plan for layers and paths.</source>
        <translation>体素已更新。按“规划”生成层和路径。</translation>
    </message>
    <message>
        <source>Press Plan for layers and paths.</source>
        <translation>按“规划”生成层和路径。</translation>
    </message>
    <message>
        <source>Compared. Select a row to adopt it.</source>
        <translation>比较完成。选择一行以采用。</translation>
    </message>
    <message>
        <source>Preview: %1, 1 growth step</source>
        <translation>预览：%1，1 个生长步</translation>
    </message>
    <message>
        <source>Preview: %1, %2 growth steps</source>
        <translation>预览：%1，%2 个生长步</translation>
    </message>
    <message>
        <source>Preview: %1, improving layers</source>
        <translation>预览：%1，正在改进层</translation>
    </message>
    <message>
        <source>Preview: %1. Press Plan.</source>
        <translation>预览：%1。按“规划”。</translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation>已过期：%1</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 个分块</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 个分块</translation>
    </message>
    <message>
        <source>%1 mm² need support</source>
        <translation>%1 mm² 需要支撑</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 层</translation>
    </message>
    <message>
        <source>Cancelled. The previous results are still shown.</source>
        <translation>已取消。仍显示先前的结果。</translation>
    </message>
    <message>
        <source>Cancelled. Press Plan to start again.</source>
        <translation>已取消。按“规划”重新开始。</translation>
    </message>
    <message>
        <source>The run failed: see the findings.</source>
        <translation>运行失败：参见问题。</translation>
    </message>
    <message>
        <source>Cannot plan: correct the marked setting.</source>
        <translation>无法规划：请更正标出的设置。</translation>
    </message>
    <message>
        <source>planned time %1</source>
        <translation>规划时间 %1</translation>
    </message>
    <message>
        <source>time on the controller %1</source>
        <translation>控制器上的时间 %1</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 个零件</translation>
    </message>
    <message>
        <source>1 tool change</source>
        <translation>换工具 1 次</translation>
    </message>
    <message>
        <source>%1 tool changes</source>
        <translation>换工具 %1 次</translation>
    </message>
    <message>
        <source>not passed: blocking findings</source>
        <translation>未通过：有阻断问题</translation>
    </message>
    <message>
        <source>safe to run, not as asked</source>
        <translation>可安全运行，未达要求</translation>
    </message>
    <message>
        <source>Done. Safe to run, not as asked: %1.</source>
        <translation>完成。可安全运行，未达要求：%1。</translation>
    </message>
    <message>
        <source>safe to run but for your own statements</source>
        <translation>除自定义语句外可安全运行</translation>
    </message>
    <message>
        <source>Done. Safe to run but for your own statements.</source>
        <translation>完成。除自定义语句外可安全运行。</translation>
    </message>
</context>
<context>
    <name>voluta::window::ShortcutsDialog</name>
    <message>
        <source>Keys</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Default key</source>
        <translation>默认快捷键</translation>
    </message>
    <message>
        <source>New key:</source>
        <translation>新快捷键：</translation>
    </message>
    <message>
        <source>This key was removed from “%1”.</source>
        <translation>此快捷键已从“%1”移除。</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新快捷键</translation>
    </message>
</context>
<context>
    <name>voluta::window::SimulatePage</name>
    <message>
        <source>Collision solids</source>
        <translation>碰撞实体</translation>
    </message>
    <message>
        <source>Shows the solids used for collision checks over the arm</source>
        <translation>在机械臂上叠加显示用于碰撞检查的实体</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>运行记录</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Follow the nozzle</source>
        <translation>跟随喷嘴</translation>
    </message>
    <message>
        <source>Keeps the nozzle in the middle of the view</source>
        <translation>让喷嘴保持在视图中央</translation>
    </message>
    <message>
        <source>Plan the motion before you jog the arm.</source>
        <translation>请先规划运动，再点动机械臂。</translation>
    </message>
    <message>
        <source>Kinds of beads, with statistics</source>
        <translation>焊道种类与统计</translation>
    </message>
    <message>
        <source>Colours the beads by kind, with time, share, length and mass of each</source>
        <translation>按种类为焊道着色，并显示各自的时间、占比、长度和重量</translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation>点动机械臂</translation>
    </message>
    <message>
        <source>Moves the arm by hand, by joints or by the nozzle. The plan stays as it is</source>
        <translation>手动移动机械臂，按关节或按喷嘴。规划保持不变</translation>
    </message>
    <message>
        <source>Trace of the nozzle</source>
        <translation>喷嘴轨迹</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Last %1 s</source>
        <translation>最近 %1 s</translation>
    </message>
    <message>
        <source>Whole print</source>
        <translation>整个打印</translation>
    </message>
    <message>
        <source>Solid where the nozzle prints, dashed where it travels</source>
        <translation>打印处为实线，空程处为虚线</translation>
    </message>
    <message>
        <source>Remove the pause before layer %1</source>
        <translation>移除第 %1 层前的暂停</translation>
    </message>
    <message>
        <source>Pause before layer %1</source>
        <translation>第 %1 层前暂停</translation>
    </message>
    <message>
        <source>Event before layer %1…</source>
        <translation>第 %1 层前的事件…</translation>
    </message>
    <message>
        <source>Event before this layer…</source>
        <translation>此层前的事件…</translation>
    </message>
    <message>
        <source>A pause, a wait, an output, another tool or a line of your own</source>
        <translation>暂停、等待、输出、更换工具或自定义语句行</translation>
    </message>
</context>
<context>
    <name>voluta::window::SizesDialog</name>
    <message>
        <source>Sizes from a measured plate</source>
        <translation>由测量板得出尺寸</translation>
    </message>
    <message>
        <source>Plate of %1</source>
        <translation>%1 的测试板</translation>
    </message>
    <message>
        <source>Print the sample plate (File &gt; Samples) with this process, and measure it.</source>
        <translation>用此工艺打印示例板（文件 &gt; 示例）并测量。</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>Use these sizes</source>
        <translation>使用这些尺寸</translation>
    </message>
    <message>
        <source>Size factors %1 (x) and %2 (y), outlines %3, holes %4; the measured sizes fit within %5.</source>
        <translation>尺寸系数 %1 (x) 和 %2 (y)，轮廓 %3，孔 %4；测得尺寸的拟合误差在 %5 以内。</translation>
    </message>
</context>
<context>
    <name>voluta::window::SpacingView</name>
    <message>
        <source>%1–%2 mm: %3 % of the area</source>
        <translation>%1–%2 mm：面积的 %3 %</translation>
    </message>
    <message>
        <source>Layer spacing, share of area by thickness [mm]</source>
        <translation>层间距，各厚度所占面积比例 [mm]</translation>
    </message>
    <message>
        <source>Mean %1 mm. Within %2–%3 mm: %4 %.</source>
        <translation>平均 %1 mm。在 %2–%3 mm 内：%4 %。</translation>
    </message>
    <message>
        <source>Too thin: %1 %.</source>
        <translation>过薄：%1 %。</translation>
    </message>
    <message>
        <source>Too thick: %1 %.</source>
        <translation>过厚：%1 %。</translation>
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
        <translation>更改朝向</translation>
    </message>
</context>
<context>
    <name>voluta::window::StatusLine</name>
    <message>
        <source>about %1 left</source>
        <translation>约剩 %1</translation>
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
        <translation>与其他机器一起打印</translation>
    </message>
    <message>
        <source>Add project…</source>
        <translation>添加项目…</translation>
    </message>
    <message>
        <source>Add this job again</source>
        <translation>再次添加此作业</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save programs…</source>
        <translation>保存程序…</translation>
    </message>
    <message>
        <source>Waits, and what they keep apart</source>
        <translation>等待，以及其避免的碰撞</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>The programs were saved in %1.</source>
        <translation>程序已保存到 %1。</translation>
    </message>
    <message>
        <source>Project of another machine</source>
        <translation>另一台机器的项目</translation>
    </message>
    <message>
        <source>Voluta projects (*.voluta)</source>
        <translation>Voluta 项目 (*.voluta)</translation>
    </message>
    <message>
        <source>Add the project of a machine that works beside this one.</source>
        <translation>添加在本机旁工作的机器的项目。</translation>
    </message>
    <message>
        <source>Place the machines, then find an order of work.</source>
        <translation>放置机器，然后查找工作顺序。</translation>
    </message>
    <message>
        <source>Together %1; one after the other %2; the longest alone %3</source>
        <translation>一起 %1；依次 %2；单独最长 %3</translation>
    </message>
    <message>
        <source>Start the programs in any order: each waits at its first point for the others, whatever their signals are, and ends with its signals off. If one is stopped, stop all, and start all again.</source>
        <translation>以任意顺序启动程序：无论信号状态如何，每个程序都在其第一个点等待其他程序，结束时关闭其信号。如果一个停止，则全部停止并全部重新启动。</translation>
    </message>
    <message>
        <source>Machine %1: marks %2, waits %3, ends after %4</source>
        <translation>机器 %1：标记 %2，等待 %3，在 %4 后结束</translation>
    </message>
    <message>
        <source>Collision: %1 of machine %2 with %3 of machine %4</source>
        <translation>碰撞：机器 %2 的 %1 与机器 %4 的 %3</translation>
    </message>
    <message>
        <source>Machine %1 waits %2 for machine %3</source>
        <translation>机器 %1 等待机器 %3，时长 %2</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1，位于 %2</translation>
    </message>
    <message>
        <source>Folder for all programs</source>
        <translation>存放所有程序的文件夹</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>注意：%1</translation>
    </message>
    <message>
        <source>Move %1 mm further apart</source>
        <translation>再移远 %1 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Minimum distance %1 mm; collisions: %2</source>
        <translation>最小距离 %1 mm；碰撞：%2</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>时间表</translation>
    </message>
    <message>
        <source>Minimum clearance between arms</source>
        <translation>机械臂间最小间隙</translation>
    </message>
</context>
<context>
    <name>voluta::window::TouchDialog</name>
    <message>
        <source>Line %1 is not a point: write y and z, or x, y and z, in mm.</source>
        <translation>第 %1 行不是点：写 y 和 z，或 x、y 和 z，单位 mm。</translation>
    </message>
    <message>
        <source>Place on touched points</source>
        <translation>按触碰点放置</translation>
    </message>
    <message>
        <source>Touch a cylinder along x at three points or more, and enter them in the work frame: y z, or x y z, one point per line [mm].</source>
        <translation>在三个或更多点触碰沿 x 的圆柱，并在工作坐标系中输入：y z 或 x y z，每行一个点 [mm]。</translation>
    </message>
    <message>
        <source>y of the axis in the model</source>
        <translation>模型中轴线的 y</translation>
    </message>
    <message>
        <source>z of the axis in the model</source>
        <translation>模型中轴线的 z</translation>
    </message>
    <message>
        <source>Axis in the model (y, z)</source>
        <translation>模型中的轴线 (y, z)</translation>
    </message>
    <message>
        <source>Move the part</source>
        <translation>移动零件</translation>
    </message>
    <message>
        <source>Centre y %1, z %2 mm; radius %3 mm; points: %4, mean deviation %5 mm.</source>
        <translation>中心 y %1，z %2 mm；半径 %3 mm；点数：%4，平均偏差 %5 mm。</translation>
    </message>
    <message>
        <source>The part is moved by y %1, z %2 mm.</source>
        <translation>零件移动 y %1，z %2 mm。</translation>
    </message>
    <message>
        <source>Touched points</source>
        <translation>触测点</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledCanvas</name>
    <message>
        <source>→ around, ↑ along [mm]</source>
        <translation>→ 周向，↑ 轴向 [mm]</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledDock</name>
    <message>
        <source>Layer %1 of %2</source>
        <translation>层 %1 / %2</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>展开层</translation>
    </message>
</context>
<context>
    <name>voluta::window::UnrolledView</name>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Gap fill</source>
        <translation>间隙填充</translation>
    </message>
    <message>
        <source>Skirt or brim</source>
        <translation>裙边或帽檐</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>支撑</translation>
    </message>
    <message>
        <source>Around %1 mm (%2°), along %3 mm</source>
        <translation>周向 %1 mm (%2°)，轴向 %3 mm</translation>
    </message>
    <message>
        <source>Around %1 mm, along %2 mm</source>
        <translation>周向 %1 mm，轴向 %2 mm</translation>
    </message>
    <message>
        <source>%1 %2, waypoint %3 of %4</source>
        <translation>%1 %2，路径点 %3 / %4</translation>
    </message>
    <message>
        <source>This layer is not wound around an axis.</source>
        <translation>此层未绕轴缠绕。</translation>
    </message>
    <message>
        <source>Unrolled layer</source>
        <translation>展开层</translation>
    </message>
    <message>
        <source>Click a path to find it in the 3D view. Wheel zooms, drag moves, double click shows all.</source>
        <translation>点击路径可在 3D 视图中找到它。滚轮缩放，拖动平移，双击显示全部。</translation>
    </message>
    <message>
        <source>Prime</source>
        <translation>预挤出</translation>
    </message>
    <message>
        <source>Sparse infill</source>
        <translation>稀疏填充</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>桥接</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>纤维带</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>注入</translation>
    </message>
</context>
<context>
    <name>voluta::window::VerifyDialog</name>
    <message>
        <source>Replay findings</source>
        <translation>回放发现的问题</translation>
    </message>
    <message>
        <source>Verify %1</source>
        <translation>验证 %1</translation>
    </message>
    <message>
        <source>Replaying the program against the current plan…</source>
        <translation>正在对照当前规划回放程序…</translation>
    </message>
    <message>
        <source>%1: passed. The program matches the plan.</source>
        <translation>%1：通过。程序与规划一致。</translation>
    </message>
    <message>
        <source>%1: refused. Do not run it on the robot.</source>
        <translation>%1：拒绝。不要在机器人上运行。</translation>
    </message>
    <message>
        <source>Replay findings, the first %1 of %2</source>
        <translation>回放发现的问题，共 %2 个，显示前 %1 个</translation>
    </message>
    <message>
        <source>%1: safe to run, but it does not print the part as asked.</source>
        <translation>%1：可安全运行，但不能按要求打印零件。</translation>
    </message>
    <message>
        <source>%1: safe to run but for your own statements, which nothing checks.</source>
        <translation>%1：除自定义语句外可安全运行；自定义语句未经任何检查。</translation>
    </message>
</context>
<context>
    <name>voluta::window::ViewOptions</name>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>着色依据</translation>
    </message>
    <message>
        <source>Latest</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>层</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>The latest result of the plan</source>
        <translation>规划的最新结果</translation>
    </message>
    <message>
        <source>Layers drawn with their thickness</source>
        <translation>按厚度绘制的层</translation>
    </message>
    <message>
        <source>Tool-paths drawn as beads</source>
        <translation>绘制为挤出线的工具路径</translation>
    </message>
    <message>
        <source>Part surface</source>
        <translation>零件表面</translation>
    </message>
    <message>
        <source>Travel moves</source>
        <translation>空移</translation>
    </message>
    <message>
        <source>True bead width</source>
        <translation>真实线宽</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>剖切面</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>Remove the other side</source>
        <translation>去除另一侧</translation>
    </message>
    <message>
        <source>Position of the section plane</source>
        <translation>剖切面位置</translation>
    </message>
    <message>
        <source>Solid voxels and their growth order</source>
        <translation>实心体素及其生长顺序</translation>
    </message>
    <message>
        <source>Convex front</source>
        <translation>凸前沿</translation>
    </message>
    <message>
        <source>During growth replay: the convex front; the next voxels must be outside it</source>
        <translation>回放生长时：凸前沿；下一批体素必须位于其外</translation>
    </message>
    <message>
        <source>Later voxels faint</source>
        <translation>淡显后续体素</translation>
    </message>
    <message>
        <source>During growth replay: voxels not yet printed</source>
        <translation>回放生长时：尚未打印的体素</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>Pieces printable without support, and their base planes</source>
        <translation>无需支撑即可打印的分块及其底平面</translation>
    </message>
</context>
<context>
    <name>voluta::window::Welcome</name>
    <message>
        <source>Print a part with a robot</source>
        <translation>用机器人打印零件</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>无图像</translation>
    </message>
    <message>
        <source>Drop a mesh (STL, OBJ, PLY, OFF or 3MF), a slicer&apos;s G-code or a Voluta project here.</source>
        <translation>将网格（STL、OBJ、PLY、OFF 或 3MF）、切片软件的 G-code 或 Voluta 项目拖放到此处。</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Sample vase</source>
        <translation>示例花瓶</translation>
    </message>
</context>
</TS>
