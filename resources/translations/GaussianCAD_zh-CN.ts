<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Numbers of the body that are not on the drawing</source>
        <translation>主体中未在图纸上标注的尺寸</translation>
    </message>
    <message>
        <source>Numbers of the body that the drawing tells</source>
        <translation>主体中图纸上标注的尺寸</translation>
    </message>
    <message>
        <source>Colour of the deviation at each point</source>
        <translation>每个点的偏差颜色</translation>
    </message>
    <message>
        <source>Deviation at each point in mm</source>
        <translation>每个点的偏差，单位 mm</translation>
    </message>
    <message>
        <source>The object that was measured</source>
        <translation>被测量的对象</translation>
    </message>
    <message>
        <source>The object that it was measured against</source>
        <translation>测量所依据的对象</translation>
    </message>
    <message>
        <source>The comparison as a page for a browser</source>
        <translation>可在浏览器中查看的比较页面</translation>
    </message>
    <message>
        <source>The result, coloured by its deviation</source>
        <translation>按偏差着色的结果</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>被测量的内容</translation>
    </message>
    <message>
        <source>What it was measured against</source>
        <translation>测量所依据的基准</translation>
    </message>
    <message>
        <source>The file that was measured</source>
        <translation>被测量的文件</translation>
    </message>
    <message>
        <source>The file it was measured against</source>
        <translation>测量所依据的文件</translation>
    </message>
    <message>
        <source>The result when it was compared</source>
        <translation>比较时的结果</translation>
    </message>
    <message>
        <source>The reference when it was compared</source>
        <translation>比较时的参考</translation>
    </message>
    <message>
        <source>The engine&apos;s report as it wrote it</source>
        <translation>引擎报告原文</translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation>这些属性的版本</translation>
    </message>
    <message>
        <source>Whether an object changed since it was compared</source>
        <translation>比较之后是否有对象发生变化</translation>
    </message>
    <message>
        <source>Whether to compare again when an object changes</source>
        <translation>对象变化时是否重新比较</translation>
    </message>
    <message>
        <source>Deviation at the ends of the colour scale</source>
        <translation>色标两端的偏差</translation>
    </message>
    <message>
        <source>What two samples of the reference give</source>
        <translation>参考模型自身两次采样之间的差异</translation>
    </message>
    <message>
        <source>Sum of the mean distances to the nearest point, both ways</source>
        <translation>双向最近点平均距离之和</translation>
    </message>
    <message>
        <source>Largest distance to the nearest point</source>
        <translation>到最近点的最大距离</translation>
    </message>
    <message>
        <source>Mean distance of points matched one to one</source>
        <translation>一一配对的点的平均距离</translation>
    </message>
    <message>
        <source>Mean distance to the surface</source>
        <translation>到表面的平均距离</translation>
    </message>
    <message>
        <source>Common volume over united volume</source>
        <translation>公共体积与合并体积之比</translation>
    </message>
    <message>
        <source>What was corrected by hand, as JSON</source>
        <translation>手工更正的内容，JSON 格式</translation>
    </message>
    <message>
        <source>What the engine read on the drawing</source>
        <translation>引擎从图纸上读出的内容</translation>
    </message>
    <message>
        <source>The corrections that the part follows from</source>
        <translation>得出该零件所依据的更正</translation>
    </message>
    <message>
        <source>What is hidden when a window first shows the group</source>
        <translation>首次在窗口中显示该组时隐藏的内容</translation>
    </message>
    <message>
        <source>Whether the part was checked on the drawing</source>
        <translation>零件是否已与图纸核对</translation>
    </message>
    <message>
        <source>Whether the faces are exact, not triangles</source>
        <translation>各面是否为精确曲面而非三角形</translation>
    </message>
    <message>
        <source>Share of the lines that agree with the drawing&apos;s, 0 to 1</source>
        <translation>与图纸一致的线所占比例，0 到 1</translation>
    </message>
    <message>
        <source>The projection under which the drawing was read</source>
        <translation>读图时采用的投影画法</translation>
    </message>
    <message>
        <source>The drawing with the part&apos;s own lines over it</source>
        <translation>叠加了零件自身图线的图纸</translation>
    </message>
    <message>
        <source>Where the drawing was when it was read</source>
        <translation>读图时图纸所在的位置</translation>
    </message>
    <message>
        <source>The drawing, stored in this document</source>
        <translation>存储在本文档中的图纸</translation>
    </message>
    <message>
        <source>What the engine was asked to do</source>
        <translation>要求引擎执行的内容</translation>
    </message>
    <message>
        <source>Verified, approximate or failed</source>
        <translation>已验证、近似或失败</translation>
    </message>
    <message>
        <source>Why the part is not verified</source>
        <translation>零件未通过验证的原因</translation>
    </message>
    <message>
        <source>Bound that 95 % of the faces&apos; places keep; 0 if it is not known</source>
        <translation>95 % 的面位置不超过的误差上限；未知时为 0</translation>
    </message>
    <message>
        <source>What the engine warns of</source>
        <translation>引擎给出的警告</translation>
    </message>
    <message>
        <source>First or third angle, and how that is known</source>
        <translation>第一角或第三角画法，以及判断依据</translation>
    </message>
    <message>
        <source>Scale of the drawing</source>
        <translation>图纸比例</translation>
    </message>
    <message>
        <source>How the scale is known</source>
        <translation>比例的依据</translation>
    </message>
    <message>
        <source>Where each view is on the drawing, in pixels</source>
        <translation>各视图在图纸上的位置，单位为像素</translation>
    </message>
    <message>
        <source>Share of the drawing&apos;s lines found, and of the part&apos;s lines right</source>
        <translation>找到的图纸线所占比例，以及零件线中正确的比例</translation>
    </message>
    <message>
        <source>Duration of the run</source>
        <translation>运行时长</translation>
    </message>
    <message>
        <source>Duration of each stage</source>
        <translation>各阶段的时长</translation>
    </message>
    <message>
        <source>Versions, device, seed and hash of the drawing</source>
        <translation>版本、设备、随机种子和图纸的哈希值</translation>
    </message>
    <message>
        <source>Which of the solutions was kept by hand</source>
        <translation>手工保留的是哪一个解</translation>
    </message>
    <message>
        <source>Numbers that break the body if they are changed alone by 3 %</source>
        <translation>单独改变 3 % 就会使主体失效的尺寸</translation>
    </message>
    <message>
        <source>How many numbers were not tried for that</source>
        <translation>有多少尺寸没有为此试过</translation>
    </message>
    <message>
        <source>The drawing&apos;s numbers when the body was made</source>
        <translation>生成主体时图纸上的尺寸</translation>
    </message>
    <message>
        <source>The part that this body was made of</source>
        <translation>生成这个主体所用的零件</translation>
    </message>
</context>
<context>
    <name>GaussianCAD</name>
    <message>
        <source>no features were found on it</source>
        <translation>未在其上找到特征</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基体</translation>
    </message>
    <message>
        <source>Body of {name}</source>
        <translation>{name} 的主体</translation>
    </message>
    <message>
        <source>Features: {features}. Numbers from the sheet: {sheet}, measured: {measured}.</source>
        <translation>特征：{features} 个。来自图纸的尺寸：{sheet} 个，测得的：{measured} 个。</translation>
    </message>
    <message>
        <source>From the sheet:</source>
        <translation>来自图纸：</translation>
    </message>
    <message>
        <source>Looking for features</source>
        <translation>正在查找特征</translation>
    </message>
    <message>
        <source>Make Body</source>
        <translation>生成主体</translation>
    </message>
    <message>
        <source>No body was made of {name}: {reason}. The solid stays as it is.</source>
        <translation>未能由 {name} 生成主体：{reason}。实体保持不变。</translation>
    </message>
    <message>
        <source>Not on the sheet:</source>
        <translation>图纸上没有：</translation>
    </message>
    <message>
        <source>Select a reconstruction, or another part with one solid, first.</source>
        <translation>请先选择一个重建结果，或另一个只有一个实体的零件。</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>The part is not in its document any more.</source>
        <translation>该零件已不在其文档中。</translation>
    </message>
    <message>
        <source>The solid of {name} cannot be written: {reason}</source>
        <translation>无法写入 {name} 的实体：{reason}</translation>
    </message>
    <message>
        <source>They stand over a base solid, of which no features are known.</source>
        <translation>它们建立在一个基体之上，该基体没有已知的特征。</translation>
    </message>
    <message>
        <source>To Body</source>
        <translation>转换为主体</translation>
    </message>
    <message>
        <source>the features are of {found} solids instead of {expected}</source>
        <translation>特征属于 {found} 个实体，而应为 {expected} 个</translation>
    </message>
    <message>
        <source>the features do not make one valid solid</source>
        <translation>这些特征未能构成一个有效的实体</translation>
    </message>
    <message>
        <source>there are {found} faces instead of {expected}</source>
        <translation>有 {found} 个面，而应为 {expected} 个</translation>
    </message>
    <message>
        <source>{feature} cannot be made ({reason})</source>
        <translation>无法生成 {feature}（{reason}）</translation>
    </message>
    <message>
        <source>{percent} % of the volume differ</source>
        <translation>体积有 {percent} % 不同</translation>
    </message>
    <message>
        <source>in doubt</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>other lines</source>
        <translation>其他线</translation>
    </message>
    <message>
        <source>in Correct Sheet</source>
        <translation>在“校正图纸”中</translation>
    </message>
    <message>
        <source>here</source>
        <translation>在此</translation>
    </message>
    <message>
        <source>A library broke down in one of the ways in which the solid is looked for. That way was left out: check the part. It is a fault of ours: please report it with the drawing.</source>
        <translation>在寻找实体的一种方法中,某个库发生了崩溃。该方法已被略过:请检查零件。这是我们的错误:请连同图纸一起报告。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Breaks off making the part</source>
        <translation>中止零件的生成</translation>
    </message>
    <message>
        <source>Into</source>
        <translation>放入</translation>
    </message>
    <message>
        <source>A new document</source>
        <translation>新文档</translation>
    </message>
    <message>
        <source>The document into which the part goes</source>
        <translation>零件将放入的文档</translation>
    </message>
    <message>
        <source>The sheet was photographed at a slant of about {degrees} degrees and was straightened by its lines. Check the part&apos;s measures.</source>
        <translation>图纸是以约 {degrees} 度的倾斜角拍摄的,已按其线条校正。请检查零件的尺寸。</translation>
    </message>
    <message>
        <source>The sheet was photographed at a slant of about {degrees} degrees and was straightened by its lines. How wide it is for its height may be some per cent off: check the part&apos;s measures.</source>
        <translation>图纸是以约 {degrees} 度的倾斜角拍摄的,已按其线条校正。其宽高比可能有百分之几的误差:请检查零件的尺寸。</translation>
    </message>
    <message>
        <source>What surrounds the paper in the picture was left out.</source>
        <translation>图片中纸张周围的内容已被忽略。</translation>
    </message>
    <message>
        <source>How exact its measures are is not known: the views fit no one scale</source>
        <translation>尺寸的精度未知:各视图不符合同一比例</translation>
    </message>
    <message>
        <source>The file has entities that cannot be read and were left out: {kinds}. What they show may be missing.</source>
        <translation>文件中有无法读取的实体，已略去：{kinds}。它们所表示的内容可能缺失。</translation>
    </message>
    <message>
        <source>The lines around everything were taken for a frame. If they are the part&apos;s outline, and what lies within is a pocket, the part is larger than what was made.</source>
        <translation>包围全部内容的线条被当作图框。如果它们是零件的轮廓，而其中的图形是凹槽，则零件比所生成的更大。</translation>
    </message>
    <message>
        <source>A note names {noted} as the unit, but the numbers fit what the file draws in {taken}, which was taken. Check the part&apos;s size.</source>
        <translation>注释给出的单位是 {noted}，但数字与文件以 {taken} 绘制的内容相符，因此采用了后者。请检查零件尺寸。</translation>
    </message>
    <message>
        <source>The dimensions say that the part is {share} times as large as the file draws it. They were taken: check the part&apos;s size.</source>
        <translation>按尺寸标注，零件是文件所绘大小的 {share} 倍。已采用标注：请检查零件尺寸。</translation>
    </message>
    <message>
        <source>The file says the unit of its lengths, and no scale: the part was taken to be drawn in its own size. Set a length under Scale if it is not.</source>
        <translation>文件给出了长度单位而没有比例：假定零件按实际大小绘制。如果不是，请在“比例”下设置一个长度。</translation>
    </message>
    <message>
        <source>The file says neither its unit nor how large its paper is. Set a length under Scale.</source>
        <translation>文件既没有给出单位，也没有给出图纸大小。请在“比例”下设置一个长度。</translation>
    </message>
    <message>
        <source>The file has entities that cannot be read and were left out: {kinds}.</source>
        <translation>文件中有无法读取的实体，已略去：{kinds}。</translation>
    </message>
    <message>
        <source>The lines around everything were taken for a frame, not for the part&apos;s outline.</source>
        <translation>包围全部内容的线条被当作图框，而不是零件的轮廓。</translation>
    </message>
    <message>
        <source>Hole Goes Through</source>
        <translation>通孔</translation>
    </message>
    <message>
        <source>Depth of Hole…</source>
        <translation>孔的深度…</translation>
    </message>
    <message>
        <source>Select all like this</source>
        <translation>选中所有同类</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>可见线</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隐藏线</translation>
    </message>
    <message>
        <source>centre line</source>
        <translation>中心线</translation>
    </message>
    <message>
        <source>tangent edge</source>
        <translation>切边</translation>
    </message>
    <message>
        <source>dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>cutting line</source>
        <translation>剖切线</translation>
    </message>
    <message>
        <source>hatching</source>
        <translation>剖面线</translation>
    </message>
    <message>
        <source>extension line</source>
        <translation>尺寸界线</translation>
    </message>
    <message>
        <source>leader</source>
        <translation>引线</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>图框</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>line of a pictorial view</source>
        <translation>立体图中的线</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Ignore Area</source>
        <translation>忽略区域</translation>
    </message>
    <message>
        <source>Pick from Ink</source>
        <translation>从墨线拾取</translation>
    </message>
    <message>
        <source>Cutting Plane</source>
        <translation>剖切面</translation>
    </message>
    <message>
        <source>section</source>
        <translation>剖视图</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>局部放大图</translation>
    </message>
    <message>
        <source>auxiliary view</source>
        <translation>斜视图</translation>
    </message>
    <message>
        <source>pictorial</source>
        <translation>轴测图</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>图纸</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Lines of the Part</source>
        <translation>零件的线</translation>
    </message>
    <message>
        <source>Other Lines</source>
        <translation>其他线</translation>
    </message>
    <message>
        <source>Numbers and Notes</source>
        <translation>数字和注释</translation>
    </message>
    <message>
        <source>Cutting Planes</source>
        <translation>剖切面</translation>
    </message>
    <message>
        <source>Problems and Disagreements</source>
        <translation>问题与不一致之处</translation>
    </message>
    <message>
        <source>front</source>
        <translation>主视图</translation>
    </message>
    <message>
        <source>top</source>
        <translation>俯视图</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右视图</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左视图</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>仰视图</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>后视图</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>点击查看位置</translation>
    </message>
    <message>
        <source>The engine broke off: {reason}</source>
        <translation>引擎中断：{reason}</translation>
    </message>
    <message>
        <source>The part lacks a line of {0} mm here</source>
        <translation>零件在此处缺少一条 {0} mm 的线</translation>
    </message>
    <message>
        <source>The part has a line of {0} mm here that the sheet has not</source>
        <translation>零件在此处有一条图纸上没有的 {0} mm 的线</translation>
    </message>
    <message>
        <source>These lines contradict each other</source>
        <translation>这些线互相矛盾</translation>
    </message>
    <message>
        <source>Assumed: {0}</source>
        <translation>假定：{0}</translation>
    </message>
    <message>
        <source>Otherwise: {0}</source>
        <translation>否则：{0}</translation>
    </message>
    <message>
        <source>Yes, Through</source>
        <translation>是，通孔</translation>
    </message>
    <message>
        <source>Its ink looks like that.</source>
        <translation>从墨迹的样子判断。</translation>
    </message>
    <message>
        <source>Its width, color or rhythm tells it.</source>
        <translation>由线宽、颜色或线段节奏判定。</translation>
    </message>
    <message>
        <source>The rest of its line tells it, against its look.</source>
        <translation>由这条线的其余部分判断，与外观不符。</translation>
    </message>
    <message>
        <source>The figure that it is a part of tells it.</source>
        <translation>由它所属的图形判断。</translation>
    </message>
    <message>
        <source>As an edge it would end at no other edge.</source>
        <translation>若为棱边，其端点不接任何其他棱边。</translation>
    </message>
    <message>
        <source>Without it other edges would end at nothing.</source>
        <translation>没有它，其他棱边的端点将悬空。</translation>
    </message>
    <message>
        <source>Its dashes, or its pen, tell it.</source>
        <translation>由虚线段或线宽判断。</translation>
    </message>
    <message>
        <source>In doubt: {kind}, {share} sure.</source>
        <translation>存疑：{kind}，把握 {share}。</translation>
    </message>
    <message>
        <source>More lines in doubt: {0}</source>
        <translation>其他存疑的线：{0}</translation>
    </message>
    <message>
        <source>Yes: {0}</source>
        <translation>是：{0}</translation>
    </message>
    <message>
        <source>No: {0}</source>
        <translation>否：{0}</translation>
    </message>
    <message>
        <source>No, so Deep…</source>
        <translation>不，深度为…</translation>
    </message>
    <message>
        <source>All {0} Go Through</source>
        <translation>全部 {0} 个都贯通</translation>
    </message>
    <message>
        <source>The size is not known: tell a length</source>
        <translation>尺寸未知：请指定一个长度</translation>
    </message>
    <message>
        <source>Measures to ±{0} mm</source>
        <translation>尺寸误差不超过 ±{0} mm</translation>
    </message>
    <message>
        <source>Verified: the part has the sheet&apos;s lines, no others</source>
        <translation>已验证：零件具有图纸上的全部线，且没有多余的线</translation>
    </message>
    <message>
        <source>Approximate: check the part against the sheet</source>
        <translation>近似：请对照图纸检查零件</translation>
    </message>
    <message>
        <source>No part follows from the sheet as it is</source>
        <translation>按图纸现状得不出零件</translation>
    </message>
    <message>
        <source>The sheet is being read…</source>
        <translation>正在读取图纸…</translation>
    </message>
    <message>
        <source>The corrections beside the sheet are of another version of it: they were left out, and will be kept as a file of their own.</source>
        <translation>图纸旁的更正属于图纸的另一个版本：已略过，并将另存为单独的文件。</translation>
    </message>
    <message>
        <source>Nothing meets this end</source>
        <translation>此端点没有线相接</translation>
    </message>
    <message>
        <source>Corrections by hand: {0}</source>
        <translation>手工更正：{0}</translation>
    </message>
    <message>
        <source>Box a View</source>
        <translation>框选视图</translation>
    </message>
    <message>
        <source>Draw a Line</source>
        <translation>画线</translation>
    </message>
    <message>
        <source>Tell a Length</source>
        <translation>指定长度</translation>
    </message>
    <message>
        <source>Set the Plane</source>
        <translation>设置剖切面</translation>
    </message>
    <message>
        <source>Other Projection</source>
        <translation>另一种投影画法</translation>
    </message>
    <message>
        <source>Close Gaps</source>
        <translation>封闭缺口</translation>
    </message>
    <message>
        <source>It Belongs There</source>
        <translation>应当有这条线</translation>
    </message>
    <message>
        <source>Tangent Edge</source>
        <translation>切边</translation>
    </message>
    <message>
        <source>Erase It</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读图…</translation>
    </message>
    <message>
        <source>Making the part…</source>
        <translation>正在生成零件…</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Length between the two points in mm:</source>
        <translation>两点之间的长度，单位 mm：</translation>
    </message>
    <message>
        <source>What “{0}” gives, in mm:</source>
        <translation>“{0}”表示的尺寸，单位 mm：</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Depth of the hole in mm:</source>
        <translation>孔的深度，单位 mm：</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>There is no line of a view at this place</source>
        <translation>此处没有任何视图的线</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影画法</translation>
    </message>
    <message>
        <source>First angle</source>
        <translation>第一角画法</translation>
    </message>
    <message>
        <source>Third angle</source>
        <translation>第三角画法</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Solve as I Go</source>
        <translation>随改随解</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Makes the part (Enter)</source>
        <translation>生成零件（回车键）</translation>
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
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>No Python from 3.11 to 3.14 with its venv module was found. Install one (on Debian: apt-get install python3-venv), then try again.</source>
        <translation>未找到带 venv 模块的 Python 3.11 至 3.14。请安装一个（Debian：apt-get install python3-venv），然后重试。</translation>
    </message>
    <message>
        <source>Making the environment</source>
        <translation>正在创建环境</translation>
    </message>
    <message>
        <source>The installation was cancelled.</source>
        <translation>安装已取消。</translation>
    </message>
    <message>
        <source>{step} failed: {reason}</source>
        <translation>{step}失败：{reason}</translation>
    </message>
    <message>
        <source>Looking for damaged files</source>
        <translation>正在查找损坏的文件</translation>
    </message>
    <message>
        <source>The repair was cancelled. Repair again to finish it.</source>
        <translation>修复已取消。请再次修复以完成。</translation>
    </message>
    <message>
        <source>Looking for the small build of PyTorch</source>
        <translation>查找 PyTorch 的小型版本</translation>
    </message>
    <message>
        <source>The build of PyTorch for processors was found neither in the package index that pip is set up for nor in {index}. Look whether the network is there, or choose the build for NVIDIA cards, which works without such a card, too.</source>
        <translation>在 pip 所设的软件包索引和 {index} 中都找不到处理器版的 PyTorch。请检查网络，或选择 NVIDIA 显卡版，它在没有显卡时也能运行。</translation>
    </message>
    <message>
        <source>Reinstalling damaged packages</source>
        <translation>正在重新安装损坏的软件包</translation>
    </message>
    <message>
        <source>Linking the engine</source>
        <translation>链接引擎</translation>
    </message>
    <message>
        <source>Checking the engine</source>
        <translation>检查引擎</translation>
    </message>
    <message>
        <source>Compiling the engine&apos;s kernels</source>
        <translation>编译引擎的计算核心</translation>
    </message>
    <message>
        <source>Downloading and installing packages</source>
        <translation>下载并安装软件包</translation>
    </message>
    <message>
        <source>named by the environment variable GAUSSIANCAD_PYTHON</source>
        <translation>由环境变量 GAUSSIANCAD_PYTHON 指定</translation>
    </message>
    <message>
        <source>named in the preferences</source>
        <translation>在首选项中指定</translation>
    </message>
    <message>
        <source>installed by GaussianCAD</source>
        <translation>由 GaussianCAD 安装</translation>
    </message>
    <message>
        <source>found beside the addon</source>
        <translation>在插件旁找到</translation>
    </message>
    <message>
        <source>The GaussianCAD engine is not installed. Choose GaussianCAD &gt; Install Engine, or name the engine&apos;s Python in Edit &gt; Preferences &gt; GaussianCAD.</source>
        <translation>尚未安装 GaussianCAD 引擎。请选择 GaussianCAD &gt; 安装引擎，或在 编辑 &gt; 首选项 &gt; GaussianCAD 中指定引擎的 Python。</translation>
    </message>
    <message>
        <source>GAUSSIANCAD_PYTHON names {path}, which is not a program that can be run. Correct the variable or unset it.</source>
        <translation>GAUSSIANCAD_PYTHON 指定的 {path} 不是可运行的程序。请改正或取消该变量。</translation>
    </message>
    <message>
        <source>The preferences name {path} as the engine&apos;s Python, which is not a program that can be run. Correct it in Edit &gt; Preferences &gt; GaussianCAD.</source>
        <translation>首选项指定的引擎 Python {path} 不是可运行的程序。请在 编辑 &gt; 首选项 &gt; GaussianCAD 中改正。</translation>
    </message>
    <message>
        <source>The engine&apos;s report {path} cannot be read ({reason}). Run it again; if that does not help, choose GaussianCAD &gt; Check Engine.</source>
        <translation>无法读取引擎的报告 {path}（{reason}）。请重新运行；如果仍不行，请选择 GaussianCAD &gt; 检查引擎。</translation>
    </message>
    <message>
        <source>A mirror image of the result fits better. Check the projection and the views.</source>
        <translation>结果的镜像更吻合。请检查投影画法和各视图。</translation>
    </message>
    <message>
        <source>The result is {ratio} times as large as the reference: their units differ. Scale the result by {factor} to have it in millimetres.</source>
        <translation>结果是参考的 {ratio} 倍大：两者单位不同。请将结果按 {factor} 缩放为毫米。</translation>
    </message>
    <message>
        <source>Not closed: {model} (open edges: {count}). Its volume is not certain, and distances from it have no sign.</source>
        <translation>未封闭：{model}（开放边数：{count}）。其体积不确定，到它的距离没有正负号。</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s geometry check refuses this solid: {model}. Its volume may be wrong.</source>
        <translation>FreeCAD 的几何检查不接受该实体：{model}。其体积可能有误。</translation>
    </message>
    <message>
        <source>Only surfaces that do not close up to a solid: {model}. Its volume is not certain, and distances from it have no sign.</source>
        <translation>只有不能围成实体的曲面：{model}。其体积不确定，到它的距离没有正负号。</translation>
    </message>
    <message>
        <source>Surfaces without a solid: {model}. Sewn together they are closed, and are measured as a solid.</source>
        <translation>只有曲面而没有实体：{model}。缝合后是封闭的，按实体测量。</translation>
    </message>
    <message>
        <source>Faces beside the solids are not measured: {model} (faces: {count}). Remove them, or make solids of them.</source>
        <translation>实体以外的面不参与测量：{model}（面数：{count}）。请删除它们，或把它们做成实体。</translation>
    </message>
    <message>
        <source>Solids that touch or overlap are measured as one body, without the faces between them: {model} (solids: {count}).</source>
        <translation>相接触或重叠的实体按一个整体测量，不含它们之间的面：{model}（实体数：{count}）。</translation>
    </message>
    <message>
        <source>Closed, but without a volume: {model}.</source>
        <translation>封闭但没有体积：{model}。</translation>
    </message>
    <message>
        <source>Result: bodies {result_bodies}, through holes {result_holes}, cavities {result_cavities}. Reference: bodies {reference_bodies}, through holes {reference_holes}, cavities {reference_cavities}.</source>
        <translation>结果：实体 {result_bodies}，通孔 {result_holes}，内腔 {result_cavities}。参考：实体 {reference_bodies}，通孔 {reference_holes}，内腔 {reference_cavities}。</translation>
    </message>
    <message>
        <source>The models cannot be compared: one is damaged. Export it again.</source>
        <translation>两个模型无法比较：其中一个已损坏。请重新导出。</translation>
    </message>
    <message>
        <source>The model cannot be drawn: it is damaged. Export it again.</source>
        <translation>无法绘制该模型：模型已损坏。请重新导出。</translation>
    </message>
    <message>
        <source>The file is no model. Choose a STEP, BREP, STL, PLY or OBJ file.</source>
        <translation>该文件不是模型。请选择 STEP、BREP、STL、PLY 或 OBJ 文件。</translation>
    </message>
    <message>
        <source>The model&apos;s file is damaged, or of another format. Export it again.</source>
        <translation>模型文件已损坏，或是其他格式。请重新导出。</translation>
    </message>
    <message>
        <source>The file holds no solid and no surfaces. Export a solid or its faces.</source>
        <translation>文件中没有实体也没有曲面。请导出实体或其各个面。</translation>
    </message>
    <message>
        <source>The model has no surface. Export it with its faces.</source>
        <translation>模型没有表面。请连同各个面一起导出。</translation>
    </message>
    <message>
        <source>The model is points without faces. Make a surface of them first.</source>
        <translation>模型只有点而没有面。请先由点生成表面。</translation>
    </message>
    <message>
        <source>The model&apos;s file is cut off or damaged. Export it again.</source>
        <translation>模型文件不完整或已损坏。请重新导出。</translation>
    </message>
    <message>
        <source>The model&apos;s file is too large. Export it with fewer triangles.</source>
        <translation>模型文件过大。请用较少的三角形导出。</translation>
    </message>
    <message>
        <source>The model is too small, or too far from the origin, to be measured. Export it in millimetres, near the origin.</source>
        <translation>模型太小，或离原点太远，无法测量。请以毫米为单位、在原点附近导出。</translation>
    </message>
    <message>
        <source>The models differ too much in size to be compared. Check that these are the right ones.</source>
        <translation>两个模型大小相差太多，无法比较。请检查是否选对了模型。</translation>
    </message>
    <message>
        <source>No exact solid was found. The model is a surface that fills what the outlines leave: measure nothing from it.</source>
        <translation>未找到精确实体。该模型是填满各轮廓所留空间的表面：请勿在其上量取尺寸。</translation>
    </message>
    <message>
        <source>The exact solid that fits best has only {percent} % of the drawing&apos;s lines and was not kept. Check {canvas} whether the lines were read right.</source>
        <translation>最吻合的精确实体只具有图纸上 {percent} % 的线，未予保留。请{canvas}检查各线是否读对。</translation>
    </message>
    <message>
        <source>No solid has all lines as they were read. This part is a stack of slabs along {axis} that explains {percent} % of them. Check {canvas} which lines are wrong.</source>
        <translation>没有任何实体具有所读出的全部线条。此零件是沿 {axis} 方向层叠的板，能解释其中 {percent} % 的线。请{canvas}检查哪些线有误。</translation>
    </message>
    <message>
        <source>This part, a stack of slabs along {axis}, has all lines of the drawing, but nothing proves that no other part has them. Compare it with the sheet.</source>
        <translation>此零件由沿 {axis} 方向层叠的板构成，具有图纸上的全部线条，但无法证明没有其他零件也具有这些线条。请与图纸对照。</translation>
    </message>
    <message>
        <source>The part is {count} bodies: the sheet shows several, or a line is missing that joins them.</source>
        <translation>该零件由 {count} 个实体组成：图纸显示了多个实体，或者缺少一条将它们连接起来的线。</translation>
    </message>
    <message>
        <source>The lines of the views contradict each other, so that no solid has them all. Check {canvas} whether a line was read wrong.</source>
        <translation>各视图的线互相矛盾，没有实体能同时具有它们。请{canvas}检查是否有线读错。</translation>
    </message>
    <message>
        <source>Lines contradict each other as they were read, and are marked on the sheet: one was read wrong, or another is missing. Correct it {canvas}.</source>
        <translation>所读到的线条相互矛盾，已在图纸上标出：其中一条读错，或缺少另一条。请{canvas}校正。</translation>
    </message>
    <message>
        <source>The lines contradict each other as they were read. They would agree if the view “{view}” had one more {linetype}: draw it {canvas}.</source>
        <translation>按读出的结果，各线互相矛盾。如果“{view}”多一条{linetype}，各线就会一致：请{canvas}画出它。</translation>
    </message>
    <message>
        <source>The lines contradict each other as they were read. They would agree without one {linetype} of the view “{view}”: erase it {canvas} if it is wrong.</source>
        <translation>按读出的结果，各线互相矛盾。如果去掉“{view}”的一条{linetype}，各线就会一致：如果它是错的，请{canvas}删除。</translation>
    </message>
    <message>
        <source>The lines contradict each other as they were read. They would agree if another line of the view “{view}” were a {linetype}: change it {canvas} if it was read wrong.</source>
        <translation>按读出的结果，各线互相矛盾。如果“{view}”的另一条线是{linetype}，各线就会一致：如果它读错了，请{canvas}更改。</translation>
    </message>
    <message>
        <source>What fits the lines best does not close up to a solid: lines are missing or wrong. Check them {canvas}.</source>
        <translation>与各线最吻合的形状不能封闭成实体：有线缺失或错误。请{canvas}检查。</translation>
    </message>
    <message>
        <source>The drawing has too many lines for an exact solid. Draw fewer of them on one sheet.</source>
        <translation>图纸的线太多，无法得出精确实体。请在一张图纸上少画一些。</translation>
    </message>
    <message>
        <source>The lines of the drawing are too many, or cross each other too often, to be told apart. Draw fewer of them on one sheet, or cut the views out of the picture.</source>
        <translation>图纸的线太多，或相互交叉太频繁，无法区分。请在一张图纸上少画一些线，或从图片中裁出各视图。</translation>
    </message>
    <message>
        <source>The drawing has more separate strokes than can be followed ({most}). Draw fewer of them on one sheet, or cut the views out of it.</source>
        <translation>图纸的独立笔画超过可跟踪的数量（{most}）。请在一张图纸上少画一些，或裁出各视图。</translation>
    </message>
    <message>
        <source>The solid is not one valid closed body.</source>
        <translation>该实体不是一个有效的封闭体。</translation>
    </message>
    <message>
        <source>{count} different solids have the lines of this drawing. Choose the one that is meant with Choose among Solutions.</source>
        <translation>有 {count} 个不同的实体符合这张图纸的线。请用“在多个解中选择”选出所要的一个。</translation>
    </message>
    <message>
        <source>The views fit different solids in first and in third angle. Choose the angle under Projection.</source>
        <translation>按第一角和第三角画法，各视图对应不同的实体。请在“投影画法”中选择画法。</translation>
    </message>
    <message>
        <source>The search for solids with these lines was not completed: there may be others.</source>
        <translation>对符合这些线的实体的搜索未完成：可能还有其他实体。</translation>
    </message>
    <message>
        <source>The search for solids took much longer than usual and was ended. Close other programs and run the drawing again.</source>
        <translation>实体搜索的时间远超平常，已被终止。请关闭其他程序后重新运行该图纸。</translation>
    </message>
    <message>
        <source>The views may fit a solid in the other projection as well. Choose first or third angle under Projection.</source>
        <translation>按另一种投影画法，各视图可能也符合某个实体。请在“投影画法”中选择第一角或第三角画法。</translation>
    </message>
    <message>
        <source>The drawing has more lines than can be understood together. Draw fewer of them on one sheet.</source>
        <translation>图纸的线多到无法一并理解。请在一张图纸上少画一些。</translation>
    </message>
    <message>
        <source>The part does not have all lines of the drawing, or it has others.</source>
        <translation>零件没有图纸上的全部线，或者有多余的线。</translation>
    </message>
    <message>
        <source>The part lacks lines of the drawing; the longest one, of {length_mm} mm, is in the view “{view}”.</source>
        <translation>零件缺少图纸上的线；最长的一条为 {length_mm} mm，位于“{view}”中。</translation>
    </message>
    <message>
        <source>The part has lines that the drawing does not show; the longest one, of {length_mm} mm, is in the view “{view}”.</source>
        <translation>零件有图纸上未画出的线；最长的一条为 {length_mm} mm，位于“{view}”中。</translation>
    </message>
    <message>
        <source>The surface does not have all lines of these views, or it has others: {views}.</source>
        <translation>表面没有这些视图的全部线，或者有多余的线：{views}。</translation>
    </message>
    <message>
        <source>Lines that nearly meet were taken to meet: small steps may be missing.</source>
        <translation>几乎相接的线被当作相接：可能缺少小台阶。</translation>
    </message>
    <message>
        <source>In the view “{view}” the drawn line lies {distance_mm} mm beside the part&apos;s: a curve may have been misread there.</source>
        <translation>在“{view}”中，图线与零件的线相距 {distance_mm} mm：该处可能有曲线读错。</translation>
    </message>
    <message>
        <source>A line of the drawing lies {distance_mm} mm beside the part&apos;s: a small step may be missing.</source>
        <translation>图纸上有一条线与零件的线相距 {distance_mm} mm：可能缺少一个小台阶。</translation>
    </message>
    <message>
        <source>The views and the part differ by up to {distance_mm} mm in size: a small step may be missing.</source>
        <translation>视图与零件的大小最多相差 {distance_mm} mm：可能缺少一个小台阶。</translation>
    </message>
    <message>
        <source>Not used: {kind}. What it shows of the part may be missing.</source>
        <translation>未使用：{kind}。其中表达的零件内容可能缺失。</translation>
    </message>
    <message>
        <source>Groups of lines belong to no view and are large enough to be one ({count}). Box them as views {canvas} if they show the part.</source>
        <translation>有些线组不属于任何视图，但大到可能是视图（{count} 组）。如果它们表达零件，请{canvas}将其框选为视图。</translation>
    </message>
    <message>
        <source>Lines that cross a view in another line width were not used ({count}). If they are edges of the part, make them visible lines {canvas}.</source>
        <translation>有些以另一种线宽穿过视图的线未被使用（{count} 条）。如果它们是零件的棱边，请{canvas}将其设为可见线。</translation>
    </message>
    <message>
        <source>The lengths of {earlier_mm} mm and {last_mm} mm that you told contradict each other. The last one was taken. Tell one of them again, or take it back.</source>
        <translation>您指定的长度 {earlier_mm} mm 和 {last_mm} mm 相互矛盾，采用了后一个。请重新指定其中一个，或将其撤销。</translation>
    </message>
    <message>
        <source>Corrections that no longer find what they corrected: {count}. Look at them again {canvas}.</source>
        <translation>找不到原更正对象的更正：{count} 处。请{canvas}再看一下。</translation>
    </message>
    <message>
        <source>No view has a hidden line. It was assumed that nothing lies inside the part that no view shows.</source>
        <translation>没有任何视图画有隐藏线。假定零件内部没有各视图未表达的结构。</translation>
    </message>
    <message>
        <source>These views have no hidden line: {views}. It was assumed that none was left out; otherwise another solid fits as well, see Choose among Solutions.</source>
        <translation>这些视图没有隐藏线：{views}。假定没有省略隐藏线；否则还有其他实体符合，见“在多个解中选择”。</translation>
    </message>
    <message>
        <source>The solid has long faces too narrow for any view to show: lines that belong together may have been read apart.</source>
        <translation>实体有长而窄的面，窄到任何视图都无法表达：本应重合的线可能被分开读取。</translation>
    </message>
    <message>
        <source>Hidden lines as short as a dash look like visible ones. Some were taken for the other kind, as the other views have it.</source>
        <translation>短至一个短划的隐藏线看起来像可见线。有些线已按其他视图改判类型。</translation>
    </message>
    <message>
        <source>The projection symbol says {symbol}, but the lines fit {other} better. Taken was {taken}; choose under Projection if it is the other.</source>
        <translation>投影符号表示{symbol}，但各线更符合{other}。已采用{taken}；如果应为另一种，请在“投影画法”中选择。</translation>
    </message>
    <message>
        <source>The drawing&apos;s dimensions agree on {sheet} mm per pixel, but the scale that was set gives {told}. The dimensions were not used: check what is set under Scale.</source>
        <translation>图纸上的尺寸一致表明每像素 {sheet} mm，而所设的比例为 {told}。这些尺寸未被使用：请检查“比例”中的设置。</translation>
    </message>
    <message>
        <source>The drawing has only two directions of view: what a third would show is not known.</source>
        <translation>图纸只有两个投影方向：第三个方向会表达的内容未知。</translation>
    </message>
    <message>
        <source>Used as a view: {kind}. What was cut away in front of the cut is shown by no line.</source>
        <translation>当作视图使用：{kind}。剖切面之前被切去的部分没有线表达。</translation>
    </message>
    <message>
        <source>The note “{note}” speaks of {count} holes, and the view “{view}” has {found} of that kind: the note was taken for all of them.</source>
        <translation>注释“{note}”指 {count} 个孔，而“{view}”中有 {found} 个这样的孔：该注释被视为指所有这些孔。</translation>
    </message>
    <message>
        <source>The drawing has one view; what a second would show was assumed.</source>
        <translation>图纸只有一个视图；第二个视图会表达的内容是假定的。</translation>
    </message>
    <message>
        <source>The drawing has one view with diameters across its axis: a turned part was assumed. If it is none, another view is needed.</source>
        <translation>图纸只有一个视图，并标有垂直于轴线的直径：假定为回转体零件。如果不是，则需要另一个视图。</translation>
    </message>
    <message>
        <source>The drawing has one view and a thickness: it was assumed that the part is of that thickness everywhere and that what is drawn inside goes through.</source>
        <translation>图纸只有一个视图和一个厚度：假定零件处处为该厚度，且内部所画的结构均贯通。</translation>
    </message>
    <message>
        <source>A view is broken, so that its length is not as drawn. Set a length along another axis under Scale.</source>
        <translation>有一个视图采用断开画法，其长度与所画的不同。请在“比例”中设置沿另一轴的长度。</translation>
    </message>
    <message>
        <source>A view is drawn up to its centre line: what lies beyond was taken as its mirror image.</source>
        <translation>有一个视图只画到中心线：另一半按镜像处理。</translation>
    </message>
    <message>
        <source>{count} holes of {diameter_mm} mm in the view “{view}” were taken to go through, as nothing tells their depth.</source>
        <translation>视图“{view}”中 {count} 个 {diameter_mm} mm 的孔假定为通孔，因为没有任何内容说明其深度。</translation>
    </message>
    <message>
        <source>The hole of {diameter_mm} mm in the view “{view}” was taken to go through, as nothing tells its depth.</source>
        <translation>“{view}”中直径 {diameter_mm} mm 的孔被视为通孔，因为没有任何内容说明其深度。</translation>
    </message>
    <message>
        <source>Section {label} was taken to cut through the middle of the part, as it has no cutting line.</source>
        <translation>剖视图 {label} 没有剖切线，假定它从零件中间剖开。</translation>
    </message>
    <message>
        <source>A section without a title was taken to cut through the middle of the part, as it has no cutting line.</source>
        <translation>有一个没有标题的剖视图也没有剖切线，假定它从零件中间剖开。</translation>
    </message>
    <message>
        <source>There are bores, pockets or cavities that only hidden lines would show.</source>
        <translation>存在只有隐藏线才能表达的孔、凹槽或内腔。</translation>
    </message>
    <message>
        <source>It ends inside: give its depth in a note, or draw its hidden lines.</source>
        <translation>孔止于零件内部：请在注释中给出深度，或画出其隐藏线。</translation>
    </message>
    <message>
        <source>It cuts elsewhere: draw its cutting line.</source>
        <translation>剖切在别处：请画出其剖切线。</translation>
    </message>
    <message>
        <source>It is another part with the same view.</source>
        <translation>是另一个具有相同视图的零件。</translation>
    </message>
    <message>
        <source>The lines fit both {taken} and {other}. Taken was {taken}; choose under Projection if it is the other.</source>
        <translation>各线既符合{taken}也符合{other}。已采用{taken}；如果应为另一种，请在“投影画法”中选择。</translation>
    </message>
    <message>
        <source>Dimensions do not fit the scale of the others ({numbers}): they were misread, or the drawing is not to scale there.</source>
        <translation>有些尺寸与其他尺寸的比例不符（{numbers}）：它们被读错，或该处未按比例绘制。</translation>
    </message>
    <message>
        <source>The sheet is so large that it was read at a lower resolution: measures are known less well. Cut out the views to have them read as they are.</source>
        <translation>图纸过大，已按较低分辨率读取：尺寸精度较低。请裁出各视图，以便按原样读取。</translation>
    </message>
    <message>
        <source>The trained network that tells edges from dimensions is missing or damaged: the picture was read by rules. Repair the engine under Check Engine.</source>
        <translation>区分轮廓线与尺寸线的训练网络缺失或已损坏：该图片按规则读取。请在“检查引擎”中修复引擎。</translation>
    </message>
    <message>
        <source>Lines that may be edges of the part or annotation: {count}. Look at them {canvas}.</source>
        <translation>有 {count} 条线可能是零件的边，也可能是标注。请{canvas}查看。</translation>
    </message>
    <message>
        <source>The engine was installed for exact solids only: no surface was made. GaussianCAD &gt; Install Engine has one that makes both.</source>
        <translation>引擎仅为精确实体而安装：没有生成表面。GaussianCAD &gt; 安装引擎 中有两者都能生成的引擎。</translation>
    </message>
    <message>
        <source>The sheet has no readable scale: 1:1 was assumed. Set a length under Scale if it is another.</source>
        <translation>图纸上没有可读的比例：假定为 1:1。如果不是，请在“比例”中设置一个长度。</translation>
    </message>
    <message>
        <source>The picture has {across} pixels an inch across and {down} down: it was resampled to {dpi} both ways.</source>
        <translation>图片横向每英寸 {across} 像素，纵向 {down} 像素：已在两个方向重新采样为 {dpi}。</translation>
    </message>
    <message>
        <source>Page 1 shows no views that belong together. Page {page} of {pages}, which brings them together, was taken.</source>
        <translation>第 1 页没有彼此相属的视图。已采用把它们放在一起的第 {page} 页（共 {pages} 页）。</translation>
    </message>
    <message>
        <source>The scale is not known: the longest edge was made 100 mm. Set a length under Scale.</source>
        <translation>比例未知：最长的边取为 100 mm。请在“比例”中设置一个长度。</translation>
    </message>
    <message>
        <source>Corrections by hand that were taken: {count}. The result is checked by the sheet as corrected.</source>
        <translation>已采用的手工更正：{count} 处。结果按更正后的图纸检查。</translation>
    </message>
    <message>
        <source>The views differ by {spread_mm} mm in the part&apos;s extent along {axis}: the mean was taken.</source>
        <translation>各视图中零件沿 {axis} 的长度相差 {spread_mm} mm：取了平均值。</translation>
    </message>
    <message>
        <source>The SVG refers to other files, which are never opened: what they hold is missing.</source>
        <translation>该 SVG 引用了其他文件，而这些文件从不打开：其中的内容缺失。</translation>
    </message>
    <message>
        <source>Groups of lines belong to no view and were left out: {count}.</source>
        <translation>不属于任何视图而被略去的线组：{count}。</translation>
    </message>
    <message>
        <source>A pictorial view was left out: it illustrates what the other views show.</source>
        <translation>略去了一个轴测图：它只是说明其他视图所表达的内容。</translation>
    </message>
    <message>
        <source>The outlines of these views have gaps: {views}. The surface was made with the exact solid&apos;s outline there.</source>
        <translation>这些视图的轮廓有缺口：{views}。该处的表面采用精确实体的轮廓生成。</translation>
    </message>
    <message>
        <source>On a processor this takes an hour or more. Choose the quality Draft or smaller images, or use a graphics card.</source>
        <translation>在处理器上这需要一小时或更久。请选择质量“草稿”或较小的图像，或使用显卡。</translation>
    </message>
    <message>
        <source>The interrupted run in the folder belongs to another drawing, other settings or another version: the training began anew.</source>
        <translation>文件夹中被中断的运行属于另一张图纸、其他设置或其他版本：训练已重新开始。</translation>
    </message>
    <message>
        <source>Thread symbols were left out: the model has plain cylinders there.</source>
        <translation>略去了螺纹符号：模型在该处为光滑圆柱。</translation>
    </message>
    <message>
        <source>There is no such file: {path}. Choose it again.</source>
        <translation>没有这个文件：{path}。请重新选择。</translation>
    </message>
    <message>
        <source>{path} is no file. Choose a drawing.</source>
        <translation>{path} 不是文件。请选择图纸。</translation>
    </message>
    <message>
        <source>{path} cannot be opened. Check that you may read it.</source>
        <translation>无法打开 {path}。请检查您是否有读取权限。</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that you may read it.</source>
        <translation>无法读取该文件。请检查您是否有读取权限。</translation>
    </message>
    <message>
        <source>The file is empty. Export it again.</source>
        <translation>文件是空的。请重新导出。</translation>
    </message>
    <message>
        <source>The file is no PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF, whatever its name says. Export the drawing as one of them.</source>
        <translation>无论文件名如何，该文件不是 PNG、JPEG、TIFF、BMP、WebP、PDF、SVG 或 DXF。请将图纸导出为其中一种格式。</translation>
    </message>
    <message>
        <source>The picture is damaged. Export or scan the drawing again.</source>
        <translation>图片已损坏。请重新导出或扫描图纸。</translation>
    </message>
    <message>
        <source>The file is no PDF, or is damaged. Export the drawing again, or as PNG.</source>
        <translation>该文件不是 PDF，或已损坏。请重新导出图纸，或导出为 PNG。</translation>
    </message>
    <message>
        <source>The file is no SVG, or is damaged. Export the drawing again, or as PNG.</source>
        <translation>该文件不是 SVG，或已损坏。请重新导出图纸，或导出为 PNG。</translation>
    </message>
    <message>
        <source>The file is no DXF, or is damaged. Export the drawing again, or as PNG.</source>
        <translation>该文件不是 DXF，或已损坏。请重新导出图纸，或导出为 PNG。</translation>
    </message>
    <message>
        <source>What was read of the sheet is damaged, or of another version. Open the drawing {canvas} again.</source>
        <translation>从图纸读出的内容已损坏，或属于其他版本。请{canvas}重新打开该图纸。</translation>
    </message>
    <message>
        <source>The corrections in {path} are damaged, or of another version. Remove that file, or mend it.</source>
        <translation>{path} 中的更正已损坏，或属于其他版本。请删除或修复该文件。</translation>
    </message>
    <message>
        <source>The PDF is protected by a password. Save it without one.</source>
        <translation>该 PDF 有密码保护。请保存为无密码的文件。</translation>
    </message>
    <message>
        <source>The SVG declares XML entities, which are never expanded. Save it as plain SVG.</source>
        <translation>该 SVG 声明了 XML 实体，而这些实体从不展开。请保存为普通 SVG。</translation>
    </message>
    <message>
        <source>All that the SVG shows lies in other files, which are never opened. Embed it.</source>
        <translation>该 SVG 显示的全部内容都在其他文件中，而这些文件从不打开。请将内容嵌入。</translation>
    </message>
    <message>
        <source>The page has no lines. Choose another page or file.</source>
        <translation>该页没有线。请选择其他页或文件。</translation>
    </message>
    <message>
        <source>The file has {count} pages, at most {most} are read. Save the sheet in a file by itself.</source>
        <translation>文件有 {count} 页，最多读取 {most} 页。请将该图纸单独存为一个文件。</translation>
    </message>
    <message>
        <source>There is no page {page}: the last page of the file is page {count}.</source>
        <translation>没有第 {page} 页：文件的最后一页是第 {count} 页。</translation>
    </message>
    <message>
        <source>The picture is too large: at most {most} million pixels are read. Export or scan it at a lower resolution, or on smaller paper.</source>
        <translation>图片过大：最多读取 {most} 百万像素。请以较低的分辨率或较小的纸张导出或扫描。</translation>
    </message>
    <message>
        <source>The picture has only {width} × {height} pixels. Export the drawing with 1920 × 1080 or more.</source>
        <translation>图片只有 {width} × {height} 像素。请以 1920 × 1080 或更多像素导出图纸。</translation>
    </message>
    <message>
        <source>This is a FreeCAD document. Open it, then choose its TechDraw page as the drawing.</source>
        <translation>这是 FreeCAD 文档。请打开它，然后选择其 TechDraw 页面作为图纸。</translation>
    </message>
    <message>
        <source>{format} files are not read. Save the drawing as PDF, SVG, DXF or PNG.</source>
        <translation>不读取 {format} 文件。请将图纸保存为 PDF、SVG、DXF 或 PNG。</translation>
    </message>
    <message>
        <source>This is no report of a batch. Choose the one in the folder that it wrote.</source>
        <translation>这不是批处理报告。请选择批处理所写文件夹中的报告。</translation>
    </message>
    <message>
        <source>The run left no report. Run it again.</source>
        <translation>该次运行没有留下报告。请重新运行。</translation>
    </message>
    <message>
        <source>The run&apos;s report is damaged. Run it again.</source>
        <translation>该次运行的报告已损坏。请重新运行。</translation>
    </message>
    <message>
        <source>The run&apos;s report is of another version. Run it again.</source>
        <translation>该次运行的报告属于其他版本。请重新运行。</translation>
    </message>
    <message>
        <source>The sheet is blank: there are no lines.</source>
        <translation>图纸是空白的：没有任何线。</translation>
    </message>
    <message>
        <source>This does not look like a line drawing. Use an export or a scan of the drawing, not a photograph.</source>
        <translation>这看起来不像线条图。请使用图纸的导出文件或扫描件，不要用照片。</translation>
    </message>
    <message>
        <source>No view of a part was found. Box the views {canvas} and say which is which.</source>
        <translation>未找到零件的视图。请{canvas}框选各视图，并指明各是哪个视图。</translation>
    </message>
    <message>
        <source>Only one view was found. A part follows from two views, or from one with diameters across its axis or with a thickness. Box the views {canvas} if there are more.</source>
        <translation>只找到一个视图。零件由两个视图得出，或由一个标有垂直于轴线的直径或厚度的视图得出。如果还有其他视图，请{canvas}框选。</translation>
    </message>
    <message>
        <source>The sheet shows the part in a pictorial view alone. Views at right angles are needed, such as front, top and side.</source>
        <translation>图纸仅以立体图表示零件。需要相互垂直的视图，例如主视图、俯视图和侧视图。</translation>
    </message>
    <message>
        <source>The views do not line up with each other. Box them {canvas} and say which is which.</source>
        <translation>各视图没有相互对齐。请{canvas}框选，并指明各是哪个视图。</translation>
    </message>
    <message>
        <source>The view “{view}” has no visible line. Draw its edges {canvas}, or say that the box is another view.</source>
        <translation>“{view}”中没有可见线。请{canvas}画出其棱边，或指明该框是另一个视图。</translation>
    </message>
    <message>
        <source>The views show nothing of the {axis} axis. Two views at right angles are needed: box them {canvas}.</source>
        <translation>各视图没有表达 {axis} 轴方向。需要两个互相垂直的视图：请{canvas}框选。</translation>
    </message>
    <message>
        <source>The views differ by {percent} % in the part&apos;s extent along {axis} ({views}). Check that they show one part at one scale, or box them {canvas}.</source>
        <translation>各视图中零件沿 {axis} 的长度相差 {percent} %（{views}）。请检查它们是否以同一比例表达同一零件，或{canvas}框选。</translation>
    </message>
    <message>
        <source>The outline of the view “{view}” is not closed. Draw what is missing of its visible edges {canvas}.</source>
        <translation>“{view}”的轮廓没有封闭。请{canvas}画出其缺少的可见棱边。</translation>
    </message>
    <message>
        <source>The edges of the view “{view}” run together to one line. Export the drawing with more pixels.</source>
        <translation>“{view}”的各边连成了一条线。请以更多像素导出图纸。</translation>
    </message>
    <message>
        <source>The outlines of the views have no body in common, so that there is no surface. Check which view is which, and the projection.</source>
        <translation>各视图的轮廓没有共同的实体，因此没有表面。请检查各是哪个视图，以及投影画法。</translation>
    </message>
    <message>
        <source>The Gaussians bound no body, so that there is no surface of them. Choose a finer quality, or check that the views belong together.</source>
        <translation>高斯体没有围成实体，因此得不到其表面。请选择更精细的质量，或检查各视图是否属于同一零件。</translation>
    </message>
    <message>
        <source>There are no lines in the box of the view “{view}”. Draw it again.</source>
        <translation>“{view}”的框内没有线。请重新框选。</translation>
    </message>
    <message>
        <source>Two boxes are named “{view}”. Give one of them another name {canvas}.</source>
        <translation>有两个框都名为“{view}”。请{canvas}给其中一个改名。</translation>
    </message>
    <message>
        <source>The drawing has changed since it was read. Open it {canvas} again.</source>
        <translation>图纸在读取之后已改变。请{canvas}重新打开。</translation>
    </message>
    <message>
        <source>The corrections in {path} belong to another drawing, or to an earlier version of it. Remove that file, or correct the drawing again.</source>
        <translation>{path} 中的更正属于另一张图纸，或属于其较早的版本。请删除该文件，或重新校正图纸。</translation>
    </message>
    <message>
        <source>There is not enough memory. Choose the quality Draft or a smaller file, or export a vector drawing as PNG.</source>
        <translation>内存不足。请选择质量“草稿”或较小的文件，或将矢量图导出为 PNG。</translation>
    </message>
    <message>
        <source>The drawing has more lines and other elements than can be read ({most}). Save only the views, or export it as PNG.</source>
        <translation>图纸的线和其他元素超过可读取的数量（{most}）。请只保存各视图，或导出为 PNG。</translation>
    </message>
    <message>
        <source>The table has more lines than are taken ({most}). Make several tables of it.</source>
        <translation>表格的行数超过可接受的数量（{most}）。请将其分成多个表格。</translation>
    </message>
    <message>
        <source>There are more corrections than are taken ({most}). Remove those that no longer matter.</source>
        <translation>修正超过可接受的数量（{most}）。请删除不再需要的修正。</translation>
    </message>
    <message>
        <source>The reading has more strokes than are taken ({most}). Read the views alone.</source>
        <translation>读取结果的笔画超过可接受的数量（{most}）。请只读取各视图。</translation>
    </message>
    <message>
        <source>The file has more than {most} MB. Save only the views, or export the drawing as PNG.</source>
        <translation>文件超过 {most} MB。请只保存各视图，或将图纸导出为 PNG。</translation>
    </message>
    <message>
        <source>The drawing was not read after {seconds} s. Save only the views, or export it as PNG.</source>
        <translation>{seconds} s 后图纸仍未读完。请只保存各视图，或导出为 PNG。</translation>
    </message>
    <message>
        <source>It took longer than is allowed, and was ended.</source>
        <translation>用时超过允许的上限，已被终止。</translation>
    </message>
    <message>
        <source>There is no space left on the disk. Free some, then try again.</source>
        <translation>磁盘空间不足。请腾出一些空间后重试。</translation>
    </message>
    <message>
        <source>The system lets the engine open no more files. Close other programs, then try again.</source>
        <translation>系统不允许引擎打开更多文件。请关闭其他程序，然后重试。</translation>
    </message>
    <message>
        <source>The folder {path} cannot be written to. Choose another one.</source>
        <translation>无法写入文件夹 {path}。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>The graphics card cannot be used. GaussianCAD &gt; Check Engine shows what is missing.</source>
        <translation>无法使用显卡。GaussianCAD &gt; 检查引擎 会显示缺少什么。</translation>
    </message>
    <message>
        <source>The engine is incomplete. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation>引擎不完整。请选择 GaussianCAD &gt; 检查引擎 查看处理办法。</translation>
    </message>
    <message>
        <source>The engine was installed without what this needs ({packages}). Choose GaussianCAD &gt; Install Engine, and there an engine with PyTorch.</source>
        <translation>引擎安装时未包含此功能所需的软件包（{packages}）。请选择 GaussianCAD &gt; 安装引擎，并选用带 PyTorch 的引擎。</translation>
    </message>
    <message>
        <source>The engine met something that nobody foresaw ({kind}). This is a fault of ours: please report it with the sheet.</source>
        <translation>引擎遇到了未预见的情况（{kind}）。这是我们的错误：请连同图纸一起报告。</translation>
    </message>
    <message>
        <source>The engine met something that nobody foresaw ({kind}). This is a fault of ours: please report it with the file {path}.</source>
        <translation>引擎遇到了未预见的情况（{kind}）。这是我们的错误：请连同文件 {path} 一起报告。</translation>
    </message>
    <message>
        <source>A library ended the engine. This is a fault of ours: please report it with the sheet.</source>
        <translation>某个库终止了引擎。这是我们的错误：请连同图纸一起报告。</translation>
    </message>
    <message>
        <source>The system ended the engine, as it does where the memory does not suffice. Choose a coarser quality, or a smaller sheet.</source>
        <translation>系统终止了引擎，通常是因为内存不足。请选择较低的质量或较小的图纸。</translation>
    </message>
    <message>
        <source>{folder} holds files that GaussianCAD did not make: {names}. Choose another folder.</source>
        <translation>{folder} 中有并非由 GaussianCAD 生成的文件：{names}。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>By its scale the part is {longest} mm long. Tell its true size with Tell a Length.</source>
        <translation>按比例该零件长 {longest} mm。请用“指定长度”给出真实尺寸。</translation>
    </message>
    <message>
        <source>The surface cannot be simplified to a closed one. Choose a finer quality.</source>
        <translation>该表面无法简化为封闭表面。请选择更精细的质量。</translation>
    </message>
    <message>
        <source>The surface does not become a valid solid: only its mesh can be used.</source>
        <translation>该表面不能成为有效实体：只能使用其网格。</translation>
    </message>
    <message>
        <source>The solid cannot be saved as STEP.</source>
        <translation>该实体无法保存为 STEP。</translation>
    </message>
    <message>
        <source>Shape verified.</source>
        <translation>形状已验证。</translation>
    </message>
    <message>
        <source>Shape not certain: check the part against the drawing.</source>
        <translation>形状不确定：请对照图纸检查零件。</translation>
    </message>
    <message>
        <source>Failed: no part follows from this drawing.</source>
        <translation>失败：由这张图纸得不出零件。</translation>
    </message>
    <message>
        <source>from the sheet&apos;s numbers</source>
        <translation>依据图纸上的数字</translation>
    </message>
    <message>
        <source>from the drawing</source>
        <translation>依据图形</translation>
    </message>
    <message>
        <source>from the sheet&apos;s numbers and the drawing</source>
        <translation>依据图纸上的数字和图形</translation>
    </message>
    <message>
        <source>Measures to ±{bound} mm ({source}).</source>
        <translation>尺寸误差不超过 ±{bound} mm（{source}）。</translation>
    </message>
    <message>
        <source>given</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>from the sheet&apos;s resolution</source>
        <translation>依据图纸分辨率</translation>
    </message>
    <message>
        <source>from a dimension</source>
        <translation>依据尺寸标注</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>Scale: {scale} mm per pixel ({source})</source>
        <translation>比例：每像素 {scale} mm（{source}）</translation>
    </message>
    <message>
        <source>Time: {seconds} s</source>
        <translation>用时：{seconds} s</translation>
    </message>
    <message>
        <source>visible lines</source>
        <translation>可见线</translation>
    </message>
    <message>
        <source>hidden lines</source>
        <translation>隐藏线</translation>
    </message>
    <message>
        <source>{lines} {recall} found, {precision} right</source>
        <translation>{lines}：找到 {recall}，正确 {precision}</translation>
    </message>
    <message>
        <source>Solid: {faces} faces, {volume} mm³</source>
        <translation>实体：{faces} 个面，{volume} mm³</translation>
    </message>
    <message>
        <source>Surface of the Gaussians: {triangles} triangles, {volume} mm³</source>
        <translation>高斯体表面：{triangles} 个三角形，{volume} mm³</translation>
    </message>
    <message>
        <source>The hull on which the Gaussians started is nearer to the drawing&apos;s outlines.</source>
        <translation>高斯体起始的外壳更接近图纸的轮廓。</translation>
    </message>
    <message>
        <source>The run was cancelled.</source>
        <translation>运行已取消。</translation>
    </message>
    <message>
        <source>The GaussianCAD engine could not be started with {python}: {reason}. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation>无法用 {python} 启动 GaussianCAD 引擎：{reason}。请选择 GaussianCAD &gt; 检查引擎 查看处理办法。</translation>
    </message>
    <message>
        <source>The GaussianCAD engine at {python} does not work: {reason}. Choose GaussianCAD &gt; Check Engine to see what to do.</source>
        <translation>位于 {python} 的 GaussianCAD 引擎不能工作：{reason}。请选择 GaussianCAD &gt; 检查引擎 查看处理办法。</translation>
    </message>
    <message>
        <source>The GaussianCAD engine stopped with code {code}.</source>
        <translation>GaussianCAD 引擎已停止，代码 {code}。</translation>
    </message>
    <message>
        <source>The GaussianCAD engine was ended from outside, or ran out of memory. Close other programs or choose a simpler preset, then try again.</source>
        <translation>GaussianCAD 引擎被外部终止，或内存不足。请关闭其他程序，或选择较简单的预设，然后重试。</translation>
    </message>
    <message>
        <source>reading the sheet</source>
        <translation>读取图纸</translation>
    </message>
    <message>
        <source>finding the views</source>
        <translation>查找视图</translation>
    </message>
    <message>
        <source>reading the lines</source>
        <translation>读取图线</translation>
    </message>
    <message>
        <source>bringing the views together</source>
        <translation>对齐各视图</translation>
    </message>
    <message>
        <source>finding the solid</source>
        <translation>求解实体</translation>
    </message>
    <message>
        <source>carving the outlines</source>
        <translation>由轮廓切出外壳</translation>
    </message>
    <message>
        <source>training the Gaussians</source>
        <translation>训练高斯体</translation>
    </message>
    <message>
        <source>making the surface</source>
        <translation>生成表面</translation>
    </message>
    <message>
        <source>holding the model against the views</source>
        <translation>将模型与视图对照</translation>
    </message>
    <message>
        <source>checking against the sheet</source>
        <translation>与图纸核对</translation>
    </message>
    <message>
        <source>writing the files</source>
        <translation>写入文件</translation>
    </message>
    <message>
        <source>half section</source>
        <translation>半剖视图</translation>
    </message>
    <message>
        <source>broken-out section</source>
        <translation>局部剖视图</translation>
    </message>
    <message>
        <source>pictorial view</source>
        <translation>轴测图</translation>
    </message>
    <message>
        <source>enlarged detail</source>
        <translation>局部放大图</translation>
    </message>
    <message>
        <source>views of another part</source>
        <translation>另一零件的视图</translation>
    </message>
    <message>
        <source>broken view</source>
        <translation>断开的视图</translation>
    </message>
    <message>
        <source>half view</source>
        <translation>半视图</translation>
    </message>
    <message>
        <source>thread symbol</source>
        <translation>螺纹符号</translation>
    </message>
    <message>
        <source>group of lines</source>
        <translation>线组</translation>
    </message>
    <message>
        <source>visible line</source>
        <translation>可见线</translation>
    </message>
    <message>
        <source>hidden line</source>
        <translation>隐藏线</translation>
    </message>
    <message>
        <source>first angle</source>
        <translation>第一角画法</translation>
    </message>
    <message>
        <source>third angle</source>
        <translation>第三角画法</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>{name} cannot be written for the comparison: {reason}</source>
        <translation>无法为比较写出 {name}：{reason}</translation>
    </message>
    <message>
        <source>Compare with Reference</source>
        <translation>与参考比较</translation>
    </message>
    <message>
        <source>Comparison of {result} with {reference}</source>
        <translation>{result} 与 {reference} 的比较</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>Compare Again</source>
        <translation>重新比较</translation>
    </message>
    <message>
        <source>The engine&apos;s file {path} cannot be read ({reason}). Run it again.</source>
        <translation>无法读取引擎的文件 {path}（{reason}）。请重新运行。</translation>
    </message>
    <message>
        <source>Open Drawing</source>
        <translation>打开图纸</translation>
    </message>
    <message>
        <source>The drawing was not read yet. Wait until it is.</source>
        <translation>图纸尚未读完。请稍候。</translation>
    </message>
    <message>
        <source>Show Solutions</source>
        <translation>显示各解</translation>
    </message>
    <message>
        <source>Correct Drawing</source>
        <translation>校正图纸</translation>
    </message>
    <message>
        <source>The picture of {name} is missing. Choose the drawing&apos;s file instead.</source>
        <translation>{name} 的图片缺失。请改为选择图纸文件。</translation>
    </message>
    <message>
        <source>The engine made no model of {sheet}: {reason}</source>
        <translation>引擎没有由 {sheet} 得出模型：{reason}</translation>
    </message>
    <message>
        <source>Reconstruct from Drawing</source>
        <translation>由图纸重建</translation>
    </message>
    <message>
        <source>Part (not there yet)</source>
        <translation>零件（尚未生成）</translation>
    </message>
    <message>
        <source>Reconstruction of {name}</source>
        <translation>{name} 的重建</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation>高斯体</translation>
    </message>
    <message>
        <source>View {role}</source>
        <translation>视图 {role}</translation>
    </message>
    <message>
        <source>Alternative {number}</source>
        <translation>备选解 {number}</translation>
    </message>
    <message>
        <source>Part (faceted, approximate)</source>
        <translation>零件（三角面片，近似）</translation>
    </message>
    <message>
        <source>Part (slabs, approximate)</source>
        <translation>零件（层叠板，近似）</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Part (approximate)</source>
        <translation>零件（近似）</translation>
    </message>
    <message>
        <source>The comparison is out of date: {reason}</source>
        <translation>比较结果已过期：{reason}</translation>
    </message>
    <message>
        <source>The solutions are not in the document any more.</source>
        <translation>这些解已不在文档中。</translation>
    </message>
    <message>
        <source>Keep Solution</source>
        <translation>保留解</translation>
    </message>
    <message>
        <source>There is no file {path}. Choose another one.</source>
        <translation>没有文件 {path}。请选择其他文件。</translation>
    </message>
    <message>
        <source>The page {name} shows no views of a part. Recompute it, or choose another one.</source>
        <translation>页面 {name} 上没有零件的视图。请重新计算该页面，或选择其他页面。</translation>
    </message>
    <message>
        <source>Check Engine</source>
        <translation>检查引擎</translation>
    </message>
    <message>
        <source>Install Engine…</source>
        <translation>安装引擎…</translation>
    </message>
    <message>
        <source>Engine: {engine}</source>
        <translation>引擎：{engine}</translation>
    </message>
    <message>
        <source>Asking the engine…</source>
        <translation>正在询问引擎…</translation>
    </message>
    <message>
        <source>The engine is complete and works.</source>
        <translation>引擎完整且工作正常。</translation>
    </message>
    <message>
        <source>The engine does not work: see below what to do.</source>
        <translation>引擎无法工作：处理方法见下文。</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未设置</translation>
    </message>
    <message>
        <source>GaussianCAD looked in these places, in this order:</source>
        <translation>GaussianCAD 已按以下顺序查找：</translation>
    </message>
    <message>
        <source>Preferences: {path}</source>
        <translation>首选项：{path}</translation>
    </message>
    <message>
        <source>To install the engine, press Install Engine, or run in a terminal: make -C &apos;{folder}&apos; install</source>
        <translation>要安装引擎，请按“安装引擎”，或在终端中运行：make -C &apos;{folder}&apos; install</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>正在比较</translation>
    </message>
    <message>
        <source>Choose two different objects to compare.</source>
        <translation>请选择两个不同的对象进行比较。</translation>
    </message>
    <message>
        <source>An object was removed while it was being compared.</source>
        <translation>比较过程中有对象被删除。</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Another shape: {share} % of the volume is shared where both are as large.</source>
        <translation>形状不同：在相同尺寸下共有 {share} % 的体积。</translation>
    </message>
    <message>
        <source>The same part: {share} % of the volume is shared.</source>
        <translation>同一零件：共有 {share} % 的体积。</translation>
    </message>
    <message>
        <source>The same shape, {ratio} times too large.</source>
        <translation>形状相同，但放大了 {ratio} 倍。</translation>
    </message>
    <message>
        <source>The same shape, {ratio} times too small.</source>
        <translation>形状相同，但缩小了 {ratio} 倍。</translation>
    </message>
    <message>
        <source>Set Length along X to {length} mm and run it again.</source>
        <translation>将沿 X 的长度设为 {length} mm，然后重新运行。</translation>
    </message>
    <message>
        <source>The document was closed. Open it and compare again.</source>
        <translation>文档已关闭。请打开后重新比较。</translation>
    </message>
    <message>
        <source>There is nothing to compare. Open a document with a result and a reference: a part, a body or a mesh each, or choose a file.</source>
        <translation>没有可比较的内容。请打开含有结果和参考的文档（各为零件、实体或网格），或选择文件。</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Change of the model</source>
        <translation>模型的更改</translation>
    </message>
    <message>
        <source>Single changes with which the model explains more of the drawing, and how many millimetres of its lines</source>
        <translation>使模型能更多地解释图纸的单项更改，以及多解释的线条长度（毫米）</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>The model was changed since: check again.</source>
        <translation>模型此后已更改：请重新检查。</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Share of the surface by its deviation</source>
        <translation>按偏差统计的表面比例</translation>
    </message>
    <message>
        <source>Result has</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Worst points</source>
        <translation>偏差最大的点</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>大小，mm</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>体积，mm³</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>面积，mm²</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Range of the Colours</source>
        <translation>颜色范围</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Page for a browser (*.html)</source>
        <translation>浏览器页面 (*.html)</translation>
    </message>
    <message>
        <source>Save Comparison</source>
        <translation>保存比较</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Colours to ±</source>
        <translation>颜色范围 ±</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>截面</translation>
    </message>
    <message>
        <source>{name} – Correct Sheet</source>
        <translation>{name} – 校正图纸</translation>
    </message>
    <message>
        <source>Mesh and Gaussians</source>
        <translation>网格和高斯体</translation>
    </message>
    <message>
        <source>Choose among Solutions…</source>
        <translation>在多个解中选择…</translation>
    </message>
    <message>
        <source>Choose a Drawing</source>
        <translation>选择图纸</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>图纸</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Values are in units: the longest edge of the reference is 5. The floor is what two samples of the reference itself give.</source>
        <translation>数值采用相对单位：参考的最长边为 5。下限是参考自身两次采样之间的差异。</translation>
    </message>
    <message>
        <source>{distance}: {length} mm</source>
        <translation>{distance}：{length} mm</translation>
    </message>
    <message>
        <source>Mean, mm</source>
        <translation>平均值，mm</translation>
    </message>
    <message>
        <source>Mean deviation; negative lies inside the other model</source>
        <translation>平均偏差；负值表示位于另一模型内部</translation>
    </message>
    <message>
        <source>RMS, mm</source>
        <translation>均方根，mm</translation>
    </message>
    <message>
        <source>Root mean square of the deviation</source>
        <translation>偏差的均方根</translation>
    </message>
    <message>
        <source>Inside, mm</source>
        <translation>内侧，mm</translation>
    </message>
    <message>
        <source>The farthest that it lies inside the other model</source>
        <translation>位于另一模型内部的最大深度</translation>
    </message>
    <message>
        <source>Outside, mm</source>
        <translation>外侧，mm</translation>
    </message>
    <message>
        <source>The farthest that it lies outside the other model</source>
        <translation>位于另一模型外部的最大距离</translation>
    </message>
    <message>
        <source>Agrees, %</source>
        <translation>一致，%</translation>
    </message>
    <message>
        <source>Share of the surface within the tolerance</source>
        <translation>在公差范围内的表面比例</translation>
    </message>
    <message>
        <source>Volume, %</source>
        <translation>体积，%</translation>
    </message>
    <message>
        <source>By how much the result&apos;s volume differs</source>
        <translation>结果体积的差异</translation>
    </message>
    <message>
        <source>Area, %</source>
        <translation>面积，%</translation>
    </message>
    <message>
        <source>By how much the result&apos;s area differs</source>
        <translation>结果面积的差异</translation>
    </message>
    <message>
        <source>Chamfer distance</source>
        <translation>Chamfer 距离</translation>
    </message>
    <message>
        <source>Sum of the mean distances to the nearest point, both ways</source>
        <translation>双向最近点平均距离之和</translation>
    </message>
    <message>
        <source>Hausdorff</source>
        <translation>Hausdorff 距离</translation>
    </message>
    <message>
        <source>Largest distance to the nearest point, either way</source>
        <translation>双向到最近点的最大距离</translation>
    </message>
    <message>
        <source>Earth mover</source>
        <translation>推土机距离</translation>
    </message>
    <message>
        <source>Mean distance of points matched one to one</source>
        <translation>一一配对的点的平均距离</translation>
    </message>
    <message>
        <source>To surface</source>
        <translation>到表面</translation>
    </message>
    <message>
        <source>Mean distance of the points to the other surface</source>
        <translation>各点到另一表面的平均距离</translation>
    </message>
    <message>
        <source>Volume IoU</source>
        <translation>体积 IoU</translation>
    </message>
    <message>
        <source>Common volume over united volume; 1 is perfect</source>
        <translation>公共体积与合并体积之比；1 为完全一致</translation>
    </message>
    <message>
        <source>From the Document</source>
        <translation>来自文档</translation>
    </message>
    <message>
        <source>Takes a TechDraw page or an image of the active document</source>
        <translation>使用当前文档中的 TechDraw 页面或图像</translation>
    </message>
    <message>
        <source>The document has no TechDraw pages and no images</source>
        <translation>文档中没有 TechDraw 页面，也没有图像</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Adding the result to the document</source>
        <translation>正在将结果加入文档</translation>
    </message>
    <message>
        <source>The result cannot be added to the document: {reason}</source>
        <translation>无法将结果加入文档：{reason}</translation>
    </message>
    <message>
        <source>Mesh and Gaussians of {0}</source>
        <translation>{0} 的网格和高斯体</translation>
    </message>
    <message>
        <source>The drawing is no longer in the document</source>
        <translation>该图纸已不在文档中</translation>
    </message>
    <message>
        <source>Install Engine</source>
        <translation>安装引擎</translation>
    </message>
    <message>
        <source>Download and Install</source>
        <translation>下载并安装</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>Remove…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Downloads and installs what is missing or damaged, only that</source>
        <translation>只下载并安装缺失或损坏的部分</translation>
    </message>
    <message>
        <source>Remove the engine in {folder}? {size} on disk become free. Drawings, documents and this addon stay as they are, and the engine can be installed again.</source>
        <translation>要删除 {folder} 中的引擎吗？将释放 {size} 磁盘空间。图纸、文档和本插件保持不变，引擎可以重新安装。</translation>
    </message>
    <message>
        <source>Remove Engine</source>
        <translation>删除引擎</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>The engine is complete.</source>
        <translation>引擎完整。</translation>
    </message>
    <message>
        <source>Version {version} with PyTorch for {build}, {size} on disk in {folder}.</source>
        <translation>版本 {version}，PyTorch 用于{build}，在 {folder} 中占用 {size}。</translation>
    </message>
    <message>
        <source>Version {version} for {build}, {size} on disk in {folder}.</source>
        <translation>版本 {version}，{build}，在 {folder} 中占用 {size}。</translation>
    </message>
    <message>
        <source>The engine in {folder} is not complete. Repair downloads what is missing or damaged.</source>
        <translation>{folder} 中的引擎不完整。“修复”会下载缺失或损坏的部分。</translation>
    </message>
    <message>
        <source>Missing, or of another version: {names}</source>
        <translation>缺失或版本不同：{names}</translation>
    </message>
    <message>
        <source>An engine is in use already: {engine}.</source>
        <translation>已在使用一个引擎：{engine}。</translation>
    </message>
    <message>
        <source>GaussianCAD can download the packages of its engine from the Python package index that pip is set up for, and PyTorch for the processor from {index} where that index lacks it. Each package is checked against a hash that comes with this addon. They go into {folder}; FreeCAD&apos;s own Python stays as it is. Nothing is sent.</source>
        <translation>GaussianCAD 可以从 pip 所设的 Python 软件包索引下载引擎的软件包；若该索引没有处理器版的 PyTorch，则从 {index} 下载。每个软件包都用随本插件提供的哈希值校验。它们放入 {folder}；FreeCAD 自带的 Python 保持不变。不会发送任何内容。</translation>
    </message>
    <message>
        <source>{count} MB</source>
        <translation>{count} MB</translation>
    </message>
    <message>
        <source>{count} GB</source>
        <translation>{count} GB</translation>
    </message>
    <message>
        <source>GaussianCAD Jobs</source>
        <translation>GaussianCAD 任务</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Cancelling</source>
        <translation>正在取消</translation>
    </message>
    <message>
        <source>Starting the engine</source>
        <translation>正在启动引擎</translation>
    </message>
    <message>
        <source>Stage {index} of {count}</source>
        <translation>第 {index} 阶段，共 {count} 阶段</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Model to Compare</source>
        <translation>要比较的模型</translation>
    </message>
    <message>
        <source>Models ({patterns})</source>
        <translation>模型 ({patterns})</translation>
    </message>
    <message>
        <source>Correct Sheet…</source>
        <translation>校正图纸…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>The drawing of {name} is gone, and the document holds no copy of it. Choose the drawing in Reconstruct from Drawing.</source>
        <translation>{name} 的图纸已不存在，文档中也没有副本。请在“由图纸重建”中选择图纸。</translation>
    </message>
    <message>
        <source>The part stays in the document.</source>
        <translation>零件保留在文档中。</translation>
    </message>
    <message>
        <source>Choose among {count} Solutions…</source>
        <translation>在 {count} 个解中选择…</translation>
    </message>
    <message>
        <source>Check Against Drawing</source>
        <translation>对照图纸检查</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>There is nothing to check. Open a document with a part, a body or a mesh, or choose a file.</source>
        <translation>没有可检查的内容。请打开包含零件、实体或网格的文档，或选择文件。</translation>
    </message>
    <message>
        <source>Check Again</source>
        <translation>重新检查</translation>
    </message>
    <message>
        <source>The document was closed. Open it and check again.</source>
        <translation>文档已关闭。请打开它并重新检查。</translation>
    </message>
    <message>
        <source>Choose a drawing first.</source>
        <translation>请先选择图纸。</translation>
    </message>
    <message>
        <source>There is no file {path}. Choose another drawing.</source>
        <translation>没有文件 {path}。请选择其他图纸。</translation>
    </message>
    <message>
        <source>Model and drawing</source>
        <translation>模型和图纸</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>图纸</translation>
    </message>
    <message>
        <source>Run Again</source>
        <translation>再次运行</translation>
    </message>
    <message>
        <source>No run has ended on this drawing yet.</source>
        <translation>此图纸尚无已结束的运行。</translation>
    </message>
    <message>
        <source>The drawing is gone, and the document holds no copy</source>
        <translation>图纸已不存在，文档中也没有副本</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详细信息</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Stage {index} of {count}: {name}</source>
        <translation>第 {index} 阶段，共 {count} 阶段：{name}</translation>
    </message>
    <message>
        <source>Elapsed {time}</source>
        <translation>已用时间 {time}</translation>
    </message>
    <message>
        <source>this stage needs about {time} more</source>
        <translation>本阶段大约还需 {time}</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>总进度</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Temporary</source>
        <translation>临时</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>页</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder named after the drawing. If empty, they are removed once the document holds the result.</source>
        <translation>将引擎的文件保存在以图纸命名的文件夹中。如果留空，结果进入文档后这些文件即被删除。</translation>
    </message>
    <message>
        <source>Folder for the Engine&apos;s Files</source>
        <translation>引擎文件的文件夹</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Tells how the views are arranged: third angle has the top view above the front view, first angle below it</source>
        <translation>说明视图的布置方式：第三角画法的俯视图在主视图上方，第一角画法的在下方</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>精细</translation>
    </message>
    <message>
        <source>Trades time for detail of the surface and effort of the search</source>
        <translation>在时间与表面细节、搜索力度之间取舍</translation>
    </message>
    <message>
        <source>Solid and surface</source>
        <translation>实体和表面</translation>
    </message>
    <message>
        <source>Solid only</source>
        <translation>仅实体</translation>
    </message>
    <message>
        <source>Surface only</source>
        <translation>仅表面</translation>
    </message>
    <message>
        <source>Chooses the exact solid, the mesh from trained Gaussians, or both of them</source>
        <translation>选择精确实体、由训练后的高斯体得到的网格，或两者</translation>
    </message>
    <message>
        <source>Parallel, as drawings are</source>
        <translation>平行投影，与图纸相同</translation>
    </message>
    <message>
        <source>Perspective, as in the paper</source>
        <translation>透视投影，与论文相同</translation>
    </message>
    <message>
        <source>Chooses the cameras that train the Gaussians</source>
        <translation>选择训练高斯体所用的相机</translation>
    </message>
    <message>
        <source>Unknown or on the sheet</source>
        <translation>未知或由图纸给出</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>沿 X 的长度</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>沿 Y 的长度</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>沿 Z 的长度</translation>
    </message>
    <message>
        <source>Millimetres per pixel</source>
        <translation>每像素毫米数</translation>
    </message>
    <message>
        <source>Tells how large the part is. X runs along the front view&apos;s width, Z up its height, Y into depth</source>
        <translation>说明零件的大小。X 沿主视图的宽度，Z 沿其高度，Y 沿深度</translation>
    </message>
    <message>
        <source>Drop a drawing here</source>
        <translation>将图纸拖放到此处</translation>
    </message>
    <message>
        <source>No preview of {name} here; the engine shows it when it is done</source>
        <translation>此处没有 {name} 的预览；引擎完成后会显示</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Share of the lines, the drawing&apos;s and the solid&apos;s, that agree</source>
        <translation>图纸的线与实体的线中一致的比例</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一个</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Keep This One</source>
        <translation>保留这一个</translation>
    </message>
    <message>
        <source>{number} of {count}</source>
        <translation>第 {number} 个，共 {count} 个</translation>
    </message>
    <message>
        <source>Choose among Solutions</source>
        <translation>在多个解中选择</translation>
    </message>
    <message>
        <source>Size: {x} × {y} × {z} mm</source>
        <translation>大小：{x} × {y} × {z} mm</translation>
    </message>
    <message>
        <source>Read in first angle</source>
        <translation>按第一角画法读取</translation>
    </message>
    <message>
        <source>Read in third angle</source>
        <translation>按第三角画法读取</translation>
    </message>
    <message>
        <source>The simplest of them, and the result so far</source>
        <translation>其中最简单的一个，也是当前的结果</translation>
    </message>
    <message>
        <source>{count} different solids have the lines of this drawing. Keep the one that is meant; the others are removed.</source>
        <translation>有 {count} 个不同的实体符合这张图纸的线。请保留所要的一个；其余的将被删除。</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Why there is doubt</source>
        <translation>存疑的原因</translation>
    </message>
    <message>
        <source>Orange: {volume} mm³ more than solution 1, {place}</source>
        <translation>橙色：比解 1 多 {volume} mm³，{place}</translation>
    </message>
    <message>
        <source>Magenta: {volume} mm³ less than solution 1, {place}</source>
        <translation>品红色：比解 1 少 {volume} mm³，{place}</translation>
    </message>
    <message>
        <source>within X {x}, Y {y}, Z {z} mm</source>
        <translation>位于 X {x}、Y {y}、Z {z} mm 范围内</translation>
    </message>
    <message>
        <source>Divides the edges of the images that train the Gaussians. 1 / 1 is the size in the paper</source>
        <translation>缩小训练高斯体所用图像的边长。1 / 1 为论文中的大小</translation>
    </message>
    <message>
        <source>{width} x {height} px, about {minutes} min on a processor</source>
        <translation>{width} x {height} 像素，在处理器上约 {minutes} 分钟</translation>
    </message>
    <message>
        <source>Opens a dialog to choose from</source>
        <translation>打开选择对话框</translation>
    </message>
    <message>
        <source>too little</source>
        <translation>偏少</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>too much</source>
        <translation>偏多</translation>
    </message>
    <message>
        <source>the result has too little</source>
        <translation>结果偏少</translation>
    </message>
    <message>
        <source>material is missing</source>
        <translation>缺少材料</translation>
    </message>
    <message>
        <source>the result has too much</source>
        <translation>结果偏多</translation>
    </message>
    <message>
        <source>GaussianCAD</source>
        <translation>GaussianCAD</translation>
    </message>
    <message>
        <source>Page {0}</source>
        <translation>第 {0} 页</translation>
    </message>
    <message>
        <source>The lines as they are drawn</source>
        <translation>按所画的线</translation>
    </message>
    <message>
        <source>Slabs that explain the lines best</source>
        <translation>最能解释各线条的层叠板</translation>
    </message>
    <message>
        <source>Short lines as visible or hidden, whichever fits</source>
        <translation>短线按可见线或隐藏线处理，以吻合者为准</translation>
    </message>
    <message>
        <source>The open outline closed by a straight line</source>
        <translation>用直线封闭有缺口的轮廓</translation>
    </message>
    <message>
        <source>With bodies of revolution that only one view shows</source>
        <translation>含有仅一个视图表达的回转体</translation>
    </message>
    <message>
        <source>Rough arcs taken for curves in which surfaces meet</source>
        <translation>将粗略的圆弧视为两面的交线</translation>
    </message>
    <message>
        <source>Lines led onto the curves in which two surfaces meet</source>
        <translation>将线引到两面的交线上</translation>
    </message>
    <message>
        <source>With hidden lines that may have been left out</source>
        <translation>含有可能被省略的隐藏线</translation>
    </message>
    <message>
        <source>With measures that are most likely round</source>
        <translation>采用最可能为整数的尺寸</translation>
    </message>
    <message>
        <source>a solid with all lines</source>
        <translation>具有全部线的实体</translation>
    </message>
    <message>
        <source>a solid whose lines differ from the drawing&apos;s</source>
        <translation>线与图纸不同的实体</translation>
    </message>
    <message>
        <source>a solid that is not one valid closed body</source>
        <translation>不是一个有效封闭体的实体</translation>
    </message>
    <message>
        <source>faces that do not close</source>
        <translation>不能封闭的面</translation>
    </message>
    <message>
        <source>nothing that bounds a body</source>
        <translation>没有围成实体的内容</translation>
    </message>
    <message>
        <source>no solid, as the lines contradict each other</source>
        <translation>没有实体，因为各线互相矛盾</translation>
    </message>
    <message>
        <source>no answer within the work that is allowed</source>
        <translation>在允许的计算量内没有结果</translation>
    </message>
    <message>
        <source>not tried, as there are too many lines</source>
        <translation>未尝试，因为线太多</translation>
    </message>
    <message>
        <source>Why there is no part:</source>
        <translation>得不出零件的原因：</translation>
    </message>
    <message>
        <source>Why the shape is not certain:</source>
        <translation>形状不确定的原因：</translation>
    </message>
    <message>
        <source>What was assumed:</source>
        <translation>所作的假定：</translation>
    </message>
    <message>
        <source>What was not used:</source>
        <translation>未使用的内容：</translation>
    </message>
    <message>
        <source>What was tried for the solid:</source>
        <translation>为求实体所作的尝试：</translation>
    </message>
    <message>
        <source>Where the part&apos;s lines and the drawing&apos;s differ:</source>
        <translation>零件的线与图纸的线不同之处：</translation>
    </message>
    <message>
        <source>Lines that contradict each other:</source>
        <translation>互相矛盾的线：</translation>
    </message>
    <message>
        <source>{model}: {outcome}.</source>
        <translation>{model}：{outcome}。</translation>
    </message>
    <message>
        <source>Faces: {faces}, agreement of the lines: {share}.</source>
        <translation>面数：{faces}，线的一致程度：{share}。</translation>
    </message>
    <message>
        <source>Length of the lines that were given up: {length} mm.</source>
        <translation>舍弃的线的长度：{length} mm。</translation>
    </message>
    <message>
        <source>This one was taken.</source>
        <translation>采用了这一结果。</translation>
    </message>
    <message>
        <source>{view}: the part lacks a line of {length} mm</source>
        <translation>{view}：零件缺少一条 {length} mm 的线</translation>
    </message>
    <message>
        <source>{view}: the part has a line of {length} mm too many</source>
        <translation>{view}：零件多出一条 {length} mm 的线</translation>
    </message>
    <message>
        <source>{view}: a visible line</source>
        <translation>{view}：一条可见线</translation>
    </message>
    <message>
        <source>{view}: a hidden line</source>
        <translation>{view}：一条隐藏线</translation>
    </message>
    <message>
        <source>{view}: a place where nothing is drawn</source>
        <translation>{view}：一处未画线的位置</translation>
    </message>
    <message>
        <source>without it all others agree</source>
        <translation>去掉它，其余的线都一致</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>以及另外 {count} 处</translation>
    </message>
    <message>
        <source>Next Sheet</source>
        <translation>下一张图纸</translation>
    </message>
    <message>
        <source>{0} of these {1} sheets are not verified</source>
        <translation>{1} 张图纸中有 {0} 张未验证</translation>
    </message>
    <message>
        <source>{folder} is not an environment that GaussianCAD made, and stays as it is.</source>
        <translation>{folder} 不是 GaussianCAD 创建的环境，保持不变。</translation>
    </message>
    <message>
        <source>The engine cannot be removed: {reason}. Nothing has changed. Close what uses it, then try again.</source>
        <translation>无法删除引擎：{reason}。没有任何更改。请关闭正在使用它的程序后重试。</translation>
    </message>
    <message>
        <source>an NVIDIA card was found</source>
        <translation>找到 NVIDIA 显卡</translation>
    </message>
    <message>
        <source>no NVIDIA card was found</source>
        <translation>未找到 NVIDIA 显卡</translation>
    </message>
    <message>
        <source>0.7 GB to download, 3 GB on disk</source>
        <translation>下载 0.7 GB，占用磁盘 3 GB</translation>
    </message>
    <message>
        <source>3.3 GB to download, 7 GB on disk</source>
        <translation>下载 3.3 GB，占用磁盘 7 GB</translation>
    </message>
    <message>
        <source>0.4 GB to download, 1.5 GB on disk</source>
        <translation>下载 0.4 GB，占用磁盘 1.5 GB</translation>
    </message>
    <message>
        <source>PyTorch for {build}: {sizes}</source>
        <translation>PyTorch 用于{build}：{sizes}</translation>
    </message>
    <message>
        <source>Exact solids only, without surfaces: {sizes}</source>
        <translation>仅精确实体，不生成表面：{sizes}</translation>
    </message>
    <message>
        <source>Reads drawings, makes solids and bodies. Gaussians, their mesh, and Compare with Reference need one of the others.</source>
        <translation>读取图纸，生成实体和主体。高斯体、其网格以及“与参考比较”需要其他选项之一。</translation>
    </message>
    <message>
        <source>exact solids only</source>
        <translation>仅精确实体</translation>
    </message>
    <message>
        <source>the processor (CPU)</source>
        <translation>处理器 (CPU)</translation>
    </message>
    <message>
        <source>NVIDIA cards (CUDA)</source>
        <translation>NVIDIA 显卡 (CUDA)</translation>
    </message>
    <message>
        <source>Choose the Report of a Batch</source>
        <translation>选择批处理报告</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Every sheet of this batch is verified.</source>
        <translation>此批处理的所有图纸都已验证。</translation>
    </message>
    <message>
        <source>Failed Sheets</source>
        <translation>失败的图纸</translation>
    </message>
    <message>
        <source>There is no file {0} any more.</source>
        <translation>文件 {0} 已不存在。</translation>
    </message>
    <message>
        <source>More settings</source>
        <translation>更多设置</translation>
    </message>
    <message>
        <source>Select a view first: click its frame, or a line in it</source>
        <translation>请先选择视图：单击其边框或其中的线</translation>
    </message>
    <message>
        <source>There is no view at this place</source>
        <translation>此处没有视图</translation>
    </message>
    <message>
        <source>Lines to Sketches</source>
        <translation>图线转为草图</translation>
    </message>
    <message>
        <source>Lines {name}</source>
        <translation>图线 {name}</translation>
    </message>
    <message>
        <source>Make Sketches</source>
        <translation>生成草图</translation>
    </message>
    <message>
        <source>Sketches: {sketches}, of {lines} lines.</source>
        <translation>草图：{sketches} 个，图线：{lines} 条。</translation>
    </message>
    <message>
        <source>What is in doubt is below.</source>
        <translation>存疑之处见下方。</translation>
    </message>
    <message>
        <source>The size is not known: the longest extent of the part was made 100 mm. Tell a length in Correct Sheet (key M).</source>
        <translation>尺寸未知：零件的最长尺寸取为 100 mm。请在“校正图纸”中给出一个长度（M 键）。</translation>
    </message>
    <message>
        <source>It is not known where a section looks: it stands beside the front view.</source>
        <translation>剖视图的投射方向未知：它放在主视图旁边。</translation>
    </message>
    <message>
        <source>What was read of the drawing, {path}, cannot be used ({reason}). Read the drawing again; if that does not help, choose GaussianCAD &gt; Check Engine.</source>
        <translation>从图纸读取的内容 {path} 无法使用（{reason}）。请重新读取图纸；若仍无效，请选择 GaussianCAD &gt; 检查引擎。</translation>
    </message>
    <message>
        <source>Only one view was found. How thick is the part?</source>
        <translation>只找到一个视图。零件有多厚？</translation>
    </message>
    <message>
        <source>How thick is the part, in mm?</source>
        <translation>零件有多厚（单位 mm）？</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>How Thick Is the Part?</source>
        <translation>零件有多厚？</translation>
    </message>
    <message>
        <source>The drawing has one view and a thickness, and nothing tells its scale. Tell a length that the view shows, under Scale or {canvas}.</source>
        <translation>图纸只有一个视图和一个厚度，没有任何内容说明其比例。请在“比例”下或{canvas}指定视图所示的一个长度。</translation>
    </message>
    <message>
        <source>These numbers cannot be set back: {names}</source>
        <translation>这些尺寸无法恢复：{names}</translation>
    </message>
    <message>
        <source>No body has a number that is another than on the sheet.</source>
        <translation>没有主体的尺寸与图纸不同。</translation>
    </message>
    <message>
        <source>No body was made: the part is no exact solid.</source>
        <translation>没有生成主体：零件不是精确的实体。</translation>
    </message>
    <message>
        <source>Back to the Sheet&apos;s Numbers</source>
        <translation>恢复图纸上的尺寸</translation>
    </message>
    <message>
        <source>Makes a body with sketches, pads and holes of an exact solid, once that is shown; the solid stays beside it, hidden</source>
        <translation>精确的实体显示之后，用草图、凸台和孔把它做成主体；实体隐藏保留在旁边</translation>
    </message>
    <message>
        <source>{name}: {sheet} mm on the sheet, {now} mm in the body</source>
        <translation>{name}：图纸上 {sheet} mm，主体中 {now} mm</translation>
    </message>
    <message>
        <source>Make an editable body</source>
        <translation>生成可编辑的主体</translation>
    </message>
    <message>
        <source>The part is the same: its body stays as it is.</source>
        <translation>零件没有变化：它的主体保持原样。</translation>
    </message>
    <message>
        <source>The body breaks when one of these numbers is changed: {numbers}.</source>
        <translation>改变其中任一尺寸都会使主体失效：{numbers}。</translation>
    </message>
    <message>
        <source>No body was made: {reason}.</source>
        <translation>没有生成主体：{reason}。</translation>
    </message>
    <message>
        <source>Changing each number on a copy</source>
        <translation>正在副本上逐个改变尺寸</translation>
    </message>
    <message>
        <source>Numbers that were not tried: {count}.</source>
        <translation>没有试过的尺寸：{count}。</translation>
    </message>
    <message>
        <source>No body was made: it was cancelled.</source>
        <translation>没有生成主体：已取消。</translation>
    </message>
    <message>
        <source>Break the body when they are changed:</source>
        <translation>改变后会使主体失效：</translation>
    </message>
    <message>
        <source>In the body numbers are others than on the sheet</source>
        <translation>主体中的尺寸与图纸不同</translation>
    </message>
    <message>
        <source>Each number can be changed.</source>
        <translation>每个尺寸都可以改变。</translation>
    </message>
    <message>
        <source>No body was made: several solids fit the sheet. Choose one, then use To Body.</source>
        <translation>没有生成主体：有多个实体与图纸相符。请先选择一个，再使用“转换为主体”。</translation>
    </message>
    <message>
        <source>The model agrees with the drawing.</source>
        <translation>模型与图纸一致。</translation>
    </message>
    <message>
        <source>The model differs from the drawing.</source>
        <translation>模型与图纸不一致。</translation>
    </message>
    <message>
        <source>It cannot be told whether the model agrees with the drawing.</source>
        <translation>无法判断模型与图纸是否一致。</translation>
    </message>
    <message>
        <source>Missing, hidden</source>
        <translation>缺失，隐藏</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>The drawing has a line here that the model does not show.</source>
        <translation>图纸在此处有一条线，而模型没有显示。</translation>
    </message>
    <message>
        <source>Extra, hidden</source>
        <translation>多余，隐藏</translation>
    </message>
    <message>
        <source>Extra</source>
        <translation>多余</translation>
    </message>
    <message>
        <source>The model has an edge here that the drawing does not show.</source>
        <translation>模型在此处有一条边，而图纸没有显示。</translation>
    </message>
    <message>
        <source>Linetype</source>
        <translation>线型</translation>
    </message>
    <message>
        <source>The line is visible in one of both and hidden in the other.</source>
        <translation>该线在一方中可见，在另一方中隐藏。</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>剖面线</translation>
    </message>
    <message>
        <source>The hatched area is not where the model is cut.</source>
        <translation>剖面线区域不在模型被剖切的位置。</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>Fill the hole of {diameter} mm at {start}</source>
        <translation>填补 {start} 处直径 {diameter} mm 的孔</translation>
    </message>
    <message>
        <source>Drill a hole of {diameter} mm at {end}</source>
        <translation>在 {end} 处钻直径 {diameter} mm 的孔</translation>
    </message>
    <message>
        <source>Move the hole of {diameter} mm from {start} to {end}</source>
        <translation>将直径 {diameter} mm 的孔从 {start} 移到 {end}</translation>
    </message>
    <message>
        <source>Move the flat face at {start} to {end}</source>
        <translation>将 {start} 处的平面移到 {end}</translation>
    </message>
    <message>
        <source>Take the mirror image of the model</source>
        <translation>取模型的镜像</translation>
    </message>
    <message>
        <source>Note “{text}”: the drawing says {stated}, the model has {found}.</source>
        <translation>注释“{text}”：图纸标注 {stated} 个，模型有 {found} 个。</translation>
    </message>
    <message>
        <source>The drawing does not say how large the part is: the size was not checked.</source>
        <translation>图纸没有说明零件的大小：未检查尺寸。</translation>
    </message>
    <message>
        <source>The model fits the views in no position: it is another part, or the views were read wrong. Check {canvas} how they were read.</source>
        <translation>模型在任何位置都与视图不符：它是另一个零件，或视图读取有误。请{canvas}检查视图的读取情况。</translation>
    </message>
    <message>
        <source>The views are {stated_mm} mm long along {axis} (x runs along the front view&apos;s width, z up its height), the model is {measured_mm} mm long.</source>
        <translation>视图沿 {axis} 方向长 {stated_mm} mm（x 沿主视图的宽度，z 沿其高度向上），模型长 {measured_mm} mm。</translation>
    </message>
    <message>
        <source>The model has {factor} times the size that the drawing&apos;s numbers say.</source>
        <translation>模型的尺寸是图纸数字所示尺寸的 {factor} 倍。</translation>
    </message>
    <message>
        <source>The view “{view}” has a circle of {diameter_mm} mm that the model does not show.</source>
        <translation>视图“{view}”中有一个直径 {diameter_mm} mm 的圆，而模型没有显示。</translation>
    </message>
    <message>
        <source>The model shows an edge of {length_mm} mm in the view “{view}” that is not drawn there. Such edges are {total_mm} mm long in all.</source>
        <translation>模型在视图“{view}”中显示一条 {length_mm} mm 的边，而图纸上没有画出。此类边总长 {total_mm} mm。</translation>
    </message>
    <message>
        <source>The section in the view “{view}” is hatched where the model is not cut, or the other way round.</source>
        <translation>视图“{view}”中的剖面在模型未被剖切处画有剖面线，或者相反。</translation>
    </message>
    <message>
        <source>The drawing shows shaded pictures in place of lines. They are not read surely enough to say that the model differs.</source>
        <translation>图纸显示的是着色图片而非线条。其读取不够可靠，无法断定模型与之不一致。</translation>
    </message>
    <message>
        <source>With a single change the model explains the drawing better: it is the first one among the changes.</source>
        <translation>只需一项更改，模型就能更好地解释图纸：它是更改列表中的第一项。</translation>
    </message>
    <message>
        <source>{percent} % of the lines that were read disagree with the model, and nothing tells whether the model or the reading is wrong. Check {canvas} how the lines were read.</source>
        <translation>读取的线条中有 {percent} % 与模型不符，而无法得知是模型有误还是读取有误。请{canvas}检查线条的读取情况。</translation>
    </message>
    <message>
        <source>The model is not closed, or damaged: what it is full of is not certain.</source>
        <translation>模型未封闭或已损坏：无法确定其实心部分。</translation>
    </message>
    <message>
        <source>The drawing states {stated} mm, the model has {found} mm.</source>
        <translation>图纸标注 {stated} mm，模型为 {found} mm。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>A short line of the drawing runs in a direction that no line of the part near it has: a small rounding or chamfer may be missing.</source>
        <translation>图纸上有一条短线，其方向与零件附近的任何线都不一致：可能缺少小圆角或倒角。</translation>
    </message>
    <message>
        <source>Features put together by what they explain</source>
        <translation>按解释效果组合的特征</translation>
    </message>
    <message>
        <source>No solid has all lines as they were read. This part, put together of {count} features, explains {percent} % of them. Check {canvas} which lines are wrong.</source>
        <translation>没有实体具有所读取的全部线条。此零件由 {count} 个特征组合而成，可解释其中的 {percent} %。请{canvas}检查哪些线条有误。</translation>
    </message>
    <message>
        <source>This part, put together of {count} features, has all lines of the drawing, but nothing proves that no other part has them. Compare it with the sheet.</source>
        <translation>此零件由 {count} 个特征组合而成，具有图纸的全部线条，但无法证明没有其他零件也具有这些线条。请与图纸对照。</translation>
    </message>
</context>
<context>
    <name>GaussianCADPreferences</name>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>引擎</translation>
    </message>
    <message>
        <source>Python of the engine</source>
        <translation>引擎的 Python</translation>
    </message>
    <message>
        <source>Names the Python in whose environment the engine is installed. If empty, GaussianCAD looks for its own environment.</source>
        <translation>指定安装了引擎的环境中的 Python。如果留空，GaussianCAD 会查找自己的环境。</translation>
    </message>
    <message>
        <source>If this is empty, GaussianCAD uses the environment that it installed itself, then the folder .venv beside the addon. GaussianCAD &gt; Check Engine shows which one was found.</source>
        <translation>如果此处留空，GaussianCAD 先使用自己安装的环境，再使用插件旁的 .venv 文件夹。GaussianCAD &gt; 检查引擎 会显示找到的是哪一个。</translation>
    </message>
    <message>
        <source>New Reconstructions</source>
        <translation>新的重建</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影画法</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>First angle</source>
        <translation>第一角画法</translation>
    </message>
    <message>
        <source>Third angle</source>
        <translation>第三角画法</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>精细</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Solid and surface</source>
        <translation>实体和表面</translation>
    </message>
    <message>
        <source>Solid only</source>
        <translation>仅实体</translation>
    </message>
    <message>
        <source>Surface only</source>
        <translation>仅表面</translation>
    </message>
    <message>
        <source>Folder for the engine&apos;s files</source>
        <translation>引擎文件的文件夹</translation>
    </message>
    <message>
        <source>Keeps the engine&apos;s files in a folder for each run. If empty, they are removed once the document holds the result.</source>
        <translation>将引擎的文件按每次运行保存在各自的文件夹中。如果留空，结果进入文档后这些文件即被删除。</translation>
    </message>
    <message>
        <source>Add the drawing&apos;s views as pictures around the part</source>
        <translation>将图纸各视图作为图片放在零件周围</translation>
    </message>
    <message>
        <source>The task panel begins with these settings, and then with those that were used last. A change here counts from the next time that the panel opens. Parts are made in millimetres; sizes are shown in the units that are set under General &gt; Units.</source>
        <translation>任务面板先使用这些设置，之后使用上次所用的设置。此处的更改在下次打开面板时生效。零件以毫米建立；尺寸按“常规 &gt; 单位”中设定的单位显示。</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Check</name>
    <message>
        <source>Check Against Drawing…</source>
        <translation>对照图纸检查…</translation>
    </message>
    <message>
        <source>Tells whether a part, body or mesh agrees with its drawing, and shows where it does not</source>
        <translation>判断零件、实体或网格是否与其图纸一致，并显示不一致之处</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_CheckEngine</name>
    <message>
        <source>Check Engine…</source>
        <translation>检查引擎…</translation>
    </message>
    <message>
        <source>Shows where the engine is, what it lacks and what to do about it</source>
        <translation>显示引擎的位置、缺少的内容以及处理办法</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Compare</name>
    <message>
        <source>Compare with Reference…</source>
        <translation>与参考比较…</translation>
    </message>
    <message>
        <source>Measures how far a part or mesh is from another one and colours the difference</source>
        <translation>测量零件或网格与另一个之间的差距，并为差异着色</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Correct</name>
    <message>
        <source>Correct Sheet…</source>
        <translation>校正图纸…</translation>
    </message>
    <message>
        <source>Shows what was understood of a drawing, lets it be corrected, and makes the part</source>
        <translation>显示从图纸读出的内容，可加以校正，并生成零件</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_FailedSheets</name>
    <message>
        <source>Open Failed Sheets…</source>
        <translation>打开失败的图纸…</translation>
    </message>
    <message>
        <source>Steps through the sheets of a batch that failed or are approximate</source>
        <translation>逐一查看批处理中失败或近似的图纸</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_InstallEngine</name>
    <message>
        <source>Install Engine…</source>
        <translation>安装引擎…</translation>
    </message>
    <message>
        <source>Downloads and installs the engine into an environment of its own</source>
        <translation>将引擎下载并安装到独立的环境中</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_LinesToSketches</name>
    <message>
        <source>Lines to Sketches…</source>
        <translation>图线转为草图…</translation>
    </message>
    <message>
        <source>Makes a sketch on its plane of the lines of each view, to model from by hand</source>
        <translation>把每个视图的图线做成位于其平面上的草图，供手工建模使用</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Reconstruct</name>
    <message>
        <source>Reconstruct from Drawing…</source>
        <translation>由图纸重建…</translation>
    </message>
    <message>
        <source>Creates a 3D part from a drawing with two or more views</source>
        <translation>由含有两个或更多视图的图纸创建三维零件</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Report</name>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Shows how far the part can be trusted, why, and what was read of the drawing</source>
        <translation>显示零件的可信程度、原因以及从图纸读到的内容</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_RunAgain</name>
    <message>
        <source>Run Again</source>
        <translation>再次运行</translation>
    </message>
    <message>
        <source>Reconstructs the drawing of what is selected again and updates the result</source>
        <translation>再次重建所选对象的图纸并更新结果</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_SheetNumbers</name>
    <message>
        <source>Sets all numbers of the body that the drawing tells back to the drawing&apos;s</source>
        <translation>把主体中图纸给出的所有尺寸恢复为图纸上的尺寸</translation>
    </message>
    <message>
        <source>Back to the Sheet&apos;s Numbers</source>
        <translation>恢复图纸上的尺寸</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_Solutions</name>
    <message>
        <source>Choose among Solutions…</source>
        <translation>在多个解中选择…</translation>
    </message>
    <message>
        <source>Flips through the solids that all have the drawing&apos;s lines and keeps one</source>
        <translation>逐一查看符合图纸线条的实体，并保留其中一个</translation>
    </message>
</context>
<context>
    <name>GaussianCAD_ToBody</name>
    <message>
        <source>To Body…</source>
        <translation>转换为主体…</translation>
    </message>
    <message>
        <source>Makes an editable body, with sketches, pads and holes, of the selected solid</source>
        <translation>由选中的实体生成可编辑的主体，包含草图、凸台和孔</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Turns drawings with three views into 3D parts</source>
        <translation>将三视图图纸转换为三维零件</translation>
    </message>
    <message>
        <source>GaussianCAD</source>
        <translation>GaussianCAD</translation>
    </message>
</context>
</TS>
